#include "io/export/exact_part.h"

#include "core/geometry/mass_properties.h"
#include "core/geometry/refine.h"
#include "core/geometry/self_intersection.h"
#include "core/skin/deformed_surface.h"
#include "core/skin/skin_map.h"
#include "io/export/faceted_solid.h"
#include "io/export/place_words.h"
#include "io/face_integral.h"
#include "io/tessellation.h"

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <gp_Trsf.hxx>

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace knead {

namespace {

constexpr double defaultTolerance = 1e-4; // of the size of the part
constexpr std::size_t foldSamples = 3000;
constexpr std::size_t mostTriangles = 400'000; // of the surface that volumes are compared with
constexpr double facetDeflection = 1.0 / 400;  // of the size of a part that is written as flat faces
constexpr double facetAngle = 0.35;            // [rad]
constexpr std::size_t wantedFacets = 10'000;
constexpr std::size_t mostFacets = 60'000;
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

std::shared_ptr<const SmoothMap> mapOf(const PartToExport& part)
{
    if (part.map != nullptr)
        return part.map;
    const bool moved = std::any_of(part.displacements.begin(), part.displacements.end(),
                                   [](const Vec3& displacement) { return displacement != Vec3::Zero(); });
    if (part.aggregate == nullptr || !moved)
        return std::make_shared<InPlace>();
    return std::make_shared<SkinMap>(*part.aggregate, part.displacements);
}

/// A surface of a part at its present place, fine enough to bend with the objects as far as the number of triangles allows.
TriangleMesh deformedMesh(const PartToExport& part, const TriangleMesh& rest, std::size_t most)
{
    if (part.map != nullptr) {
        TriangleMesh mesh = refine(rest, part.part.box.diagonal().norm() / triangleEdges, most);
        part.map->evaluate(std::vector<Vec3>(mesh.vertices), mesh.vertices);
        return mesh;
    }
    return part.aggregate == nullptr ? rest : deformedSurface(rest, *part.aggregate, part.displacements, most);
}

/// A closed surface of flat faces, as few as describe the part: CAD programs are slow with many.
/// @param source its exact shape; null for a mesh
TriangleMesh facetsOf(const PartToExport& part, const TopoDS_Shape& source)
{
    TriangleMesh rest = part.part.mesh;
    if (!source.IsNull()) {
        TriangleMesh coarse = tessellate(BRepBuilderAPI_Copy(source, false).Shape(),
                                         {facetDeflection * part.part.box.diagonal().norm(), facetAngle});
        if (isWatertight(coarse) && coarse.triangles.size() < rest.triangles.size())
            rest = std::move(coarse);
    }
    TriangleMesh facets = deformedMesh(part, rest, wantedFacets);
    if (facets.triangles.size() > mostFacets)
        throw std::runtime_error("\"" + part.part.name + "\" would need " + std::to_string(facets.triangles.size()) +
                                 " flat faces, more than CAD programs can work with; export it as a mesh.");
    return facets;
}

/// A place near the surface at which the map turns the material inside out, where it is then.
std::optional<Vec3> foldOf(const SmoothMap& map, const TriangleMesh& mesh)
{
    const std::size_t stride = std::max<std::size_t>(1, mesh.vertices.size() / foldSamples);
    for (std::size_t i = 0; i < mesh.vertices.size(); i += stride)
        if (map.gradient(mesh.vertices[i]).determinant() <= 0)
            return map.at(mesh.vertices[i]);
    return std::nullopt;
}

/// Where the surface passes through itself although it did not at rest.
void noteCrossings(const TriangleMesh& rest, const TriangleMesh& mesh, TaskControl& control, PartExportReport& report)
{
    const Crossings now = findCrossings(mesh, control);
    if (now.count == 0 || now.count <= findCrossings(rest, control).count)
        return;
    report.crossesItself = true;
    report.remarks.push_back("its surface passes through itself near " + placeWords(now.where.center()) +
                             "; other programs may refuse that.");
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

/// Which faces the splines could not follow as closely as was wanted, numbered from 0 as in recipes.
void noteMisses(const MorphedShape& shape, const std::string& name, double aim, PartExportReport& report)
{
    constexpr std::size_t mostNamed = 12;
    std::string numbers;
    std::size_t count = 0;
    std::size_t worst = 0;
    for (std::size_t i = 0; i < shape.notes.size(); ++i) {
        if (shape.notes[i].converged)
            continue;
        if (count++ < mostNamed)
            numbers += (count == 1 ? " " : ", ") + std::to_string(i);
        worst = shape.notes[i].error > shape.notes[worst].error || shape.notes[worst].converged ? i : worst;
    }
    if (count == 0)
        return;
    char text[200];
    std::snprintf(text, sizeof text,
                  " not come as close to the skin as was aimed at, %.3g mm; face %zu is %.3g mm off.", aim, worst,
                  shape.notes[worst].error);
    report.remarks.push_back("\"" + name + "\": " + (count == 1 ? "face" : std::to_string(count) + " faces,") +
                             numbers +
                             (count > mostNamed ? ", ...,"
                              : count > 1       ? ","
                                                : "") +
                             (count == 1 ? " does" : " do") + text);
}

void addFaceColors(const Part& part, CadPartToWrite& out)
{
    for (const PartFace& face : part.faces)
        out.faceColors.push_back(face.color);
}

void makeFaceted(const PartToExport& part, const std::string& reason, ReadyPart& ready)
{
    const FacetedSolid solid = facetedSolid(facetsOf(part, ready.source), flatness * ready.report.tolerance);
    ready.out.shape = solid.shape;
    ready.source.Nullify();
    ready.report.form = PartExportReport::Form::faceted;
    ready.report.reason = reason;
    ready.out.faceColors.clear();
    for (const std::uint32_t face : solid.origin)
        ready.out.faceColors.push_back(face < part.part.faces.size() ? part.part.faces[face].color : std::nullopt);
}

} // namespace

ReadyPart makeReady(const PartToExport& part, const TopoDS_Shape& shape, const ExportOptions& options,
                    const std::string& flatBecause, TaskControl& control)
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
    report.wasClosed = part.part.watertight;
    report.tolerance = options.tolerance > 0 ? options.tolerance : defaultTolerance * part.part.box.diagonal().norm();

    control.report(0, "bending the surface");
    const TriangleMesh mesh = deformedMesh(part, part.part.mesh, mostTriangles);
    // Triangles miss the volume of curved faces, in nearly the same measure before and after.
    const double restOfMesh = massProperties(part.part.mesh).volume;
    report.skinVolume = !part.part.watertight ? 0
                        : restOfMesh > 0      ? part.part.volume * massProperties(mesh).volume / restOfMesh
                                              : massProperties(mesh).volume;
    control.throwIfCancelled();

    if (shape.IsNull() && !part.part.watertight)
        throw std::runtime_error("\"" + part.part.name +
                                 "\" is an open mesh, which CAD files cannot hold; hide it, or " + "export as a mesh.");
    if (shape.IsNull()) {
        makeFaceted(part, part.reason.empty() ? "it came as a mesh, which has no smooth faces." : part.reason, ready);
        return ready;
    }
    const bool isMoved = dynamic_cast<const InPlace*>(ready.map.get()) == nullptr;
    ready.source = inMillimetres(shape, part.part.exact->unit);
    if (!flatBecause.empty()) {
        makeFaceted(part, flatBecause, ready);
        return ready;
    }
    if (isMoved) {
        const TriangleMesh fine =
            refine(part.part.mesh, part.part.box.diagonal().norm() / triangleEdges, mostTriangles);
        if (const auto fold = foldOf(*ready.map, fine)) {
            makeFaceted(part,
                        "its material is folded over itself near " + placeWords(*fold) +
                            "; smooth faces cannot follow that.",
                        ready);
            return ready;
        }
        noteCrossings(part.part.mesh, mesh, control, report);
    }
    addFaceColors(part.part, ready.out);
    if (!isMoved) {
        ready.out.shape = ready.source;
        report.keptFaces = report.facesBefore;
        return ready;
    }
    TaskPortion morphing(control, 0.2, 1);
    const MorphOptions morphOptions{.tolerance = 1e3 * report.tolerance};
    MorphedShape morphed = morphShape(ready.source, *ready.map, morphOptions, morphing);
    if (const std::string reason = whyNot(morphed); !reason.empty()) {
        makeFaceted(part, reason, ready);
        return ready;
    }
    report.keptFaces =
        static_cast<int>(std::count_if(morphed.notes.begin(), morphed.notes.end(),
                                       [](const MorphedFaceNote& note) { return note.kind == MorphedFaceKind::kept; }));
    noteMisses(morphed, part.part.name, morphOptions.faceTolerance(), report);
    ready.notes = std::move(morphed.notes);
    ready.out.shape = faceIntegralsOf(morphed.shape).volume < 0 ? morphed.shape.Reversed() : morphed.shape;
    return ready;
}

} // namespace knead
