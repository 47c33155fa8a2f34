#include "io/brep/occt_session.h"
#include "io/morph/periodic_ranges.h"

#include <BRepCheck_Analyzer.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2dAPI_Interpolate.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Plane.hxx>
#include <QtTest>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_HArray1OfPnt2d.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

using namespace knead;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double radius = 3;

/// Of a circle in the plane, in its parameters, as splines that were fitted have it.
Handle(Geom2d_BSplineCurve) splineOnPlane(double first, double last)
{
    constexpr int count = 40;
    const Handle(TColgp_HArray1OfPnt2d) points = new TColgp_HArray1OfPnt2d(1, count);
    const Handle(TColStd_HArray1OfReal) parameters = new TColStd_HArray1OfReal(1, count);
    for (int i = 1; i <= count; ++i) {
        const double at = first + (last - first) * (i - 1) / (count - 1);
        points->SetValue(i, gp_Pnt2d(radius * std::cos(at), radius * std::sin(at)));
        parameters->SetValue(i, at);
    }
    Geom2dAPI_Interpolate fit(points, parameters, false, 1e-9);
    fit.Perform();
    return fit.Curve();
}

/// A disk of two half circles, the ranges of which begin at `begin`.
TopoDS_Face disk(double begin)
{
    const BRep_Builder builder;
    const Handle(Geom_Plane) plane = new Geom_Plane(gp_Ax3());
    const Handle(Geom_Circle) circle = new Geom_Circle(gp_Ax2(), radius);
    std::array<TopoDS_Vertex, 2> ends;
    for (std::size_t i = 0; i < 2; ++i)
        builder.MakeVertex(ends.at(i), circle->Value(begin + pi * static_cast<double>(i)), 1e-4);
    TopoDS_Face face;
    builder.MakeFace(face, plane, 1e-7);
    TopoDS_Wire wire;
    builder.MakeWire(wire);
    for (std::size_t i = 0; i < 2; ++i) {
        const double first = begin + pi * static_cast<double>(i);
        TopoDS_Edge edge;
        builder.MakeEdge(edge, circle, 1e-4);
        builder.Add(edge, ends.at(i).Oriented(TopAbs_FORWARD));
        builder.Add(edge, ends.at(1 - i).Oriented(TopAbs_REVERSED));
        builder.UpdateEdge(edge, splineOnPlane(first, first + pi), face, 1e-4);
        builder.Range(edge, first, first + pi);
        builder.SameRange(edge, true);
        builder.SameParameter(edge, true);
        builder.Add(wire, edge);
    }
    wire.Closed(true);
    builder.Add(face, wire);
    return face;
}

class PeriodicRangesTest : public QObject {
    Q_OBJECT

private slots:
    void circlesBeyondATurnAreBroughtBack_data()
    {
        QTest::addColumn<double>("begin");
        QTest::addColumn<double>("wanted");
        QTest::newRow("as it should be") << 0.5 << 0.5;
        QTest::newRow("a turn too far") << 2 * pi << 0.0;
        QTest::newRow("two turns and a bit") << 4 * pi + 1 << 1.0;
        QTest::newRow("a turn too little") << -2 * pi + 1 << 1.0;
    }

    void circlesBeyondATurnAreBroughtBack()
    {
        QFETCH(double, begin);
        QFETCH(double, wanted);
        const OcctSession session;
        const TopoDS_Face face = disk(begin);
        bringRangesIntoPeriod(face);
        QVERIFY(BRepCheck_Analyzer(face).IsValid());
        TopTools_IndexedMapOfShape edges;
        TopExp::MapShapes(face, TopAbs_EDGE, edges);
        double lowest = 1e9;
        for (int i = 1; i <= edges.Extent(); ++i) {
            const TopoDS_Edge edge = TopoDS::Edge(edges(i));
            double first = 0;
            double last = 0;
            const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
            double firstOnFace = 0;
            double lastOnFace = 0;
            const Handle(Geom2d_Curve) onFace = BRep_Tool::CurveOnSurface(edge, face, firstOnFace, lastOnFace);
            QVERIFY(std::abs(first - firstOnFace) < 1e-9 && std::abs(last - lastOnFace) < 1e-9);
            QVERIFY(std::abs(last - first - pi) < 1e-9);
            for (const double at : {first, 0.3 * first + 0.7 * last, last}) {
                const gp_Pnt2d place = onFace->Value(at);
                QVERIFY(curve->Value(at).Distance(gp_Pnt(place.X(), place.Y(), 0)) < 1e-5);
            }
            lowest = std::min(lowest, first);
        }
        QVERIFY(std::abs(lowest - wanted) < 1e-9);
    }
};

} // namespace

QTEST_GUILESS_MAIN(PeriodicRangesTest)
#include "periodic_ranges_test.moc"
