#include "io/morph/brep_morph.h"

#include "io/morph/millimetre_map.h"
#include "io/morph/morph_tolerances.h"
#include "io/morph/periodic_ranges.h"
#include "io/morph/topology_copy.h"

#include <BRepCheck_Analyzer.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>

namespace knead {

namespace {

constexpr double widestVertex = 0.005; // of the size of the shape

/// The faces that the checks find fault with.
std::vector<std::uint32_t> invalidFacesOf(const MorphedShape& shape)
{
    std::vector<std::uint32_t> faulty;
    const BRepCheck_Analyzer check(shape.shape, true, true);
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(shape.shape, TopAbs_FACE, faces);
    for (int i = 1; i <= faces.Extent(); ++i)
        if (!check.IsValid(faces(i)))
            faulty.push_back(shape.origin[static_cast<std::size_t>(i - 1)]);
    return faulty;
}

double extentOf(const TopTools_IndexedMapOfShape& vertices)
{
    Box box;
    for (int i = 1; i <= vertices.Extent(); ++i)
        box.extend(toVec3(BRep_Tool::Pnt(TopoDS::Vertex(vertices(i))).XYZ()));
    return box.isEmpty() ? 0 : box.diagonal().norm();
}

} // namespace

MorphedShape morphShape(const TopoDS_Shape& shape, const SmoothMap& map, const MorphOptions& options,
                        TaskControl& control)
{
    const MillimetreMap millimetres(map);
    TopologyCopy copy(shape, millimetres, options);
    TaskPortion geometry(control, 0, 0.85);
    copy.computeGeometry(geometry);
    MorphedShape result;
    result.shape = copy.build(control);
    result.origin = copy.originsIn(result.shape);
    for (const MorphedFace& face : copy.faceResults()) {
        const bool isFlat = copy.isFlat(static_cast<int>(result.notes.size()) + 1);
        const MorphedFaceKind kind = isFlat ? MorphedFaceKind::flat : face.kind;
        result.notes.push_back({kind, face.error, face.worst, face.converged, face.poles, face.problem});
    }
    for (std::uint32_t i = 0; i < result.notes.size(); ++i)
        if (result.notes[i].kind == MorphedFaceKind::failed)
            result.faulty.push_back(i);
    if (!result.faulty.empty())
        return result;
    control.throwIfCancelled();
    control.report(0.85, "measuring tolerances");
    bringRangesIntoPeriod(result.shape);
    result.largestEdgeTolerance = raiseTolerances(result.shape);
    copy.markSmoothEdges();
    control.throwIfCancelled();
    control.report(0.9, "checking");
    TopTools_IndexedMapOfShape vertices;
    TopExp::MapShapes(result.shape, TopAbs_VERTEX, vertices);
    result.isValid = widenVertices(result.shape, widestVertex * extentOf(vertices), result.widenedVertices);
    if (!result.isValid)
        result.faulty = invalidFacesOf(result);
    control.report(1, "checking");
    return result;
}

} // namespace knead
