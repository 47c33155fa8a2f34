#include "io/export/exact_part.h"

#include "core/geometry/mass_properties.h"
#include "core/geometry/refine.h"
#include "core/skin/former_shape.h"
#include "core/skin/skin_map.h"
#include "io/export/cut_shape.h"
#include "io/export/divided_shape.h"
#include "io/export/faceted_solid.h"
#include "io/export/surface_flaws.h"
#include "io/face_integral.h"
#include "io/tessellation.h"

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <gp_Trsf.hxx>

#include <algorithm>
#include <numeric>
#include <set>
#include <stdexcept>

namespace knead {

namespace {

constexpr double defaultTolerance = 1e-4;      // of the size of the part
constexpr std::size_t mostTriangles = 400'000; // of the surface that volumes are compared with
constexpr double facetDeflection = 1.0 / 400;  // of the size of a part that is written as flat faces
constexpr double facetAngle = 0.35;            // [rad]
constexpr std::size_t wantedFacets = 10'000;
constexpr std::size_t mostFacets = 60'000;
constexpr double flatness = 0.1;  // of the tolerance, by which corners may be off a flat face
constexpr double flatShare = 0.4; // of what single flat faces may be off, that their triangles are drawn with
constexpr double leastSide =
    1.0 / 150; // of the size, to which their triangles are divided however short the map's features are
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

std::shared_ptr<const SmoothMap> mapOf(const PartToExport& part)
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

/// A surface of a part, fine enough to bend with the objects as far as the number of triangles allows.
TriangleMesh refined(const PartToExport& part, const TriangleMesh& rest, std::size_t most)
{
    if (part.map == nullptr && part.aggregate == nullptr)
        return rest;
    if (part.map == nullptr && part.aggregate->former)
        return carriedSurface(rest, *part.aggregate->former, part.aggregate->lattice.spacing, most).mesh;
    const double edge =
        part.map == nullptr ? part.aggregate->lattice.spacing : part.part.box.diagonal().norm() / triangleEdges;
    return refine(rest, edge, most);
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
        throw std::runtime_error("\"" + part.part.name + "\" would need " + std::to_string(facets.triangles.size()) +
                                 " flat faces, more than CAD programs can work with; export it as a mesh.");
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

/// Why the faces of a shape cannot be used; empty when they can.
std::string whyNot(const MorphedShape& shape)
{
    const auto isFailed = [](const MorphedFaceNote& note) { return note.kind == MorphedFaceKind::failed; };
    const auto failed = std::count_if(shape.notes.begin(), shape.notes.end(), isFailed);
    if (failed > 0) {
        const auto first = std::find_if(shape.notes.begin(), shape.notes.end(), isFailed);
        return std::to_string(failed) + " of its faces could not be carried along: " + first->problem + ".";
    }
    if (!shape.isValid)
        return "its faces do not fit together any more as they are bent now.";
    return {};
}

/// @param origin per face that is written: which of the part it is of
void addFaceColors(const Part& part, const std::vector<std::uint32_t>& origin, CadPartToWrite& out)
{
    out.faceColors.clear();
    for (const std::uint32_t face : origin)
        out.faceColors.push_back(face < part.faces.size() ? part.faces[face].color : std::nullopt);
}

void makeFaceted(const PartToExport& part, const std::string& reason, ReadyPart& ready)
{
    ready.next.reset();
    const FacetedSolid solid =
        facetedSolid(facetsOf(part, *ready.map, ready.source), flatness * ready.report.tolerance);
    ready.out.shape = solid.shape;
    ready.source.Nullify();
    ready.report.form = PartExportReport::Form::faceted;
    ready.report.tolerance = std::max(ready.report.tolerance, facetDeflection * part.part.box.diagonal().norm());
    ready.report.reason = reason;
    addFaceColors(part.part, solid.origin, ready.out);
}

/// Divides the faces of the source that close in themselves. @return false when there are none
bool divideClosedFaces(const PartToExport& part, ReadyPart& ready)
{
    const DividedShape divided = withoutClosedFaces(ready.source);
    const std::size_t added = divided.origin.size() - part.part.faces.size();
    if (divided.origin.size() <= part.part.faces.size())
        return false;
    ready.source = divided.shape;
    ready.originOfDivided = divided.origin;
    addFaceColors(part.part, divided.origin, ready.out);
    ready.report.remarks.push_back(std::to_string(added) + (added == 1 ? " face was" : " faces were") +
                                   " added: those that close in themselves came in two, which other programs read "
                                   "more surely.");
    return true;
}

/// A closed shape with its outside outside.
TopoDS_Shape outward(const TopoDS_Shape& shape)
{
    return faceIntegralsOf(shape).volume < 0 ? shape.Reversed() : shape;
}

/// What came of bending faces.
struct Bent {
    std::string reason;                ///< why they cannot be used; empty when they can
    std::vector<std::uint32_t> faulty; ///< those of the source because of which, as far as known
};

/// Carries the faces of the source through the map.
/// @param flat those that are to be triangles
Bent bend(ReadyPart& ready, TaskControl& control, const std::set<std::uint32_t>& flat = {},
          const DrawingFineness& flatFineness = {})
{
    PartExportReport& report = ready.report;
    const MorphOptions options{.tolerance = 1e3 * report.tolerance, .flat = flat, .flatFineness = flatFineness};
    MorphedShape morphed = morphShape(ready.source, *ready.map, options, control);
    if (const std::string reason = whyNot(morphed); !reason.empty())
        return {reason, morphed.faulty};
    report.keptFaces =
        static_cast<int>(std::count_if(morphed.notes.begin(), morphed.notes.end(),
                                       [](const MorphedFaceNote& note) { return note.kind == MorphedFaceKind::kept; }));
    ready.notes = std::move(morphed.notes);
    ready.origin = std::move(morphed.origin);
    ready.out.shape = outward(morphed.shape);
    return {};
}

/// What a face of the source is of, in the part.
std::uint32_t originOf(std::uint32_t face, const ReadyPart& ready)
{
    return ready.manner == FaceManner::own ? face : ready.originOfDivided[face];
}

/// "faces 3, 7 and 12"
std::string facesInWords(const std::set<std::uint32_t>& faces)
{
    constexpr std::size_t mostNamed = 8;
    std::string words = faces.size() == 1 ? "face" : "faces";
    std::size_t named = 0;
    for (const std::uint32_t face : faces)
        if (++named <= mostNamed)
            words += (named == 1 ? " " : ", ") + std::to_string(face);
    return faces.size() > mostNamed ? words + ", ..." : words;
}

/// Bends the faces of the source but for some, in whose place triangles come that end at the smooth ones beside them.
/// @return what came of it; triangles may be at fault, too
Bent bendAround(const PartToExport& part, const std::set<std::uint32_t>& flat, const std::string& why,
                TaskControl& control, ReadyPart& ready)
{
    PartExportReport& report = ready.report;
    const double size = part.part.box.diagonal().norm();
    const double allowed = std::max(report.tolerance, facetDeflection * size);
    const DrawingFineness fineness{.deflection = 1e3 * flatShare * allowed,
                                   .angle = facetAngle,
                                   .longestSide = 1e3 * std::max(ready.map->featureSize(), leastSide * size),
                                   .shortestSide = 1e3 * leastSide * size / 2};
    Bent bent;
    try {
        bent = bend(ready, control, flat, fineness);
    } catch (const Cancelled&) {
        throw;
    } catch (const std::runtime_error& error) {
        return {error.what(), {}};
    }
    if (!bent.reason.empty())
        return bent;
    if (ready.origin.size() > mostFacets)
        return {"too many triangles would be needed.", {}};
    report.flatFaces = static_cast<int>(flat.size());
    report.flatTolerance = allowed;
    report.reason = why;
    report.remarks.push_back("\"" + report.name + "\": " + facesInWords(flat) + (flat.size() == 1 ? " is" : " are") +
                             " made of flat triangles; its other faces are smooth.");
    std::vector<std::uint32_t> origin; // in the part
    for (const std::uint32_t face : ready.origin)
        origin.push_back(originOf(face, ready));
    addFaceColors(part.part, origin, ready.out);
    ready.next = FaceManner::flat;
    return bent;
}

/// Adds a face, and the other half of it where it was divided.
void addWhole(std::uint32_t face, const ReadyPart& ready, std::set<std::uint32_t>& faces)
{
    faces.insert(face);
    for (std::uint32_t other = 0; ready.manner != FaceManner::own && other < ready.originOfDivided.size(); ++other)
        if (originOf(other, ready) == originOf(face, ready))
            faces.insert(other);
}

/// The part of a skin that flat faces stand for.
/// @param skin numbered by the faces of the part
TriangleMesh skinOfFlatFaces(const ReadyPart& ready, const TriangleMesh& skin)
{
    std::set<std::uint32_t> flat;
    for (std::uint32_t face = 0; face < ready.notes.size(); ++face)
        if (ready.isFlat(face))
            flat.insert(originOf(face, ready));
    TriangleMesh patch{.vertices = skin.vertices, .triangles = {}, .faceOfTriangle = {}};
    for (std::size_t t = 0; t < skin.triangles.size(); ++t)
        if (flat.contains(skin.faceOfTriangle[t]))
            patch.triangles.push_back(skin.triangles[t]);
    return patch;
}

/// Faces that failed, or made the solid invalid, become triangles; so do those that fail beside them then.
/// @return whether there is a solid
bool bendAroundFaulty(const PartToExport& part, Bent last, TaskControl& control, ReadyPart& ready)
{
    constexpr int mostRounds = 3;
    std::set<std::uint32_t> flat;
    const std::string why = last.reason;
    for (int round = 0; round < mostRounds; ++round) {
        const std::size_t before = flat.size();
        for (const std::uint32_t face : last.faulty)
            addWhole(face, ready, flat);
        if (flat.size() == before)
            return false;
        last = bendAround(part, flat, why, control, ready);
        if (last.reason.empty())
            return true;
    }
    return false;
}

/// Its own faces bent, divided where that is needed, some of them flat where nothing else goes, or all flat.
void makeBent(const PartToExport& part, const FaceChoice& choice, TaskControl& control, ReadyPart& ready)
{
    // What cannot be divided is better smooth and misread by some than flat.
    const bool isMisread = choice.from == FaceManner::own && hasBoredClosedFaces(ready.source) &&
                           withoutClosedFaces(ready.source).origin.size() > part.part.faces.size();
    ready.manner = isMisread ? FaceManner::divided : choice.from;
    ready.next =
        ready.manner == FaceManner::own && hasClosedFaces(ready.source) ? FaceManner::divided : FaceManner::flat;
    std::string reason = choice.reason;
    Bent bent;
    if (!choice.flat.empty() && !isMisread) {
        if (ready.manner == FaceManner::divided)
            divideClosedFaces(part, ready);
        if (bendAroundFaulty(part, {reason, choice.flat}, control, ready))
            return;
        makeFaceted(part, reason, ready);
        return;
    }
    if (ready.manner == FaceManner::own) {
        TaskPortion portion(control, 0, 0.4);
        bent = bend(ready, portion);
        if (bent.reason.empty())
            return;
        reason = bent.reason;
    }
    if (ready.manner != FaceManner::flat && divideClosedFaces(part, ready)) {
        ready.manner = FaceManner::divided;
        ready.next = FaceManner::flat;
        TaskPortion portion(control, 0.4, 0.8);
        bent = bend(ready, portion);
        if (bent.reason.empty())
            return;
        reason = bent.reason;
    }
    TaskPortion portion(control, 0.8, 1);
    if (bendAroundFaulty(part, bent, portion, ready))
        return;
    if (ready.manner == FaceManner::divided)
        ready.report.remarks.pop_back();
    makeFaceted(part, reason, ready);
}

/// A piece with the faces of its part as knives cut them: as if it had come so.
PartToExport asCut(const PartToExport& part, const CutShape& cut)
{
    PartToExport piece = part;
    const TopoDS_Shape copy = BRepBuilderAPI_Copy(cut.shape, false).Shape();
    const double size = part.part.box.diagonal().norm();
    piece.part.mesh = tessellate(copy, {facetDeflection * size / 4, facetAngle});
    piece.part.watertight = isWatertight(piece.part.mesh);
    piece.part.volume = 1e-9 * std::abs(faceIntegralsOf(cut.shape).volume);
    piece.part.faces.clear();
    for (const std::uint32_t origin : cut.origin)
        piece.part.faces.push_back(origin < part.part.faces.size() ? part.part.faces[origin]
                                                                   : decltype(part.part.faces)::value_type{});
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(cut.shape, TopAbs_EDGE, edges);
    piece.part.edges = edges.Extent();
    return piece;
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
    report.tolerance = options.tolerance > 0 ? options.tolerance : defaultTolerance * part.part.box.diagonal().norm();

    control.report(0, "bending the surface");
    const TriangleMesh rest = refined(part, part.part.mesh, mostTriangles);
    TriangleMesh now = carried(*ready.map, rest);
    // Triangles miss the volume of curved faces, in nearly the same measure before and after.
    const double restOfMesh = massProperties(part.part.mesh).volume;
    const double volume = part.part.watertight ? volumeOf(*ready.map, rest, now) : 0;
    report.skinVolume = restOfMesh > 0 ? volume * part.part.volume / restOfMesh : volume;
    control.throwIfCancelled();

    if (shape.IsNull() && !part.part.watertight)
        throw std::runtime_error("\"" + part.part.name +
                                 "\" is an open mesh, which CAD files cannot hold; hide it, or " + "export as a mesh.");
    if (shape.IsNull()) {
        makeFaceted(part, part.reason.empty() ? "it came as a mesh, which has no smooth faces." : part.reason, ready);
        ready.skin = std::move(now);
        return ready;
    }
    const bool isMoved = dynamic_cast<const InPlace*>(ready.map.get()) == nullptr;
    ready.source = shape;
    std::vector<std::uint32_t> own(part.part.faces.size());
    std::iota(own.begin(), own.end(), 0U);
    addFaceColors(part.part, own, ready.out);
    if (!isMoved) {
        ready.out.shape = part.part.watertight ? outward(ready.source) : ready.source;
        report.keptFaces = report.facesBefore;
        return ready;
    }
    noteCrossings(*ready.map, {&part.part.mesh, &rest}, now, control, report);
    TaskPortion bending(control, 0.2, 1);
    makeBent(part, choice, bending, ready);
    noteFold(rest, now, report);
    if (report.form == PartExportReport::Form::faceted)
        ready.skin = std::move(now);
    else if (report.flatFaces > 0)
        ready.skin = skinOfFlatFaces(ready, now);
    return ready;
}

} // namespace

ReadyPart makeReady(const PartToExport& part, const TopoDS_Shape& shape, const ExportOptions& options,
                    const FaceChoice& choice, TaskControl& control)
{
    const TopoDS_Shape own = shape.IsNull() ? shape : inMillimetres(shape, part.part.exact->unit);
    if ((!part.cut && !part.slit) || own.IsNull())
        return makeReadyAsIs(part, own, options, choice, control);
    if (const auto cut = part.slit ? slitShape(own, *part.slit) : cutShape(own, *part.cut)) {
        const PartToExport piece = asCut(part, *cut);
        if (piece.part.watertight)
            return makeReadyAsIs(piece, cut->shape, options, choice, control);
    }
    PartToExport flat = part;
    flat.reason = "its faces could not be cut where the knife went.";
    return makeReadyAsIs(flat, {}, options, choice, control);
}

} // namespace knead
