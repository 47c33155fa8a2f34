#include "core/geometry/shape_fit.h"
#include "support/shapes.h"

#include <QtTest>

#include <cmath>
#include <numbers>
#include <numeric>

using namespace knead;

namespace {

std::vector<std::uint32_t> allOf(const TriangleMesh& mesh)
{
    std::vector<std::uint32_t> triangles(mesh.triangles.size());
    std::iota(triangles.begin(), triangles.end(), 0U);
    return triangles;
}

/// The side of a cylinder about z, without its ends, over an angle.
TriangleMesh side(double radius, double height, int pieces, double angle)
{
    TriangleMesh mesh;
    for (int i = 0; i <= pieces; ++i)
        for (const double z : {0.0, height})
            mesh.vertices.emplace_back(radius * std::cos(angle * i / pieces), radius * std::sin(angle * i / pieces), z);
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(2 * pieces); i += 2) {
        mesh.triangles.push_back({i, i + 2, i + 3});
        mesh.triangles.push_back({i, i + 3, i + 1});
    }
    return mesh;
}

TriangleMesh cap(double radius, double reach)
{
    TriangleMesh mesh;
    constexpr int rings = 6;
    constexpr std::uint32_t around = 24;
    mesh.vertices.emplace_back(0, 0, radius);
    for (int ring = 1; ring <= rings; ++ring)
        for (std::uint32_t i = 0; i < around; ++i) {
            const double polar = reach * ring / rings;
            const double turn = 2 * std::numbers::pi * i / around;
            mesh.vertices.emplace_back(radius * std::sin(polar) * std::cos(turn),
                                       radius * std::sin(polar) * std::sin(turn), radius * std::cos(polar));
        }
    for (std::uint32_t i = 0; i < around; ++i)
        mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % around});
    for (std::uint32_t ring = 0; ring + 1 < rings; ++ring)
        for (std::uint32_t i = 0; i < around; ++i) {
            const std::uint32_t a = 1 + ring * around + i;
            const std::uint32_t b = 1 + ring * around + (i + 1) % around;
            mesh.triangles.push_back({a, a + around, b + around});
            mesh.triangles.push_back({a, b + around, b});
        }
    return mesh;
}

} // namespace

/// Circles, planes, cylinders and balls that are known beforehand.
class ShapeFitTest : public QObject {
    Q_OBJECT

private slots:
    void threePlacesMakeTheirCircle()
    {
        const Vec3 center(0.3, -0.2, 0.5);
        const Quaternion turn = Quaternion(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()));
        const auto at = [&](double angle) {
            return Vec3(center + turn * Vec3(2 * std::cos(angle), 2 * std::sin(angle), 0));
        };
        const auto circle = circleThrough(at(0.1), at(0.9), at(4));
        QVERIFY(circle.has_value());
        QVERIFY(std::abs(circle->radius - 2) < 1e-12);
        QVERIFY((circle->center - center).norm() < 1e-12);
        QVERIFY(std::abs(std::abs(circle->normal.dot(turn * Vec3::UnitZ())) - 1) < 1e-12);
    }

    void placesOnALineMakeNoCircle()
    {
        QVERIFY(!circleThrough(Vec3(0, 0, 0), Vec3(1, 1, 1), Vec3(3, 3, 3)));
        QVERIFY(!circleThrough(Vec3(0, 0, 0), Vec3(0, 0, 0), Vec3(3, 3, 3)));
    }

    void smallAnglesAreExact()
    {
        QVERIFY(std::abs(angleBetween(Vec3(1, 0, 0), Vec3(1, 1e-9, 0)) - 1e-9) < 1e-20);
        QCOMPARE(angleBetween(Vec3(1, 0, 0), Vec3(-2, 0, 0)), std::numbers::pi);
    }

    void nearestPlaceOfATriangleLiesInEveryRegion()
    {
        const std::array<Vec3, 3> t{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
        QCOMPARE(nearestShares(t, Vec3(-1, -1, 2)), Vec3(1, 0, 0));
        QCOMPARE(nearestShares(t, Vec3(2, -1, 2)), Vec3(0, 1, 0));
        QCOMPARE(nearestShares(t, Vec3(-1, 2, 2)), Vec3(0, 0, 1));
        QVERIFY(nearestShares(t, Vec3(0.5, -1, 2)).isApprox(Vec3(0.5, 0.5, 0)));
        QVERIFY(nearestShares(t, Vec3(1, 1, 2)).isApprox(Vec3(0, 0.5, 0.5)));
        QVERIFY(nearestShares(t, Vec3(-1, 0.25, 2)).isApprox(Vec3(0.75, 0, 0.25)));
        QVERIFY(nearestShares(t, Vec3(0.2, 0.3, 5)).isApprox(Vec3(0.5, 0.2, 0.3)));
    }

    void aPlaneSaysHowFlatItIs()
    {
        TriangleMesh mesh = side(1, 1, 1, 1); // two triangles: flat
        PlaneFit fit = fitPlane(mesh, allOf(mesh), mesh.vertices);
        QVERIFY(fit.deviation < 1e-15);
        QVERIFY(std::abs(fit.normal.dot(Vec3(std::cos(0.5), std::sin(0.5), 0)) - 1) < 1e-12);
        mesh.vertices[0].x() += 0.1;
        fit = fitPlane(mesh, allOf(mesh), mesh.vertices);
        QVERIFY(fit.deviation > 0.02 && fit.deviation < 0.1);
    }

    /// Chords do not make it smaller: its vertices lie on it.
    void aHoleHasItsRadius()
    {
        for (const double angle : {2 * std::numbers::pi, 1.0}) {
            TriangleMesh mesh = side(0.0045, 0.008, 9, angle);
            const Pose pose{Vec3(0.05, 0.014, 0), Quaternion(Eigen::AngleAxisd(1, Vec3(2, 1, 0).normalized()))};
            mesh = shapes::moved(mesh, pose);
            const auto fit = fitRound(mesh, allOf(mesh), mesh.vertices, mesh.vertices.size());
            QVERIFY(fit.has_value());
            QCOMPARE(fit->form, RoundFit::Form::cylinder);
            QVERIFY(std::abs(fit->radius / 0.0045 - 1) < 1e-9);
            QVERIFY(std::abs(std::abs(fit->axis.dot(pose.rotation * Vec3::UnitZ())) - 1) < 1e-12);
            QVERIFY(fit->deviation < 1e-12);
        }
    }

    void aCapOfABallHasItsRadius()
    {
        for (const double reach : {0.3, 1.5}) {
            const TriangleMesh mesh = cap(0.02, reach);
            const auto fit = fitRound(mesh, allOf(mesh), mesh.vertices, mesh.vertices.size());
            QVERIFY(fit.has_value());
            QCOMPARE(fit->form, RoundFit::Form::ball);
            QVERIFY(std::abs(fit->radius / 0.02 - 1) < 1e-9);
            QVERIFY(fit->center.norm() < 1e-10);
        }
    }

    void whatIsFlatHasNoRadius()
    {
        const TriangleMesh mesh = side(1, 1, 1, 1);
        QVERIFY(!fitRound(mesh, allOf(mesh), mesh.vertices, mesh.vertices.size()));
    }
};

QTEST_GUILESS_MAIN(ShapeFitTest)
#include "shape_fit_test.moc"
