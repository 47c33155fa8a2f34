#include "app/commands/convert_command.h"

#include "app/cad_process.h"
#include "app/complaint.h"
#include "app/exit_status.h"
#include "app/export_file.h"
#include "app/import_arguments.h"
#include "app/terminal_control.h"
#include "core/message/message.h"
#include "core/model/file_formats.h"
#include "io/formats/mesh_writer.h"
#include "io/picture/picture_writer.h"

#include <CLI/CLI.hpp>

#include <algorithm>
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
    ExportOptions write;
    bool report = false;
};

void drawTo(const std::string& path, Model& model)
{
    std::vector<MeshBody> bodies;
    for (Part& part : model.parts)
        bodies.push_back({part.name, part.color.value_or(Color{}), std::move(part.mesh)});
    writePicture(path, bodies);
}

void writeTo(const ConvertOptions& options, Model& model, TaskControl& control)
{
    if (isPicture(options.output))
        return drawTo(options.output, model);
    ExportJob job{.parts = {}, .tree = model.tree, .options = options.write};
    if (job.options.unit.empty() && canBeWrittenIn(model.unit))
        job.options.unit = model.unit;
    for (Part& part : model.parts)
        job.parts.push_back({.part = std::move(part)});
    const ExportReport report = exportFile(options.output, job, control);
    if (options.report)
        writeReportBeside(report);
    if (report.isSound() && !options.report)
        return;
    for (const std::string& line : linesOf(report))
        std::cerr << "knead: " << line << '\n';
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
    if (const std::string problem = problemWithName(options.output);
        !problem.empty()) // before waiting for IN to be read
        return complain(problem, exit_status::wrongUse);
    int status = exit_status::done;
    std::optional<Model> model = read(options, status);
    if (!model)
        return status;
    TerminalControl control;
    try {
        writeTo(options, *model, control);
        control.clear();
    } catch (const Cancelled&) {
        control.clear();
        return complain("interrupted; no file was left half-written.", exit_status::interrupted);
    } catch (const std::exception& error) {
        control.clear();
        return complain(error.what(), exit_status::failed);
    }
    for (const Message& warning : model->warnings)
        std::cerr << "knead: warning: " << warning.english() << '\n';
    if (model->unitRemark)
        std::cerr << "knead: warning: " << model->unitRemark->sentence.english() << '\n';
    for (const Message& sentence : model->missing)
        std::cerr << "knead: missing: " << sentence.english() << '\n';
    return exit_status::done;
}

} // namespace

void addConvertCommand(CLI::App& program, int& exitStatus)
{
    auto options = std::make_shared<ConvertOptions>();
    CLI::App* command =
        program.add_subcommand("convert", "Write a CAD or mesh file in another format, or as a picture");
    command->add_option("IN", options->input, formatNames(" or ") + " file")->required();
    command->add_option("OUT", options->output, "File to write: " + formatEndings(" and ") + ", or .png")->required();
    command->add_option("--deflection", options->deflection, "Largest distance of the triangles from the surface in mm")
        ->type_name("MM")
        ->check(CLI::PositiveNumber);
    command->add_option("--write-unit", options->write.unit, "Length unit of a CAD file written: mm, cm, m, inch or ft")
        ->type_name("UNIT");
    command->add_flag("--ap214", options->write.useAp214, "Write STEP in AP214 instead of AP242");
    command->add_flag("--text", options->write.isText, "Write " + formatNames(" and ", [](const FileFormat& f) {
                                                           return f.text == FileFormat::Text::asAsked;
                                                       }) + " as text");
    command->add_flag("--report", options->report,
                      "Say what was found when the file was read back, also as JSON beside it");
    addImportArguments(*command, options->import);
    command->callback([options, &exitStatus] { exitStatus = convert(*options); });
}

} // namespace knead
