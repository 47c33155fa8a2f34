#include "app/commands/thumbnail_command.h"

#include "app/cad_process.h"
#include "app/commands/carry_out.h"
#include "app/drawn_bodies.h"
#include "app/exit_status.h"
#include "core/message/message.h"
#include "io/files/safe_file.h"
#include "io/picture/picture_writer.h"
#include "io/project/project_file.h"
#include "io/project/project_thumbnail.h"

#include <CLI/CLI.hpp>

#include <QBuffer>
#include <QImage>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace knead {

namespace {

/// Triangles smaller than a pixel show nothing.
constexpr double roughDeflection = 2e-3; // of the diagonal of each part
constexpr int smallest = 16;             // [pixels]
constexpr int largest = 2048;

struct ThumbnailOptions {
    std::string file;
    std::string picture;
    int size = 256; ///< of its longer side [pixels]
};

/// A smaller picture of a picture as a PNG; empty when it is none.
QByteArray shrunk(const std::vector<std::byte>& picture, int size)
{
    QImage image;
    image.loadFromData(reinterpret_cast<const uchar*>(picture.data()), static_cast<int>(picture.size()), "PNG");
    if (image.isNull())
        return {};
    if (image.width() > size || image.height() > size)
        image = image.scaled(size, size, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return bytes;
}

void draw(const ThumbnailOptions& options, const std::vector<MeshBody>& bodies)
{
    writePicture(options.picture, bodies, {.width = options.size, .height = options.size});
}

/// The view that it was saved with; a project without one is drawn as it is now.
void drawProject(const ThumbnailOptions& options, TaskControl& control)
{
    const QByteArray kept = shrunk(projectThumbnail(options.file), options.size);
    if (kept.isEmpty())
        return draw(options, drawnBodies(openShape(options.file, {}, {}, control)));
    writeFileSafely(options.picture, std::string_view(kept.constData(), static_cast<std::size_t>(kept.size())));
}

int thumbnail(const ThumbnailOptions& options)
{
    return carryOut([&](TerminalControl& control, int&) {
        if (isProjectFile(options.file))
            drawProject(options, control);
        else
            draw(options, drawnBodies(importInChild(options.file, {.relativeDeflection = roughDeflection}, control)));
        control.clear();
        return exit_status::done;
    });
}

} // namespace

void addThumbnailCommand(CLI::App& program, int& exitStatus)
{
    auto options = std::make_shared<ThumbnailOptions>();
    CLI::App* command =
        program.add_subcommand("thumbnail", "Draw a small picture of a file or project, as file managers show it");
    command->add_option("FILE", options->file, "CAD or mesh file, or a project saved by the window")->required();
    command->add_option("PICTURE", options->picture, "Picture to write, a PNG")->required();
    command->add_option("--size", options->size, "Length of its longer side in pixels")
        ->type_name("N")
        ->check(CLI::Range(smallest, largest))
        ->capture_default_str();
    command->callback([options, &exitStatus] { exitStatus = thumbnail(*options); });
}

} // namespace knead
