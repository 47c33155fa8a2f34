#include "app/recipe_exports.h"

#include "app/export_file.h"
#include "core/message/message.h"
#include "core/skin/deformed_surface.h"
#include "core/skin/torn_parts.h"
#include "io/formats/mesh_writer.h"
#include "io/picture/picture_writer.h"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace knead {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t mostTrianglesDrawn = 400'000; // of a body in a picture
constexpr Color toolColor{0.42F, 0.64F, 0.56F};

/// Bodies that have come apart as their pieces.
std::vector<MeshBody> deformedBodies(const ExportJob& job, TaskControl& control)
{
    std::vector<MeshBody> bodies;
    for (PartToExport& part : withPieces(job, mostTrianglesDrawn, control).parts) {
        MeshBody& body = bodies.emplace_back(MeshBody{part.part.name, part.part.color.value_or(Color{}), {}});
        body.faceColors = faceColorsOf(part.part);
        body.mesh = part.aggregate == nullptr ? std::move(part.part.mesh)
                                              : deformedSurface(part.part.mesh, *part.aggregate, part.displacements,
                                                                mostTrianglesDrawn, control);
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
