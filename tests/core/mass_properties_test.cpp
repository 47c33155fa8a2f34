#include "core/geometry/mass_properties.h"
#include "support/shapes.h"

#include <QtTest>

using namespace knead;

class MassPropertiesTest : public QObject {
    Q_OBJECT

private slots:
    void boxHasItsClosedFormsAtAnyPlace()
    {
        const Pose pose = shapes::tilt(1.1, Vec3(5, -3, 8));
        const MassProperties properties = massProperties(shapes::moved(shapes::box(Vec3(1, 2, 3)), pose));
        QVERIFY(std::abs(properties.volume - 6) < 1e-13);
        QVERIFY(std::abs(properties.area - 22) < 1e-13);
        QVERIFY((properties.centroid - pose.position).norm() < 1e-13);
    }

    void torusOfManyFacetsComesCloseToPappus()
    {
        const MassProperties properties = massProperties(shapes::torus(3, 1, 800, 400));
        const double pi = std::numbers::pi;
        QVERIFY(std::abs(properties.volume / (2 * pi * pi * 3) - 1) < 1e-4);
        QVERIFY(std::abs(properties.area / (4 * pi * pi * 3) - 1) < 1e-4);
    }

    void voidsAreSubtracted()
    {
        const TriangleMesh hole = shapes::moved(shapes::box(Vec3(1, 1, 1)), {Vec3(1, 0, 0)});
        const MassProperties properties =
            massProperties(shapes::together(shapes::box(Vec3(4, 2, 2)), shapes::insideOut(hole)));
        QVERIFY(std::abs(properties.volume - 15) < 1e-13);
        QVERIFY((properties.centroid - Vec3(-1.0 / 15, 0, 0)).norm() < 1e-13);
        QVERIFY(properties.box.isApprox(Box(Vec3(-2, -1, -1), Vec3(2, 1, 1))));
    }

    void trianglesFacingInwardsGiveANegativeVolume()
    {
        QVERIFY(massProperties(shapes::insideOut(shapes::box(Vec3(1, 1, 1)))).volume < 0);
    }

    void verticesOfNoTriangleDoNotCount()
    {
        TriangleMesh mesh = shapes::box(Vec3(1, 1, 1));
        mesh.vertices.push_back(Vec3(50, 0, 0));
        QVERIFY(massProperties(mesh).box.max().x() < 1);
    }

    void closedSurfacesAreWatertight()
    {
        QVERIFY(isWatertight(shapes::box(Vec3(1, 2, 3))));
        QVERIFY(isWatertight(shapes::torus(3, 1, 20, 10)));
        QVERIFY(isWatertight(shapes::sphere(1, 20)));
        QVERIFY(isWatertight(shapes::cylinder(1, 3, 20)));
        QVERIFY(isWatertight(shapes::hollowBox(Vec3(3, 3, 3), Vec3(1, 1, 1))));
        QVERIFY(isWatertight(shapes::bracket(5, 1, 2)));
        QVERIFY(isWatertight(shapes::fork(5, 8, 2, 3, 1)));
    }

    void gapsDoublesAndFlipsAreNotWatertight()
    {
        QVERIFY(!isWatertight({}));
        TriangleMesh open = shapes::sphere(1, 12);
        open.triangles.erase(open.triangles.begin() + 7);
        QVERIFY(!isWatertight(open));
        TriangleMesh twice = shapes::sphere(1, 12);
        twice.triangles.push_back(twice.triangles[3]);
        QVERIFY(!isWatertight(twice));
        TriangleMesh flipped = shapes::sphere(1, 12);
        std::swap(flipped.triangles[3][0], flipped.triangles[3][1]);
        QVERIFY(!isWatertight(flipped));
    }
};

QTEST_GUILESS_MAIN(MassPropertiesTest)
#include "mass_properties_test.moc"
