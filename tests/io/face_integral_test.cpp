#include "io/brep/face_integral.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <QtTest>
#include <TopoDS_Shape.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>
#include <gp_Trsf.hxx>
#include <tbb/global_control.h>

#include <cmath>
#include <numbers>

using namespace knead;
using std::numbers::pi;

namespace {

bool isClose(double value, double expected, double relative)
{
    return std::abs(value - expected) <= relative * std::abs(expected);
}

TopoDS_Shape asSplines(const TopoDS_Shape& shape)
{
    return BRepBuilderAPI_NurbsConvert(shape, true).Shape();
}

TopoDS_Shape tilted(const TopoDS_Shape& shape)
{
    gp_Trsf motion;
    motion.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 0.3)), 0.7);
    motion.SetTranslationPart(gp_Vec(1000, -500, 200));
    return BRepBuilderAPI_Transform(shape, motion, true).Shape();
}

} // namespace

class FaceIntegralTest : public QObject {
    Q_OBJECT

private slots:
    void bodiesHaveTheAreaAndVolumeOfTheirFormulas_data();
    void bodiesHaveTheAreaAndVolumeOfTheirFormulas();
    void twoCylindersThatCrossLackTheVolumeOfSteinmetz();
    void smoothWaistIsIntegratedAcrossManyKnots();
    void turnedShapeHasNegativeVolume();
    void endlessFaceIsInfinite();
    void anyNumberOfThreadsGivesTheSameBits();
};

void FaceIntegralTest::bodiesHaveTheAreaAndVolumeOfTheirFormulas_data()
{
    QTest::addColumn<TopoDS_Shape>("shape");
    QTest::addColumn<double>("area");
    QTest::addColumn<double>("volume");
    const double slant = std::hypot(10, 3);
    QTest::newRow("box") << BRepPrimAPI_MakeBox(2, 3, 5).Shape() << 62.0 << 30.0;
    QTest::newRow("cylinder") << BRepPrimAPI_MakeCylinder(3, 10).Shape() << 2 * pi * 3 * 13 << pi * 90;
    QTest::newRow("cone") << BRepPrimAPI_MakeCone(5, 2, 10).Shape() << pi * (25 + 4 + 7 * slant) << pi * 10 / 3 * 39;
    QTest::newRow("sphere") << BRepPrimAPI_MakeSphere(5).Shape() << 100 * pi << 500 * pi / 3;
    QTest::newRow("torus") << BRepPrimAPI_MakeTorus(20, 4).Shape() << 4 * pi * pi * 80 << 2 * pi * pi * 320;
}

void FaceIntegralTest::bodiesHaveTheAreaAndVolumeOfTheirFormulas()
{
    QFETCH(TopoDS_Shape, shape);
    QFETCH(double, area);
    QFETCH(double, volume);
    for (const TopoDS_Shape& one : {shape, tilted(shape)}) {
        QVERIFY(isClose(faceIntegralsOf(one).area, area, 1e-9));
        QVERIFY(isClose(faceIntegralsOf(one).volume, volume, 1e-9));
        const FaceIntegrals ofSplines = faceIntegralsOf(asSplines(one));
        QVERIFY2(isClose(ofSplines.area, area, 1e-5), qPrintable(QString::number(ofSplines.area / area - 1)));
        QVERIFY2(isClose(ofSplines.volume, volume, 1e-5), qPrintable(QString::number(ofSplines.volume / volume - 1)));
    }
}

void FaceIntegralTest::twoCylindersThatCrossLackTheVolumeOfSteinmetz()
{
    const TopoDS_Shape bar = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, -20), gp_Dir(0, 0, 1)), 5, 40).Shape();
    const TopoDS_Shape hole = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(-20, 0, 0), gp_Dir(1, 0, 0)), 5, 40).Shape();
    const double expected = pi * 25 * 40 - 16.0 / 3 * 125;
    const double volume = faceIntegralsOf(BRepAlgoAPI_Cut(bar, hole).Shape()).volume;
    QVERIFY2(isClose(volume, expected, 1e-5), qPrintable(QString::number(volume / expected - 1)));
}

/// A loft through circles is a waist r(z) = 5 + cos(z/3) to the precision of the spline, which seventy sections make far
/// better than what is asked for.
void FaceIntegralTest::smoothWaistIsIntegratedAcrossManyKnots()
{
    const auto loft = [](int sections) {
        BRepOffsetAPI_ThruSections through(true, false, 1e-7);
        through.CheckCompatibility(false);
        for (int i = 0; i < sections; ++i) {
            const double z = 20.0 * i / (sections - 1);
            const gp_Circ circle(gp_Ax2(gp_Pnt(0, 0, z), gp_Dir(0, 0, 1)), 5 + std::cos(z / 3));
            through.AddWire(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(circle)).Wire());
        }
        return through.Shape();
    };
    // Integral of pi (5 + cos(z/3))^2 from 0 to 20.
    const double expected = pi * (25 * 20 + 30 * std::sin(20.0 / 3) + 10 + 0.75 * std::sin(40.0 / 3));
    const double volume = faceIntegralsOf(loft(70)).volume;
    QVERIFY2(isClose(volume, expected, 1e-5), qPrintable(QString::number(volume / expected - 1)));
}

void FaceIntegralTest::turnedShapeHasNegativeVolume()
{
    const TopoDS_Shape torus = BRepPrimAPI_MakeTorus(20, 4).Shape();
    const FaceIntegrals outward = faceIntegralsOf(torus);
    const FaceIntegrals inward = faceIntegralsOf(torus.Reversed());
    QCOMPARE(inward.area, outward.area);
    QCOMPARE(inward.volume, -outward.volume);
}

void FaceIntegralTest::endlessFaceIsInfinite()
{
    const TopoDS_Shape plane = BRepBuilderAPI_MakeFace(gp_Pln()).Shape();
    QVERIFY(std::isinf(faceIntegralsOf(plane).area));
}

void FaceIntegralTest::anyNumberOfThreadsGivesTheSameBits()
{
    const TopoDS_Shape shape = asSplines(
        BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(20, 20, 20).Shape(), BRepPrimAPI_MakeTorus(12, 4).Shape()).Shape());
    const FaceIntegrals onAll = faceIntegralsOf(shape);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    QCOMPARE(faceIntegralsOf(shape).area, onAll.area);
    QCOMPARE(faceIntegralsOf(shape).volume, onAll.volume);
}

QTEST_GUILESS_MAIN(FaceIntegralTest)
#include "face_integral_test.moc"
