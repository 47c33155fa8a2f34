#include "app/commands/convert_command.h"

#include "app/cad_process.h"
#include "app/exit_status.h"
#include "app/import_arguments.h"
#include "app/terminal_control.h"
#include "io/mesh_writer.h"
#include "io/picture_writer.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>
#include <exception>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace knead {

namespace {

constexpr double millimeter = 1e-3;

struct ConvertOptions {
    std::string input;
    std::string output;
    double deflection = 0; ///< [mm]; 0: the importer's own
    ImportOptions import;
};

std::string endingOf(const std::string& path)
{
    std::string ending = std::filesystem::path(path).extension().string();
    ending.erase(0, 1);
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
    return ending;
}

bool isPicture(const std::string& path)
{
    return endingOf(path) == "png";
}

/// Looked at first: nobody wants to wait for a file to be read before a typing mistake is told.
bool canBeWritten(const std::string& path)
{
    const auto matches = [ending = endingOf(path)](const FileFormat& format) {
        return std::find(format.endings.begin(), format.endings.end(), ending) != format.endings.end();
    };
    return isPicture(path) || std::any_of(exportFormats().begin(), exportFormats().end(), matches);
}

void writeTo(const std::string& path, Model& model)
{
    std::vector<MeshBody> bodies;
    for (Part& part : model.parts)
        bodies.push_back({part.name, part.color.value_or(Color{}), std::move(part.mesh)});
    isPicture(path) ? writePicture(path, bodies) : writeMeshes(path, bodies);
}

int complain(const std::string& sentence, int status)
{
    std::cerr << "knead: " << sentence << '\n';
    return status;
}

std::optional<Model> read(const ConvertOptions& options, int& status)
{
    TerminalControl control;
    try {
        ImportOptions how = options.import;
        how.linearDeflection = options.deflection * millimeter;
        Model model = importInChild(options.input, how, control);
        control.clear();
        return model;
    } catch (const Cancelled&) {
        control.clear();
        status = complain("interrupted.", exit_status::interrupted);
    } catch (const std::exception& error) {
        control.clear();
        status = complain(error.what(), exit_status::wrongUse);
    }
    return std::nullopt;
}

int convert(const ConvertOptions& options)
{
    if (!canBeWritten(options.output))
        return complain(options.output +
                            ": the ending is none of .stl, .obj, .ply and .png; name the file after its format.",
                        exit_status::wrongUse);
    int status = exit_status::done;
    std::optional<Model> model = read(options, status);
    if (!model)
        return status;
    try {
        writeTo(options.output, *model);
    } catch (const std::exception& error) {
        return complain(error.what(), exit_status::failed);
    }
    for (const std::string& warning : model->warnings)
        std::cerr << "knead: warning: " << warning << '\n';
    if (model->unitRemark)
        std::cerr << "knead: warning: " << model->unitRemark->sentence << '\n';
    for (const std::string& sentence : model->missing)
        std::cerr << "knead: missing: " << sentence << '\n';
    return exit_status::done;
}

} // namespace

void addConvertCommand(CLI::App& program, int& exitStatus)
{
    auto options = std::make_shared<ConvertOptions>();
    CLI::App* command = program.add_subcommand("convert", "Write a CAD or mesh file as triangles or as a picture");
    command->add_option("IN", options->input, "STEP, IGES, BREP, STL, OBJ, PLY, 3MF or glTF file")->required();
    command->add_option("OUT", options->output, "File to write: .stl, .obj, .ply or .png")->required();
    command->add_option("--deflection", options->deflection, "Largest distance of the triangles from the surface in mm")
        ->type_name("MM")
        ->check(CLI::PositiveNumber);
    addImportArguments(*command, options->import);
    command->callback([options, &exitStatus] { exitStatus = convert(*options); });
}

} // namespace knead
