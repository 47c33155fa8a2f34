#include "io/export/exact_part.h"

#include "core/geometry/mass_properties.h"
#include "core/geometry/refine.h"
#include "core/message/message.h"
#include "core/skin/former_shape.h"
#include "core/skin/skin_map.h"
#include "io/brep/tessellation.h"
#include "io/export/bent_faces.h"
#include "io/export/cut_shape.h"
#include "io/export/deformation_stages.h"
#include "io/export/faceted_solid.h"
#include "io/export/part_of_shape.h"
#include "io/export/surface_flaws.h"

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <gp_Trsf.hxx>

#include <algorithm>
#include <numeric>

namespace knead {

namespace {

constexpr double defaultTolerance = 1e-4;      // of the size of the part
constexpr std::size_t mostTriangles = 400'000; // of the surface that volumes are compared with
constexpr std::size_t wantedFacets = 10'000;
constexpr double flatness = 0.1;      // of the tolerance, by which corners may be off a flat face
constexpr double triangleEdges = 100; // across a part whose map has no spacing

/// Leaves everything where it is.
class InPlace final : public SmoothMap {
public:
    void evaluate(std::span<const Vec3> points, std::span<Vec3> places) const override
    {
        std::copy(points.begin(), points.end(), places.begin());
    }
    double featureSize() const override { return 1; }
};

/// What the objects of a part make of it.
std::shared_ptr<const SmoothMap> mapOfObjects(const PartToExport& part)
{
    if (part.map != nullptr)
        return part.map;
    const bool moved = std::any_of(part.displacements.begin(), part.displacements.end(),
                                   [](const Vec3& displacement) { return displacement != Vec3::Zero(); });
    if (part.aggregate == nullptr || (!moved && !part.aggregate->former))
        return std::make_shared<InPlace>();
    if (part.slit != nullptr)
        return std::make_shared<SlitMap>(*part.aggregate, *part.slit, part.displacements);
    return std::make_shared<SkinMap>(*part.aggregate, part.displacements);
}

/// [m]
double toleranceOf(const PartToExport& part, const ExportOptions& options)
{
    return options.tolerance > 0 ? options.tolerance : defaultTolerance * part.part.box.diagonal().norm();
}

bool isInPlace(const SmoothMap& map)
{
    return dynamic_cast<const InPlace*>(&map) != nullptr;
}

std::shared_ptr<const SmoothMap> mapOf(const PartToExport& part)
{
    std::shared_ptr<const SmoothMap> own = mapOfObjects(part);
    if (part.deformed == nullptr)
        return own;
    if (isInPlace(*own))
        return part.deformed;
    return std::make_shared<const ChainedMap>(std::vector{own, part.deformed});
}

/// A surface of a part, fine enough to bend with the objects as far as the number of triangles allows.
TriangleMesh refined(const PartToExport& part, const TriangleMesh& rest, std::size_t most)
{
    const double own = part.part.box.diagonal().norm() / triangleEdges;
    if (part.map == nullptr && part.aggregate != nullptr && part.aggregate->former)
        return carriedSurface(rest, *part.aggregate->former, part.aggregate->lattice.spacing, most).mesh;
    if (part.map != nullptr || (part.aggregate == nullptr && part.deformed != nullptr))
        return refine(rest, own, most);
    return part.aggregate == nullptr ? rest : refine(rest, part.aggregate->lattice.spacing, most);
}

/// What a closed surface holds once it is carried [m^3]. Chords cut volume off in proportion to the square of their length:
/// where the triangles could not be as fine as wanted, halving their edges says how much.
double volumeOf(const SmoothMap& map, const TriangleMesh& rest, const TriangleMesh& now)
{
    const double volume = massProperties(now).volume;
    if (now.triangles.size() < mostTriangles)
        return volume;
    return volume + 4.0 / 3 * (massProperties(carried(map, halveEdges(rest))).volume - volume);
}

/// A closed surface of flat faces, as few as describe the part: CAD programs are slow with many.
/// @param source its exact shape; null for a mesh
TriangleMesh facetsOf(const PartToExport& part, const SmoothMap& map, const TopoDS_Shape& source)
{
    TriangleMesh rest = part.part.mesh;
    if (!source.IsNull()) {
        TriangleMesh coarse = tessellate(BRepBuilderAPI_Copy(source, false).Shape(),
                                         {facetDeflection * part.part.box.diagonal().norm(), facetAngle});
        if (isWatertight(coarse) && coarse.triangles.size() < rest.triangles.size())
            rest = std::move(coarse);
    }
    TriangleMesh facets = carried(map, refined(part, rest, wantedFacets));
    if (facets.triangles.size() > mostFacets)
        throw Problem(
            Message("Export",
                    "\"%1\" would need %2 flat faces, more than CAD programs can work with; export it as a mesh.")
                .with(part.part.name, facets.triangles.size()));
    return facets;
}

TopoDS_Shape inMillimetres(const TopoDS_Shape& shape, double unit)
{
    const double factor = 1e3 * unit;
    if (std::abs(factor - 1) < 1e-12)
        return shape;
    gp_Trsf scale;
    scale.SetScaleFactor(factor);
    return BRepBuilderAPI_Transform(shape, scale, true).Shape();
}

void makeFaceted(const PartToExport& part, const Message& reason, ReadyPart& ready)
{
    ready.next.reset();
    const FacetedSolid solid =
        facetedSolid(facetsOf(part, *ready.map, ready.source), flatness * ready.report.tolerance);
    ready.out.shape = solid.shape;
    ready.source.Nullify();
    ready.notes.clear(); // of what was tried before
    ready.origin.clear();
    ready.report.keptFaces = 0;
    ready.report.form = PartExportReport::Form::faceted;
    ready.report.tolerance = std::max(ready.report.tolerance, facetDeflection * part.part.box.diagonal().norm());
    ready.report.reason = reason;
    setFaces(part.part, solid.origin, ready.out);
}

/// @param shape [mm]
ReadyPart makeReadyAsIs(const PartToExport& part, const TopoDS_Shape& shape, const ExportOptions& options,
                        const FaceChoice& choice, TaskControl& control)
{
    ReadyPart ready;
    ready.out.name = part.part.name;
    ready.out.color = part.part.color;
    ready.out.layer = part.part.layer;
    ready.out.visible = part.part.visible;
    ready.map = mapOf(part);

    ready.findsForms = part.deformed != nullptr;

    PartExportReport& report = ready.report;
    report.name = part.part.name;
    report.remarks = part.remarks;
    report.density = part.density;
    report.solidsBefore = part.part.solids;
    report.facesBefore = static_cast<int>(part.part.faces.size());
    report.edgesBefore = part.part.edges;
    report.restVolume = part.part.volume;
    if (part.before) {
        report.restVolume = part.before->volume;
        report.facesBefore = part.before->faces;
        report.edgesBefore = part.before->edges;
    }
    report.wasClosed = part.part.watertight;
    report.tolerance = toleranceOf(part, options);

    control.report(0, "bending the surface");
    const TriangleMesh rest = refined(part, part.part.mesh, mostTriangles);
    TriangleMesh now = carried(*ready.map, rest);
    // Triangles miss the volume of curved faces, in nearly the same measure before and after.
    const double restOfMesh = massProperties(part.part.mesh).volume;
    const double volume = part.part.watertight ? volumeOf(*ready.map, rest, now) : 0;
    report.skinVolume = restOfMesh > 0 ? volume * part.part.volume / restOfMesh : volume;
    control.throwIfCancelled();

    if (shape.IsNull() && !part.part.watertight)
        throw Problem(
            Message("Export", "\"%1\" is an open mesh, which CAD files cannot hold; hide it, or export as a mesh.")
                .with(part.part.name));
    if (shape.IsNull()) {
        makeFaceted(part,
                    part.reason.empty() ? Message("Export", "it came as a mesh, which has no smooth faces.")
                                        : part.reason,
                    ready);
        if (!isInPlace(*ready.map))
            noteCrossings(*ready.map, {&part.part.mesh, &rest}, now, control, report);
        else if (!part.reason.empty()) // of what has come apart, in its present place already
            noteCrossings(now, control, report);
        ready.skin = std::move(now);
        return ready;
    }
    const bool isMoved = !isInPlace(*ready.map);
    ready.source = shape;
    std::vector<std::uint32_t> own(part.part.faces.size());
    std::iota(own.begin(), own.end(), 0U);
    setFaces(part.part, own, ready.out);
    if (!isMoved) {
        ready.out.shape = part.part.watertight ? outward(ready.source) : ready.source;
        report.keptFaces = report.facesBefore;
        if (choice.firstFace > 0)
            putFaceFirst(part.part, choice.firstFace, ready);
        return ready;
    }
    noteCrossings(*ready.map, {&part.part.mesh, &rest}, now, control, report);
    TaskPortion bending(control, 0.2, 1);
    if (const Message reason = bendFaces(part, choice, bending, ready); !reason.empty())
        makeFaceted(part, reason, ready);
    noteFold(rest, now, report);
    if (report.form == PartExportReport::Form::faceted)
        ready.skin = std::move(now);
    else if (report.flatFaces > 0)
        ready.skin = skinOfFlatFaces(ready, now);
    return ready;
}

/// Deformations that are smooth only between planes get faces that end there, see inStages().
ReadyPart makeReadyInStages(const PartToExport& part, const TopoDS_Shape& shape, const ExportOptions& options,
                            const FaceChoice& choice, TaskControl& control)
{
    if (part.deformed == nullptr)
        return makeReadyAsIs(part, shape, options, choice, control);
    const std::shared_ptr<const SmoothMap> own = mapOfObjects(part);
    TaskPortion stages(control, 0, 0.2);
    const StagedPart last = inStages(part, shape, isInPlace(*own) ? nullptr : own, toleranceOf(part, options), stages);
    ExportOptions rest = options;
    if (last.isCarried)
        rest.tolerance = toleranceOf(part, options) / 2;
    TaskPortion making(control, 0.2, 1);
    return makeReadyAsIs(last.part, last.shape, rest, choice, making);
}

} // namespace

ReadyPart makeReady(const PartToExport& part, const TopoDS_Shape& shape, const ExportOptions& options,
                    const FaceChoice& choice, TaskControl& control)
{
    const TopoDS_Shape own = shape.IsNull() ? shape : inMillimetres(shape, part.part.exact->unit);
    if (own.IsNull())
        return makeReadyAsIs(part, own, options, choice, control);
    if (!part.cut && !part.slit)
        return makeReadyInStages(part, own, options, choice, control);
    if (const auto cut = part.slit ? slitShape(own, *part.slit) : cutShape(own, *part.cut)) {
        const PartToExport piece = withShape(part, cut->shape, cut->origin);
        if (piece.part.watertight)
            return makeReadyInStages(piece, cut->shape, options, choice, control);
    }
    PartToExport flat = part;
    flat.reason = Message("Export", "its faces could not be cut where the knife went.");
    return makeReadyAsIs(flat, {}, options, choice, control);
}

} // namespace knead
