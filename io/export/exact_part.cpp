#include "io/export/exact_part.h"

#include "core/geometry/mass_properties.h"
#include "core/geometry/refine.h"
#include "core/skin/deformed_surface.h"
#include "core/skin/skin_map.h"
#include "io/export/faceted_solid.h"
#include "io/face_integral.h"

#include <BRepBuilderAPI_Transform.hxx>
#include <gp_Trsf.hxx>

#include <algorithm>
#include <stdexcept>

namespace knead {

namespace {

constexpr double defaultTolerance = 1e-4; // of the size of the part
constexpr std::size_t foldSamples = 3000;
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

/// Its triangles at their present places, fine enough to bend with the objects.
TriangleMesh deformedMesh(const PartToExport& part)
{
    if (part.map != nullptr) {
        TriangleMesh mesh = refine(part.part.mesh, part.part.box.diagonal().norm() / triangleEdges);
        part.map->evaluate(std::vector<Vec3>(mesh.vertices), mesh.vertices);
        return mesh;
    }
    return part.aggregate == nullptr ? part.part.mesh
                                     : deformedSurface(part.part.mesh, *part.aggregate, part.displacements);
}

/// Whether the map turns the material inside out somewhere near the surface.
bool folds(const SmoothMap& map, const TriangleMesh& mesh)
{
    const std::size_t stride = std::max<std::size_t>(1, mesh.vertices.size() / foldSamples);
    for (std::size_t i = 0; i < mesh.vertices.size(); i += stride)
        if (map.gradient(mesh.vertices[i]).determinant() <= 0)
            return true;
    return false;
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

void addFaceColors(const Part& part, CadPartToWrite& out)
{
    for (const PartFace& face : part.faces)
        out.faceColors.push_back(face.color);
}

void makeFaceted(const PartToExport& part, const TriangleMesh& mesh, const std::string& reason, ReadyPart& ready)
{
    ready.out.shape = facetedSolid(mesh);
    ready.source.Nullify();
    ready.report.form = PartExportReport::Form::faceted;
    ready.report.reason = reason;
    ready.out.faceColors.clear();
    if (mesh.faceOfTriangle.empty())
        return;
    for (const std::uint32_t face : mesh.faceOfTriangle)
        ready.out.faceColors.push_back(face < part.part.faces.size() ? part.part.faces[face].color : std::nullopt);
}

} // namespace

ReadyPart makeReady(const PartToExport& part, const TopoDS_Shape& shape, const ExportOptions& options,
                    TaskControl& control)
{
    ReadyPart ready;
    ready.out.name = part.part.name;
    ready.out.color = part.part.color;
    ready.out.layer = part.part.layer;
    ready.out.visible = part.part.visible;
    ready.map = mapOf(part);

    PartExportReport& report = ready.report;
    report.name = part.part.name;
    report.density = part.density;
    report.solidsBefore = part.part.solids;
    report.facesBefore = static_cast<int>(part.part.faces.size());
    report.edgesBefore = part.part.edges;
    report.restVolume = part.part.volume;
    report.wasClosed = part.part.watertight;
    report.tolerance = options.tolerance > 0 ? options.tolerance : defaultTolerance * part.part.box.diagonal().norm();

    control.report(0, "bending the surface");
    const TriangleMesh mesh = deformedMesh(part);
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
        makeFaceted(part, mesh, part.reason.empty() ? "it came as a mesh, which has no smooth faces." : part.reason,
                    ready);
        return ready;
    }
    const bool isMoved = dynamic_cast<const InPlace*>(ready.map.get()) == nullptr;
    if (isMoved && folds(*ready.map, part.part.mesh)) {
        makeFaceted(part, mesh, "its material is folded over itself somewhere; smooth faces cannot follow that.",
                    ready);
        return ready;
    }
    ready.source = inMillimetres(shape, part.part.exact->unit);
    addFaceColors(part.part, ready.out);
    if (!isMoved) {
        ready.out.shape = ready.source;
        report.keptFaces = report.facesBefore;
        return ready;
    }
    TaskPortion morphing(control, 0.2, 1);
    MorphedShape morphed = morphShape(ready.source, *ready.map, {.tolerance = 1e3 * report.tolerance}, morphing);
    if (const std::string reason = whyNot(morphed); !reason.empty()) {
        makeFaceted(part, mesh, reason, ready);
        return ready;
    }
    report.keptFaces =
        static_cast<int>(std::count_if(morphed.notes.begin(), morphed.notes.end(),
                                       [](const MorphedFaceNote& note) { return note.kind == MorphedFaceKind::kept; }));
    ready.notes = std::move(morphed.notes);
    ready.out.shape = faceIntegralsOf(morphed.shape).volume < 0 ? morphed.shape.Reversed() : morphed.shape;
    return ready;
}

} // namespace knead
