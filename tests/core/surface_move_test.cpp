#include "core/deformation/kept_faces.h"
#include "core/deformation/surface_move.h"
#include "core/geometry/mass_properties.h"
#include "core/geometry/refine.h"
#include "support/shapes.h"

#include <QtTest>

using namespace knead;

class SurfaceMoveTest : public QObject {
    Q_OBJECT

private slots:
    void aShiftIsTheSameEverywhere()
    {
        const TriangleMesh box = shapes::box(Vec3(1, 2, 3));
        std::vector<Vec3> places = box.vertices;
        for (Vec3& place : places)
            place += Vec3(0.3, 0, 0.4);
        const SurfaceMove move = surfaceMove(box, places);
        QVERIFY(std::abs(move.largest - 0.5) < 1e-12 && std::abs(move.mean - 0.5) < 1e-12);
    }

    /// Of u = z over a cube: 0 at the bottom, 1 on top, 1/2 on four sides.
    void theMeanIsByArea()
    {
        const TriangleMesh cube =
            refine(shapes::moved(shapes::box(Vec3(1, 1, 1)),
                                 {.position = Vec3(0, 0, 0.5), .rotation = Quaternion::Identity()}),
                   0.1);
        std::vector<Vec3> places = cube.vertices;
        for (Vec3& place : places)
            place.x() += place.z();
        const SurfaceMove move = surfaceMove(cube, places);
        QVERIFY(std::abs(move.largest - 1) < 1e-12);
        QCOMPARE(move.where.z(), 1.0);
        QVERIFY(std::abs(move.mean - 0.5) < 1e-12);
    }

    void nothingIsMovedByNothing() { QCOMPARE(surfaceMove({}, {}).mean, 0.0); }

    /// Faces of a box are rectangles of their own, with four corners each.
    void facesAreTakenOutOfAMesh()
    {
        const TriangleMesh box = shapes::box(Vec3(1, 2, 3));
        const TriangleMesh sides = facesOf(box, {0, 5});
        QCOMPARE(sides.triangles.size(), std::size_t(4));
        QCOMPARE(sides.vertices.size(), std::size_t(6)); // they meet in an edge
        QVERIFY(std::abs(massProperties(sides).area - (2 * 3 + 1 * 2)) < 1e-12);
        QVERIFY(facesOf(box, {}).empty() && facesOf(box, {17}).empty());

        const TriangleMesh twice = besides(sides, facesOf(box, {1}));
        QCOMPARE(twice.vertices.size(), std::size_t(10));
        QVERIFY(std::abs(massProperties(twice).area - (2 * 3 + 1 * 2 + 2 * 3)) < 1e-12);
        QVERIFY(besides({}, sides).triangles == sides.triangles);
    }
};

QTEST_APPLESS_MAIN(SurfaceMoveTest)
#include "surface_move_test.moc"
