#include "support/thread_limit.h"

#include "core/geometry/wall_thickness.h"
#include "support/shapes.h"

#include <QtTest>

using namespace knead;

namespace {

bool isClose(double value, double expected, double relative)
{
    return std::abs(value / expected - 1) <= relative;
}

/// A right-angled wedge: its thick end is `height` high.
TriangleMesh wedge(double length, double height, double width)
{
    return shapes::prism({{0, 0}, {length, 0}, {length, height}}, width);
}

class Cancelling : public TaskControl {
public:
    void report(double, std::string_view) override {}
    bool isCancelled() const override { return true; }
};

} // namespace

class WallThicknessTest : public QObject {
    Q_OBJECT

private slots:
    void wallsAreAsThickAsTheyAreMade_data()
    {
        QTest::addColumn<TriangleMesh>("mesh");
        QTest::addColumn<double>("thinnest");
        QTest::newRow("plate") << shapes::box(Vec3(0.3, 40, 30)) << 0.3;
        QTest::newRow("cube") << shapes::box(Vec3(2, 2, 2)) << 2.0;
        QTest::newRow("box") << shapes::box(Vec3(2, 3, 5)) << 2.0;
        QTest::newRow("ball") << shapes::sphere(1.5, 100) << 3.0;
        QTest::newRow("rod") << shapes::cylinder(0.5, 20, 100) << 1.0;
        QTest::newRow("ring") << shapes::torus(10, 0.4, 200, 60) << 0.8;
        QTest::newRow("ball shell") << shapes::together(shapes::sphere(5, 200),
                                                        shapes::insideOut(shapes::sphere(4.8, 200)))
                                    << 0.2;
        QTest::newRow("bracket") << shapes::bracket(30, 2, 20) << 2.0;
    }
    void wallsAreAsThickAsTheyAreMade()
    {
        QFETCH(TriangleMesh, mesh);
        QFETCH(double, thinnest);
        for (const TriangleMesh& turned :
             {mesh, shapes::moved(mesh, shapes::tilt(0.8, Vec3(3, 4, 5))), shapes::insideOut(mesh)}) {
            const WallThickness found = wallThickness(turned);
            QVERIFY2(isClose(found.thinnest, thinnest, 0.01), qPrintable(QString::number(found.thinnest)));
        }
    }

    void thinnerPartOfAPlateIsFound()
    {
        // Two legs of 3 and 0.5: a third of the plate is thin.
        const TriangleMesh mesh = shapes::prism({{20, 3}, {0, 3}, {0, 0}, {30, 0}, {30, 0.5}, {20, 0.5}}, 25);
        const WallThickness found = wallThickness(mesh);
        QVERIFY2(isClose(found.thinnest, 0.5, 1e-6), qPrintable(QString::number(found.thinnest)));
        QVERIFY2(isClose(found.typical, 3, 1e-6), qPrintable(QString::number(found.typical)));
        QVERIFY(found.wallShare > 0.9);
    }

    void twoFinsOfALargeBlockDoNotDecide()
    {
        // 0.6 % of the area belongs to the small box: it is no figure for the whole.
        const TriangleMesh mesh = shapes::together(shapes::box(Vec3(10, 10, 10)),
                                                   shapes::moved(shapes::box(Vec3(0.1, 1.3, 1.3)), {Vec3(20, 0, 0)}));
        QVERIFY(isClose(wallThickness(mesh).thinnest, 10, 1e-6));
    }

    void bladeIsAsThinAsTwoPercentOfItsArea()
    {
        // Rays from a face of length L at the distance s from the edge are s tan(angle) long, from the sloped face s sin(angle).
        const double angle = std::atan(0.1);
        const double area = 10 * (10 + std::sqrt(101.0) + 1) + 2 * 5;
        const double tips = 0.02 * area / 10; // along both faces together
        const double expected = tips / (1 / std::tan(angle) + 1 / std::tan(angle));
        const WallThickness found = wallThickness(wedge(10, 1, 10));
        QVERIFY2(isClose(found.thinnest, expected, 0.1), qPrintable(QString::number(found.thinnest / expected)));
    }

    void edgesOfASteepWedgeAreNoWalls()
    {
        // 45 degrees: only the triangular ends face each other.
        QVERIFY(isClose(wallThickness(wedge(10, 10, 7)).thinnest, 7, 1e-6));
    }

    void bodiesWithoutWallsAreAsThickAsTheBallInside()
    {
        TriangleMesh mesh; // a regular tetrahedron of edge 2 sqrt 2
        mesh.vertices = {Vec3(1, 1, 1), Vec3(1, -1, -1), Vec3(-1, 1, -1), Vec3(-1, -1, 1)};
        mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
        const WallThickness found = wallThickness(mesh);
        QCOMPARE(found.wallShare, 0.0);
        QVERIFY(isClose(found.thinnest, 2 / std::sqrt(3.0), 1e-9));
    }

    void sameForAnyNumberOfThreads()
    {
        const TriangleMesh mesh = shapes::moved(shapes::torus(3, 1, 90, 40), shapes::tilt(0.3));
        const WallThickness one = onThreads(1, [&] { return wallThickness(mesh); });
        for (const int threads : {2, 4}) {
            const WallThickness other = onThreads(threads, [&] { return wallThickness(mesh); });
            QCOMPARE(other.thinnest, one.thinnest);
            QCOMPARE(other.typical, one.typical);
            QCOMPARE(other.wallShare, one.wallShare);
        }
    }

    void measuringCanBeCancelled()
    {
        Cancelling control;
        QVERIFY_EXCEPTION_THROWN(wallThickness(shapes::sphere(1, 40), control), Cancelled);
    }

    void nothingHasNoWalls() { QCOMPARE(wallThickness({}).thinnest, 0.0); }
};

QTEST_GUILESS_MAIN(WallThicknessTest)
#include "wall_thickness_test.moc"
