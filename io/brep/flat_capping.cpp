#include "io/brep/flat_capping.h"

#include "core/message/message.h"
#include "io/brep/face_sewing.h"
#include "io/brep/free_edges.h"
#include "io/brep/shape_measure.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepLib.hxx>
#include <BRepLib_FindSurface.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <ShapeAnalysis_FreeBounds.hxx>
#include <TopTools_HSequenceOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace knead {

namespace {

constexpr double flatnessShare = 1e-5; // of the diagonal

/// The borders of all openings; nothing when one does not run back to its start.
Handle(TopTools_HSequenceOfShape) bordersOf(const TopoDS_Shape& shape)
{
    Handle(TopTools_HSequenceOfShape) edges = new TopTools_HSequenceOfShape;
    for (const TopoDS_Shape& edge : freeEdgesOf(shape))
        edges->Append(edge);
    Handle(TopTools_HSequenceOfShape) wires;
    const double tolerance = BRep_Tool::MaxTolerance(shape, TopAbs_VERTEX);
    ShapeAnalysis_FreeBounds::ConnectEdgesToWires(edges, tolerance, false, wires);
    for (const TopoDS_Shape& wire : *wires)
        if (!BRep_Tool::IsClosed(wire))
            return {};
    return wires;
}

/// The plane face in a border whose points are off the plane by no more than the flatness [mm].
std::optional<TopoDS_Face> planeIn(const TopoDS_Wire& border, double flatness)
{
    const BRepLib_FindSurface plane(border, flatness, true);
    if (!plane.Found())
        return std::nullopt;
    BRepBuilderAPI_MakeFace maker(plane.Surface(), border);
    if (!maker.IsDone())
        return std::nullopt;
    TopoDS_Face face = maker.Face();
    BRepLib::SameParameter(face, Precision::Confusion(),
                           true); // raises the tolerance where the border is off the plane
    return face;
}

} // namespace

std::optional<CadBody> capped(const CadBody& surface, TaskControl& control)
{
    const Handle(TopTools_HSequenceOfShape) borders = bordersOf(surface.shape);
    if (borders.IsNull() || borders->IsEmpty())
        return std::nullopt;
    const double flatness =
        std::max(BRep_Tool::MaxTolerance(surface.shape, TopAbs_VERTEX), flatnessShare * diagonalOf(surface.shape));
    TopoDS_Compound all;
    const BRep_Builder builder;
    builder.MakeCompound(all);
    builder.Add(all, surface.shape);
    for (const TopoDS_Shape& border : *borders) {
        control.throwIfCancelled();
        const std::optional<TopoDS_Face> cap = planeIn(TopoDS::Wire(border), flatness);
        if (!cap)
            return std::nullopt;
        builder.Add(all, *cap);
    }
    CadBody open = surface;
    open.shape = all;
    open.integrals.reset();
    std::optional<CadBody> result = sewnWith(open, flatness);
    if (!result || !freeEdgesOf(result->shape).IsEmpty())
        return std::nullopt;
    const double added = 1 - surface.measured().area / result->measured().area;
    const auto count = static_cast<std::size_t>(borders->Length());
    result->repairs = surface.repairs;
    const long percent = std::lround(100 * added);
    result->repairs.push_back(
        count == 1 ? Message("Repair", "1 flat opening was closed with a plane face, %1 % of the area.").with(percent)
                   : Message("Repair", "%1 flat openings were closed with plane faces, %2 % of the area.")
                         .with(count, percent));
    return result;
}

} // namespace knead
