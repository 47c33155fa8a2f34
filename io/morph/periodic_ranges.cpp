#include "io/morph/periodic_ranges.h"

#include <BRep_Builder.hxx>
#include <BRep_GCurve.hxx>
#include <BRep_ListIteratorOfListOfCurveRepresentation.hxx>
#include <BRep_TEdge.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <GeomLib.hxx>
#include <Geom_Curve.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Vertex.hxx>

#include <cmath>

namespace knead {

namespace {

/// By how many periods the range of an edge lies off the first one, as a length of parameters; negative: below it.
double excessOf(const TopoDS_Edge& edge)
{
    TopLoc_Location location;
    double first = 0;
    double last = 0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, location, first, last);
    if (curve.IsNull() || !curve->IsPeriodic())
        return 0;
    constexpr double almost = 1e-9; // of a period
    return curve->Period() * std::floor((first - curve->FirstParameter()) / curve->Period() + almost);
}

void lower(BRep_GCurve& curve, double excess)
{
    double first = 0;
    double last = 0;
    curve.Range(first, last);
    const auto lowered = [&](const Handle(Geom2d_Curve) & before) {
        Handle(Geom2d_Curve) after;
        GeomLib::SameRange(1e-9, before, first, last, first - excess, last - excess, after);
        return after;
    };
    if (curve.IsCurveOnSurface())
        curve.PCurve(lowered(curve.PCurve()));
    if (curve.IsCurveOnClosedSurface())
        curve.PCurve2(lowered(curve.PCurve2()));
    curve.SetRange(first - excess, last - excess);
}

/// Those between its ends, which know where on it they are.
void lowerInnerVertices(const TopoDS_Edge& edge, double excess)
{
    for (TopoDS_Iterator child(edge); child.More(); child.Next()) {
        const TopoDS_Vertex vertex = TopoDS::Vertex(child.Value());
        if (vertex.Orientation() == TopAbs_INTERNAL || vertex.Orientation() == TopAbs_EXTERNAL)
            BRep_Builder().UpdateVertex(vertex, BRep_Tool::Parameter(vertex, edge) - excess, edge,
                                        BRep_Tool::Tolerance(vertex));
    }
}

} // namespace

void bringRangesIntoPeriod(const TopoDS_Shape& shape)
{
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(shape, TopAbs_EDGE, edges);
    for (int i = 1; i <= edges.Extent(); ++i) {
        const TopoDS_Edge edge = TopoDS::Edge(edges(i));
        const double excess = excessOf(edge);
        if (excess == 0)
            continue;
        const Handle(BRep_TEdge) data = Handle(BRep_TEdge)::DownCast(edge.TShape());
        lowerInnerVertices(edge, excess);
        for (BRep_ListIteratorOfListOfCurveRepresentation each(data->ChangeCurves()); each.More(); each.Next())
            if (const Handle(BRep_GCurve) curve = Handle(BRep_GCurve)::DownCast(each.Value()); !curve.IsNull())
                lower(*curve, excess);
    }
}

} // namespace knead
