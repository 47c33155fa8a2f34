#include "core/aggregate/fill.h"
#include "core/geometry/surface_distance.h"
#include "core/simulation/scene.h"
#include "support/shapes.h"

#include <QtTest>

#include <algorithm>

using namespace knead;

class SceneTest : public QObject {
    Q_OBJECT

private slots:
    void anAlignedFaceHoldsItsOwnLayer()
    {
        const double a = 0.002;
        const TriangleMesh mesh = shapes::box(Vec3(8, 6, 10) * a);
        const Aggregate aggregate = fill(mesh, {.spacing = a});
        const std::vector<ObjectIndex> held = objectsAtFaces(aggregate, mesh, {4});
        QCOMPARE(held.size(), std::size_t{9 * 7});
        for (const ObjectIndex object : held)
            QVERIFY(std::abs(aggregate.lattice.position(object).z() + 5 * a) < 1e-12);
    }

    void severalFacesHoldTheUnionOfTheirLayers()
    {
        const TriangleMesh mesh = shapes::box(Vec3(8, 6, 10));
        const Aggregate aggregate = fill(mesh, {.spacing = 1});
        QCOMPARE(objectsAtFaces(aggregate, mesh, {0, 4}).size(), std::size_t{9 * 7 + 11 * 7 - 7});
        QCOMPARE(objectsAtFaces(aggregate, mesh, {0, 1, 2, 3, 4, 5}).size(), std::size_t{9 * 7 * 11 - 7 * 5 * 9});
    }

    void objectsBeyondATiltedFaceAreHeldToo()
    {
        const Pose pose = shapes::tilt(0.6);
        const TriangleMesh mesh = shapes::moved(shapes::box(Vec3(8, 9, 16)), pose);
        const Aggregate aggregate = fill(mesh, {.spacing = 1});
        const std::vector<ObjectIndex> held = objectsAtFaces(aggregate, mesh, {5});
        QVERIFY(std::is_sorted(held.begin(), held.end()));
        for (ObjectIndex i = 0; i < aggregate.size(); ++i) {
            const Vec3 local = pose.toLocal(aggregate.lattice.position(i));
            const bool overFace = std::abs(local.x()) < 4 && std::abs(local.y()) < 4.5;
            const bool isHeld = std::binary_search(held.begin(), held.end(), i);
            if (overFace) // within half a spacing, or outside: a kept cell does not reach further than 1.5
                QCOMPARE(isHeld, local.z() >= 8 - 0.5);
            if (local.z() < 8 - 1.5)
                QVERIFY(!isHeld);
        }
    }

    void meshesWithoutFacesHoldNothing()
    {
        const TriangleMesh mesh = shapes::torus(3, 1, 30, 20);
        const Aggregate aggregate = fill(mesh, {.spacing = 0.3});
        QVERIFY(objectsAtFaces(aggregate, mesh, {0}).empty());
        const TriangleMesh box = shapes::box(Vec3(1, 1, 1));
        QVERIFY(objectsAtFaces(fill(box, {.spacing = 0.5}), box, {}).empty());
    }

    void bordersOfABoxBelongToIt()
    {
        const double a = 0.1 / 3;
        const Aggregate aggregate = fill(shapes::box(Vec3(12, 9, 15) * a), {.spacing = a});
        const std::vector<ObjectIndex> inside =
            objectsInBox(aggregate, Box(Vec3(-6, -4.5, -7.5) * a, Vec3(-4, 4.5, -5.5) * a));
        QCOMPARE(inside.size(), std::size_t{3 * 10 * 3});
        QVERIFY(objectsInBox(aggregate, Box()).empty());
        QCOMPARE(objectsInBox(aggregate, Box(Vec3::Constant(-1), Vec3::Constant(1))).size(), aggregate.size());
    }
};

QTEST_GUILESS_MAIN(SceneTest)
#include "scene_test.moc"
