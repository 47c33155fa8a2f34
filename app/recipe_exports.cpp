#include "app/recipe_exports.h"

#include "core/geometry/refine.h"
#include "core/skin/skin.h"
#include "io/mesh_writer.h"
#include "io/picture_writer.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

namespace knead {

namespace fs = std::filesystem;

namespace {

constexpr Color toolColor{0.42F, 0.64F, 0.56F};
constexpr double skinShare = 0.6; // of the progress; the rest is writing

/// The surface of a body, fine enough to bend with its objects, at its present place.
MeshBody deformed(const Part& part, const Body& body, const Snapshot::BodyState& state, TaskControl& control)
{
    TriangleMesh mesh = refine(part.mesh, body.aggregate->lattice.spacing);
    const Skin skin(*body.aggregate, mesh.vertices, control);
    std::vector<Vec3> places(mesh.vertices.size());
    skin.evaluate(state.displacements(), places);
    mesh.vertices = std::move(places);
    return {part.name, part.color.value_or(Color{}), std::move(mesh)};
}

std::vector<MeshBody> deformedBodies(const RecipeScene& ready, const Snapshot& snapshot, TaskControl& control)
{
    std::vector<MeshBody> bodies;
    const auto count = static_cast<double>(ready.parts.size());
    for (std::size_t i = 0; i < ready.parts.size(); ++i) {
        TaskPortion portion(control, static_cast<double>(i) / count, static_cast<double>(i + 1) / count);
        bodies.push_back(deformed(ready.parts[i], ready.scene.bodies[i], snapshot.bodies[i], portion));
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

void writeTo(const std::string& path, const RecipeExport& wanted, const std::vector<MeshBody>& bodies,
             const std::vector<MeshBody>& tools)
{
    if (!wanted.isPicture())
        return writeMeshes(path, bodies);
    std::vector<MeshBody> shown = bodies;
    if (wanted.showTools)
        shown.insert(shown.end(), tools.begin(), tools.end());
    writePicture(path, shown, pictureOptions(wanted));
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
            throw std::runtime_error("The output folder " + folder.string() +
                                     " cannot be made; choose another one with --out.");
    }
}

std::vector<std::string> writeExports(const std::vector<RecipeExport>& exports, const std::string& outputFolder,
                                      const RecipeScene& ready, const Snapshot& snapshot, TaskControl& control)
{
    if (exports.empty())
        return {};
    TaskPortion skinning(control, 0, skinShare);
    const std::vector<MeshBody> bodies = deformedBodies(ready, snapshot, skinning);
    std::vector<MeshBody> tools;
    std::transform(snapshot.tools.begin(), snapshot.tools.end(), std::back_inserter(tools), toolBody);

    std::vector<std::string> paths;
    for (const RecipeExport& wanted : exports) {
        control.throwIfCancelled();
        const double done = static_cast<double>(paths.size()) / static_cast<double>(exports.size());
        control.report(skinShare + (1 - skinShare) * done, "writing " + wanted.file);
        const std::string path = (fs::path(outputFolder) / wanted.file).lexically_normal().string();
        writeTo(path, wanted, bodies, tools);
        paths.push_back(path);
    }
    return paths;
}

} // namespace knead
