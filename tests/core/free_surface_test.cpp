#include "core/geometry/refine.h"
#include "core/mechanics/stress_law.h"
#include "core/skin/free_surface.h"
#include "support/shapes.h"

#include <QtTest>

#include <cmath>

using namespace knead;

namespace {

constexpr double nu = 0.3;

/// Linear elasticity: E = 1.
Mat3 strainOf(const Mat3& stress)
{
    return (1 + nu) * stress - nu * stress.trace() * Mat3::Identity();
}

Mat3 someStress()
{
    Mat3 stress;
    stress << 3, 0.5, -0.2, 0.5, -1, 0.8, -0.2, 0.8, 0.7;
    return stress;
}

} // namespace

class FreeSurfaceTest : public QObject {
    Q_OBJECT

private slots:
    void boxHasFacesEdgesAndCorners()
    {
        const Vec3 size(0.03, 0.02, 0.01);
        const TriangleMesh mesh = refine(shapes::box(size), 0.004);
        const std::vector<FreeSurface> surfaces = freeSurfaces(mesh);
        std::array<int, 3> count{};
        for (std::size_t v = 0; v < surfaces.size(); ++v) {
            const Vec3 outside = (mesh.vertices[v].cwiseAbs() - size / 2).array().abs().matrix();
            const auto sides = (outside.array() < 1e-9).count();
            QCOMPARE(surfaces[v].kind, sides == 1   ? FreeSurface::Kind::face
                                       : sides == 2 ? FreeSurface::Kind::edge
                                                    : FreeSurface::Kind::none);
            ++count[static_cast<std::size_t>(sides - 1)];
            Eigen::Index axis = 0;
            if (sides == 1) {
                outside.minCoeff(&axis);
                QVERIFY(surfaces[v].direction[axis] * mesh.vertices[v][axis] > 0);
            }
            if (sides == 2)
                outside.maxCoeff(&axis);
            if (sides < 3)
                QVERIFY(std::abs(std::abs(surfaces[v].direction[axis]) - 1) < 1e-9);
        }
        QVERIFY(count[0] > 50 && count[1] > 50);
        QCOMPARE(count[2], 8);
    }

    void facetsOfACylinderAreRound()
    {
        const TriangleMesh mesh = shapes::cylinder(0.01, 0.03, 24);
        const std::vector<FreeSurface> surfaces = freeSurfaces(mesh);
        int edges = 0;
        for (std::size_t v = 0; v < surfaces.size(); ++v)
            if (surfaces[v].kind == FreeSurface::Kind::edge) {
                ++edges;
                const Vec3 radial = Vec3(mesh.vertices[v].x(), mesh.vertices[v].y(), 0);
                QVERIFY(std::abs(surfaces[v].direction.dot(radial.normalized())) < 0.05);
                QVERIFY(std::abs(surfaces[v].direction.z()) < 0.05);
            }
        QCOMPARE(edges, 48);
    }

    /// A pipe is hollow inside by about one over its radius, in the mean over facets, and nowhere else.
    void boresAreHollowByTheirRadius()
    {
        for (const double longest : {1.0, 0.0011, 0.0006}) {
            TriangleMesh mesh = shapes::cylinder(0.004, 0.03, 24);
            for (TriangleMesh::Triangle& triangle : mesh.triangles) // a hole through everything
                std::swap(triangle[0], triangle[1]);
            mesh = refine(mesh, longest);
            const std::vector<FreeSurface> surfaces = freeSurfaces(mesh);
            std::vector<double> area(mesh.vertices.size(), 0);
            for (const auto& [a, b, c] : mesh.triangles)
                for (const std::uint32_t v : {a, b, c})
                    area[v] += (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).norm();
            int found = 0;
            double sum = 0;
            double all = 0;
            for (std::size_t v = 0; v < surfaces.size(); ++v) {
                const double inEnds = 0.015 - std::abs(mesh.vertices[v].z());
                if (longest < 1 && inEnds > 0.002) {
                    const double share = 0.004 * surfaces[v].hollow;
                    sum += area[v] * share;
                    all += area[v];
                    ++found;
                }
                if (longest < 0.001 && inEnds < 1e-9 && mesh.vertices[v].head<2>().norm() < 0.0015)
                    QCOMPARE(surfaces[v].hollow, 0.0);
            }
            if (longest < 1)
                qInfo("%g mm: %.3f of 1 / radius in the mean", 1e3 * longest, sum / all);
            QVERIFY(longest == 1 || (found > 100 && std::abs(sum / all - 1) < 0.25));
            for (TriangleMesh::Triangle& triangle : mesh.triangles) // and a shaft is not
                std::swap(triangle[0], triangle[1]);
            for (const FreeSurface& surface : freeSurfaces(mesh))
                QVERIFY(surface.hollow < 1e-6 / 0.004);
        }
    }

    /// The inner edge of a bracket goes inwards: nothing is taken off there.
    void edgesThatGoInwardsAreNotFree()
    {
        const TriangleMesh mesh = refine(shapes::bracket(0.03, 0.01, 0.01), 0.003);
        const std::vector<FreeSurface> surfaces = freeSurfaces(mesh);
        const Box box = [&] {
            Box all;
            for (const Vec3& vertex : mesh.vertices)
                all.extend(vertex);
            return all;
        }();
        int inner = 0;
        for (std::size_t v = 0; v < surfaces.size(); ++v) {
            const Vec3 low = mesh.vertices[v] - box.min();
            const bool isInner = std::abs(low.x() - 0.01) < 1e-9 && std::abs(low.y() - 0.01) < 1e-9;
            if (isInner) {
                QCOMPARE(surfaces[v].kind, FreeSurface::Kind::none);
                const bool isInside = low.z() > 1e-9 && mesh.vertices[v].z() < box.max().z() - 1e-9;
                QVERIFY(!isInside || std::isinf(surfaces[v].hollow));
                ++inner;
            }
        }
        QVERIFY(inner > 2);
    }

    /// The traction is gone, and the strain along the surface is as before.
    void tractionGoesAndStrainAlongTheSurfaceStays()
    {
        const Vec3 n = Vec3(1, 2, -0.5).normalized();
        const Mat3 along = Mat3::Identity() - n * n.transpose();
        const Mat3 free = withoutTraction(someStress(), {FreeSurface::Kind::face, n}, nu);
        QVERIFY((free * n).norm() < 1e-12);
        QVERIFY((along * (strainOf(free) - strainOf(someStress())) * along).norm() < 1e-12);
    }

    void anEdgeIsStretchedAlongItselfOnly()
    {
        const Vec3 e = Vec3(1, 2, -0.5).normalized();
        const Mat3 free = withoutTraction(someStress(), {FreeSurface::Kind::edge, e}, nu);
        QVERIFY((free - e.dot(free * e) * e * e.transpose()).norm() < 1e-12);
        QVERIFY(std::abs(e.dot((strainOf(free) - strainOf(someStress())) * e)) < 1e-12);
    }

    void whatIsNotFreeKeepsItsStress()
    {
        const FreeSurface face{FreeSurface::Kind::face, Vec3::UnitX()};
        QVERIFY((withoutTraction(someStress(), {}, nu) - someStress()).norm() == 0);
        QVERIFY((withoutTraction(someStress(), face, nu, 0) - someStress()).norm() == 0);
        const Mat3 half = withoutTraction(someStress(), face, nu, 0.5);
        QVERIFY((half - 0.5 * (someStress() + withoutTraction(someStress(), face, nu))).norm() < 1e-12);
    }

    /// A normal stays across what lies in the surface, an edge goes with the material.
    void directionsGoWithTheMaterial()
    {
        Mat3 gradient;
        gradient << 1.2, 0.4, 0, -0.1, 0.9, 0.3, 0.2, 0, 1.1;
        const Vec3 n = Vec3(1, -1, 2).normalized();
        const Vec3 a = n.unitOrthogonal();
        const Vec3 b = n.cross(a);
        const FreeSurface face = moved({FreeSurface::Kind::face, n}, gradient);
        QVERIFY(std::abs(face.direction.norm() - 1) < 1e-12);
        QVERIFY(std::abs(face.direction.dot(gradient * a)) < 1e-12);
        QVERIFY(std::abs(face.direction.dot(gradient * b)) < 1e-12);
        QVERIFY(face.direction.dot(gradient * n) > 0);
        const FreeSurface edge = moved({FreeSurface::Kind::edge, a}, gradient);
        QVERIFY((edge.direction - (gradient * a).normalized()).norm() < 1e-12);
    }
};

QTEST_APPLESS_MAIN(FreeSurfaceTest)
#include "free_surface_test.moc"
