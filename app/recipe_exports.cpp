#include "app/recipe_exports.h"

#include "app/export_file.h"
#include "core/geometry/refine.h"
#include "core/message/message.h"
#include "core/session/frame.h"
#include "core/skin/deformed_surface.h"
#include "core/skin/former_shape.h"
#include "io/formats/mesh_writer.h"
#include "io/picture/picture_writer.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <optional>
#include <utility>

namespace knead {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t mostTrianglesDrawn = 400'000; // of a body in a picture
constexpr Color toolColor{0.42F, 0.64F, 0.56F};

/// A body that is cracked or in pieces, as the window shows it: with the sides of its cracks, and nothing across open ones.
/// @return nothing where what broke is too little for a crack
std::optional<TriangleMesh> crackedSurface(const PartToExport& part, TaskControl& control)
{
    auto whole = std::make_shared<FilledBody>();
    whole->mesh = refine(part.part.mesh, part.aggregate->lattice.spacing, mostTrianglesDrawn);
    whole->render = renderMesh(whole->mesh);
    whole->aggregate = part.aggregate;
    whole->skin.emplace(*part.aggregate, whole->mesh.vertices, control);
    auto snapshot = std::make_shared<Snapshot>();
    std::vector<Vec3> positions = part.aggregate->lattice.positions();
    std::ranges::transform(positions, part.displacements, positions.begin(), std::plus<>());
    snapshot->bodies.push_back({.positions = std::move(positions), .aggregate = part.aggregate, .broken = part.broken});
    const FramePointer frame = prepareFrame({withNewFillings(whole)}, std::move(snapshot), nullptr);
    if (!frame->filled[0]->whole)
        return std::nullopt;
    TriangleMesh mesh = frame->filled[0]->mesh;
    mesh.vertices = frame->bodies[0]->places;
    const std::vector<std::uint32_t>& across = frame->bodies[0]->acrossCracks;
    std::size_t kept = 0;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        if (std::ranges::binary_search(across, t))
            continue;
        mesh.triangles[kept] = mesh.triangles[t];
        if (!mesh.faceOfTriangle.empty())
            mesh.faceOfTriangle[kept] = mesh.faceOfTriangle[t];
        ++kept;
    }
    mesh.triangles.resize(kept);
    if (!mesh.faceOfTriangle.empty())
        mesh.faceOfTriangle.resize(kept);
    return mesh;
}

std::vector<MeshBody> deformedBodies(const ExportJob& job, TaskControl& control)
{
    std::vector<MeshBody> bodies;
    for (const PartToExport& part : job.parts) {
        MeshBody& body = bodies.emplace_back(MeshBody{part.part.name, part.part.color.value_or(Color{}), {}});
        body.faceColors = faceColorsOf(part.part);
        if (part.aggregate == nullptr)
            body.mesh = part.part.mesh;
        else {
            const bool isBroken = (part.broken && !part.broken->empty()) ||
                                  (part.aggregate->former && part.aggregate->former->isInPieces());
            std::optional<TriangleMesh> cracked = isBroken ? crackedSurface(part, control) : std::nullopt;
            body.mesh = cracked ? std::move(*cracked)
                                : deformedSurface(part.part.mesh, *part.aggregate, part.displacements,
                                                  mostTrianglesDrawn, control);
        }
    }
    return bodies;
}

MeshBody toolBody(const ToolState& tool)
{
    MeshBody body{tool.name, toolColor, meshOf({tool.kind, tool.size, tool.part})};
    for (Vec3& vertex : body.mesh.vertices)
        vertex = tool.pose.toWorld(vertex);
    return body;
}

PictureOptions pictureOptions(const RecipeExport& wanted)
{
    PictureOptions options;
    options.width = wanted.width;
    options.height = wanted.height;
    if (wanted.viewDirection)
        options.viewDirection = *wanted.viewDirection;
    options.up = wanted.up;
    return options;
}

void drawTo(const std::string& path, const RecipeExport& wanted, const std::vector<MeshBody>& bodies,
            const Snapshot& snapshot)
{
    std::vector<MeshBody> tools;
    if (wanted.showTools)
        std::transform(snapshot.tools.begin(), snapshot.tools.end(), std::back_inserter(tools), toolBody);
    writePicture(path, bodies, pictureOptions(wanted), tools);
}

} // namespace

void prepareFolders(const std::vector<RecipeExport>& exports, const std::string& outputFolder)
{
    std::vector<fs::path> folders{outputFolder};
    for (const RecipeExport& wanted : exports)
        folders.push_back((fs::path(outputFolder) / wanted.file).parent_path());
    for (const fs::path& folder : folders) {
        std::error_code error;
        fs::create_directories(folder, error);
        if (!fs::is_directory(folder, error))
            throw Problem(Message("Recipe", "The output folder %1 cannot be made; choose another one with --out.")
                              .with(folder.string()));
    }
}

WrittenExports writeExports(const std::vector<RecipeExport>& exports, const std::string& outputFolder, ExportJob job,
                            const Snapshot& snapshot, TaskControl& control)
{
    std::vector<MeshBody> bodies; // for pictures
    WrittenExports written;
    const auto count = static_cast<double>(exports.size());
    for (const RecipeExport& wanted : exports) {
        control.throwIfCancelled();
        const auto done = static_cast<double>(written.files.size());
        TaskPortion portion(control, done / count, (done + 1) / count);
        portion.report(0, "writing " + wanted.file);
        const std::string path = (fs::path(outputFolder) / wanted.file).lexically_normal().string();
        if (wanted.isPicture()) {
            if (bodies.empty())
                bodies = deformedBodies(job, portion);
            drawTo(path, wanted, bodies, snapshot);
        } else {
            job.options = wanted.options;
            written.reports.push_back(exportFile(path, job, portion));
            if (wanted.wantsReport)
                written.files.push_back(writeReportBeside(written.reports.back()));
        }
        written.files.push_back(path);
    }
    return written;
}

} // namespace knead
