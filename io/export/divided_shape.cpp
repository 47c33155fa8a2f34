#include "io/export/divided_shape.h"

#include <BRepCheck_Analyzer.hxx>
#include <BRep_Tool.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <ShapeFix_Shape.hxx>
#include <ShapeUpgrade_ShapeDivideClosed.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include <numeric>

namespace knead {

namespace {

DividedShape asItIs(const TopoDS_Shape& shape)
{
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(shape, TopAbs_FACE, faces);
    DividedShape same{shape, std::vector<std::uint32_t>(static_cast<std::size_t>(faces.Extent()))};
    std::iota(same.origin.begin(), same.origin.end(), 0U);
    return same;
}

} // namespace

bool hasClosedFaces(const TopoDS_Shape& shape)
{
    for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next())
        for (TopExp_Explorer edge(face.Current(), TopAbs_EDGE); edge.More(); edge.Next())
            if (BRep_Tool::IsClosed(TopoDS::Edge(edge.Current()), TopoDS::Face(face.Current())))
                return true;
    return false;
}

DividedShape withoutClosedFaces(const TopoDS_Shape& shape)
{
    try {
        ShapeUpgrade_ShapeDivideClosed divide(shape);
        divide.SetNbSplitPoints(1);
        if (!divide.Perform())
            return asItIs(shape);
        ShapeFix_Shape fix; // dividing a face leaves small errors behind
        fix.SetContext(divide.GetContext());
        fix.Init(divide.Result());
        fix.Perform();
        DividedShape result{fix.Shape(), {}};
        TopTools_IndexedMapOfShape before;
        TopTools_IndexedMapOfShape after;
        TopExp::MapShapes(shape, TopAbs_FACE, before);
        TopExp::MapShapes(result.shape, TopAbs_FACE, after);
        result.origin.resize(static_cast<std::size_t>(after.Extent()));
        int found = 0;
        for (int i = 1; i <= before.Extent(); ++i)
            for (TopExp_Explorer piece(fix.Context()->Apply(before(i)), TopAbs_FACE); piece.More(); piece.Next())
                if (const int index = after.FindIndex(piece.Current()); index > 0) {
                    result.origin[static_cast<std::size_t>(index - 1)] = static_cast<std::uint32_t>(i - 1);
                    ++found;
                }
        if (found != after.Extent() || !BRepCheck_Analyzer(result.shape).IsValid())
            return asItIs(shape);
        return result;
    } catch (const Standard_Failure&) {
        return asItIs(shape);
    }
}

bool hasBoredClosedFaces(const TopoDS_Shape& shape)
{
    for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next()) {
        int wires = 0;
        for (TopExp_Explorer found(faces.Current(), TopAbs_WIRE); found.More(); found.Next())
            ++wires;
        int poles = 0;
        bool hasBorder = false; // a hole across the seam is part of the wire that has the poles
        for (TopExp_Explorer edges(faces.Current(), TopAbs_EDGE); edges.More(); edges.Next()) {
            const TopoDS_Edge edge = TopoDS::Edge(edges.Current());
            const bool isPole = BRep_Tool::Degenerated(edge);
            poles += isPole ? 1 : 0;
            hasBorder = hasBorder || (!isPole && !BRep_Tool::IsClosed(edge, TopoDS::Face(faces.Current())));
        }
        if (poles == 2 && hasBorder && wires <= 2)
            return true;
    }
    return false;
}

} // namespace knead
