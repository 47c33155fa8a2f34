#include "io/brep/healing.h"

#include "core/message/message.h"
#include "io/brep/body_check.h"
#include "io/brep/face_sewing.h"
#include "io/brep/flat_capping.h"
#include "io/brep/free_edges.h"
#include "io/brep/shape_measure.h"
#include "io/brep/solid_making.h"

#include <BRepCheck_Analyzer.hxx>
#include <BRepTools_ReShape.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <ShapeFix_Face.hxx>
#include <ShapeFix_Shape.hxx>
#include <ShapeFix_Wire.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>

#include <cmath>
#include <cstddef>
#include <optional>

namespace knead {

namespace {

constexpr double largestToleranceShare = 1e-3; // of the diagonal
constexpr double largestSize = 1e9;            // [mm]; what is larger is not worth healing
constexpr double sameMeasure = 1e-2;           // relative, of area and volume: a face that was wrong measures wrong too

bool hasSolid(const TopoDS_Shape& shape)
{
    return TopExp_Explorer(shape, TopAbs_SOLID).More();
}

bool isClose(double value, double expected)
{
    return std::abs(value - expected) <= sameMeasure * std::abs(expected);
}

/// Runs a step that may fail; what fails changes nothing.
template <typename Step>
auto attempt(Step step) -> decltype(step())
{
    try {
        return step();
    } catch (const Standard_Failure&) {
        return {};
    }
}

/// Sews and makes solids of what is open, or closed but no solid.
std::vector<CadBody> closed(const CadBody& body, bool capsFlatOpenings, TaskControl& control)
{
    CadBody surface = body;
    if (!freeEdgesOf(body.shape).IsEmpty())
        if (auto better = attempt([&] { return sewn(body, control); }))
            surface = std::move(*better);
    if (capsFlatOpenings && !freeEdgesOf(surface.shape).IsEmpty())
        if (auto better = attempt([&] { return capped(surface, control); }))
            surface = std::move(*better);
    std::vector<CadBody> bodies = attempt([&] { return solidsOf(surface); });
    if (bodies.empty())
        return {body};
    // A solid that cannot be closed stays as the file has it.
    if (hasSolid(body.shape) && (bodies.size() != 1 || !hasSolid(bodies.front().shape)))
        return {body};
    return bodies;
}

std::size_t countInvalidFaces(const TopoDS_Shape& shape, const BRepCheck_Analyzer& check)
{
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(shape, TopAbs_FACE, faces);
    std::size_t count = 0;
    for (int i = 1; i <= faces.Extent(); ++i)
        count += check.IsValid(faces(i)) ? 0 : 1;
    return count;
}

void followFaces(const CadBody& before, const Handle(BRepTools_ReShape) & changes, CadBody& after)
{
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(before.shape, TopAbs_FACE, faces);
    for (int i = 1; i <= faces.Extent(); ++i)
        for (TopExp_Explorer made(changes->Apply(faces(i)), TopAbs_FACE); made.More(); made.Next())
            if (!made.Current().IsSame(faces(i)))
                after.origins.Bind(made.Current(), before.originOf(faces(i)));
}

struct Rebuilding {
    TopoDS_Shape shape;
    Handle(BRepTools_ReShape) changes;
};

/// Rebuilds the faces that fail the checks and leaves the others alone.
Rebuilding rebuildFaces(const TopoDS_Shape& shape, const BRepCheck_Analyzer& check)
{
    Handle(ShapeBuild_ReShape) changes = new ShapeBuild_ReShape;
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(shape, TopAbs_FACE, faces);
    for (int i = 1; i <= faces.Extent(); ++i) {
        if (check.IsValid(faces(i)))
            continue;
        ShapeFix_Face fix(TopoDS::Face(faces(i)));
        fix.SetContext(changes);
        fix.SetMaxTolerance(largestToleranceShare * diagonalOf(shape));
        fix.FixWireTool()->FixIntersectingEdgesMode() = 1;
        fix.Perform();
        changes->Replace(faces(i), fix.Result());
    }
    return {changes->Apply(shape), changes};
}

Rebuilding rebuildAll(const TopoDS_Shape& shape)
{
    ShapeFix_Shape fix(shape);
    fix.SetMaxTolerance(largestToleranceShare * diagonalOf(shape));
    fix.FixWireTool()->FixIntersectingEdgesMode() = 1;
    fix.Perform();
    return {fix.Shape(), fix.Context()};
}

/// The body rebuilt, when it passes the checks then and is still the same body.
std::optional<CadBody> accepted(const CadBody& body, const Rebuilding& rebuilding)
{
    CadBody result = body;
    result.isValid = true;
    result.failure.reset();
    result.shape = rebuilding.shape;
    result.integrals.reset();
    if (result.shape.IsNull() || !BRepCheck_Analyzer(result.shape, true, true).IsValid())
        return std::nullopt;
    const FaceIntegrals before = body.measured();
    result.integrals = result.measured();
    const bool isSame = countDistinct(result.shape, TopAbs_SOLID) == countDistinct(body.shape, TopAbs_SOLID) &&
                        freeEdgesOf(result.shape).Extent() <= freeEdgesOf(body.shape).Extent() &&
                        isClose(result.integrals->area, before.area) &&
                        (!hasSolid(body.shape) || isClose(result.integrals->volume, before.volume));
    if (!isSame)
        return std::nullopt;
    followFaces(body, rebuilding.changes, result);
    return result;
}

/// A body that fails the checks, made to pass them: by as few changes as will do.
std::optional<CadBody> rebuilt(const CadBody& body, const BRepCheck_Analyzer& check)
{
    const std::size_t invalid = countInvalidFaces(body.shape, check);
    std::optional<CadBody> result;
    if (invalid > 0)
        result = attempt([&] { return accepted(body, rebuildFaces(body.shape, check)); });
    if (!result)
        result = attempt([&] { return accepted(body, rebuildAll(body.shape)); });
    if (result)
        result->repairs.push_back(
            invalid == 0   ? Message("Repair", "Edges that failed the geometry checks were rebuilt.")
            : invalid == 1 ? Message("Repair", "1 face that failed the geometry checks was rebuilt.")
                           : Message("Repair", "%1 faces that failed the geometry checks were rebuilt.").with(invalid));
    return result;
}

/// Makes the checks unless they are made.
CadBody checked(const CadBody& body, TaskControl& control)
{
    CadBody result = body;
    if (!result.isValid)
        checkBodies({&result}, control);
    if (result.failure)
        if (auto better = rebuilt(result, *result.failure))
            return std::move(*better);
    return result;
}

} // namespace

std::vector<CadBody> healed(const CadBody& body, bool capsFlatOpenings, TaskControl& control)
try {
    control.report(0, "healing parts");
    if (!(diagonalOf(body.shape) < largestSize))
        return {body};
    const bool isSolid = hasSolid(body.shape) && freeEdgesOf(body.shape).IsEmpty();
    std::vector<CadBody> bodies = isSolid ? std::vector<CadBody>{body} : closed(body, capsFlatOpenings, control);
    control.report(0.5, "checking parts");
    for (CadBody& one : bodies) {
        control.throwIfCancelled();
        one = checked(one, control);
    }
    return bodies;
} catch (const Standard_Failure&) {
    return {body};
}

} // namespace knead
