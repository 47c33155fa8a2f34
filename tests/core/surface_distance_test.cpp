#include "core/geometry/surface_distance.h"
#include "support/shapes.h"

#include <QtTest>

#include <random>

using namespace knead;

namespace {

class Places {
public:
    Vec3 next(double radius) { return Vec3(number(), number(), number()) * radius; }

private:
    double number() { return 2.0 * (m_random() % 100003) / 100003 - 1; }
    std::minstd_rand m_random{5};
};

/// Distance to one triangle by dense trial: the least of many points of it, from above within the trial's step.
double distanceByTrial(const TriangleMesh& mesh, const TriangleMesh::Triangle& t, const Vec3& place)
{
    double least = 1e300;
    constexpr int steps = 60;
    for (int i = 0; i <= steps; ++i)
        for (int j = 0; i + j <= steps; ++j) {
            const Vec3 point = mesh.vertices[t[0]] + (mesh.vertices[t[1]] - mesh.vertices[t[0]]) * i / steps +
                               (mesh.vertices[t[2]] - mesh.vertices[t[0]]) * j / steps;
            least = std::min(least, (point - place).norm());
        }
    return least;
}

double boxDistance(const Vec3& halfSize, const Vec3& place)
{
    const Vec3 beyond = place.cwiseAbs() - halfSize;
    return beyond.cwiseMax(0).norm() + std::min(0.0, beyond.maxCoeff());
}

} // namespace

class SurfaceDistanceTest : public QObject {
    Q_OBJECT

private slots:
    void signedDistanceToABoxIsTheClosedForm()
    {
        const TriangleMesh mesh = shapes::box(Vec3(2, 4, 3));
        const SurfaceDistance surface(mesh);
        Places places;
        for (int i = 0; i < 3000; ++i) {
            const Vec3 place = places.next(4);
            const SurfaceDistance::Hit hit = surface.nearest(place);
            const double expected = boxDistance(Vec3(1, 2, 1.5), place);
            QVERIFY(std::abs(hit.signedDistance - expected) < 1e-13);
            QVERIFY(std::abs((hit.point - place).norm() - hit.distance) < 1e-13);
        }
    }

    void treeFindsTheBestOfAllTriangles()
    {
        const TriangleMesh mesh = shapes::moved(shapes::torus(3, 1, 31, 17), shapes::tilt(0.4));
        const SurfaceDistance surface(mesh);
        std::vector<TriangleMesh> single(mesh.triangles.size());
        std::vector<SurfaceDistance> alone;
        for (std::size_t t = 0; t < single.size(); ++t) {
            single[t] = {mesh.vertices, {mesh.triangles[t]}, {}};
            alone.emplace_back(single[t]);
        }
        Places places;
        for (int i = 0; i < 100; ++i) {
            const Vec3 place = places.next(5);
            double least = 1e300;
            for (const SurfaceDistance& triangle : alone)
                least = std::min(least, triangle.nearest(place).distance);
            const SurfaceDistance::Hit hit = surface.nearest(place);
            QCOMPARE(hit.distance, least);
            QCOMPARE(alone[hit.triangle].nearest(place).distance, least);
        }
    }

    void reachAndGuessChangeOnlyTheTime()
    {
        // Of a box many points are equally far from several triangles: which one is named may not depend on the guess.
        for (const TriangleMesh& mesh : {shapes::moved(shapes::torus(3, 1, 62, 34), shapes::tilt(0.4)),
                                         shapes::box(Vec3(4, 4, 4)), shapes::cylinder(1, 5, 200)}) {
            const SurfaceDistance surface(mesh);
            const auto triangles = static_cast<std::uint32_t>(mesh.triangles.size());
            Places places;
            int near = 0;
            for (int i = 0; i < 1000; ++i) {
                const Vec3 place = i % 2 == 0 ? places.next(5) : Vec3(places.next(5).array().round());
                const SurfaceDistance::Hit hit = surface.nearest(place);
                constexpr double reach = 0.7;
                const auto within = surface.nearestWithin(reach, place, static_cast<std::uint32_t>(i) % triangles);
                QCOMPARE(within.has_value(), hit.distance <= reach);
                if (!within)
                    continue;
                QCOMPARE(within->triangle, hit.triangle);
                QCOMPARE(within->signedDistance, hit.signedDistance);
                QVERIFY(within->point == hit.point);
                ++near;
            }
            QVERIFY(near > 50 && near < 950);
        }
    }

    void distanceToATriangleIsTheLeastOverItsPoints()
    {
        Places places;
        for (int i = 0; i < 300; ++i) {
            TriangleMesh mesh{{places.next(1), places.next(1), places.next(1)}, {{0, 1, 2}}, {}};
            if (i % 10 == 0)
                mesh.vertices[2] = (mesh.vertices[0] + mesh.vertices[1]) / 2;
            const SurfaceDistance surface(mesh);
            const Vec3 place = places.next(1.5);
            const double trial = distanceByTrial(mesh, mesh.triangles[0], place);
            const double distance = surface.nearest(place).distance;
            QVERIFY(distance <= trial + 1e-12);
            QVERIFY(distance >= trial - 0.03);
        }
    }

    void signIsRightAtSharpEdgesAndCorners()
    {
        // A needle-sharp tip: for most points near it the nearest point is the tip itself, where the normals of single
        // triangles disagree about inside and outside.
        const TriangleMesh mesh = shapes::prism({{0, 0}, {10, -0.3}, {10, 0.3}}, 1);
        const SurfaceDistance surface(mesh);
        Places places;
        for (int i = 0; i < 2000; ++i) {
            const Vec3 place = places.next(2);
            const bool inside =
                place.x() > 0 && std::abs(place.y()) < 0.03 * place.x() && place.z() > 0 && place.z() < 1;
            QCOMPARE(surface.nearest(place).signedDistance < 0, inside);
        }
    }

    void voidsAreOutside()
    {
        const TriangleMesh mesh = shapes::hollowBox(Vec3(4, 4, 4), Vec3(2, 2, 2));
        const SurfaceDistance surface(mesh);
        QCOMPARE(surface.nearest(Vec3(0.1, 0.2, 0)).signedDistance, 0.8);
        QCOMPARE(surface.nearest(Vec3(1.4, 0.2, 0)).signedDistance, -0.4);
        QCOMPARE(surface.nearest(Vec3(3.4, 0.2, 0)).signedDistance, 1.4);
    }

    void emptyMeshIsRefused()
    {
        const TriangleMesh mesh;
        QVERIFY_EXCEPTION_THROWN(SurfaceDistance{mesh}, std::invalid_argument);
    }
};

QTEST_GUILESS_MAIN(SurfaceDistanceTest)
#include "surface_distance_test.moc"
