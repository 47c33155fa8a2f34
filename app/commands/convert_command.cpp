#include "app/commands/convert_command.h"

#include "app/cad_process.h"
#include "app/commands/carry_out.h"
#include "app/commands/command_output.h"
#include "app/complaint.h"
#include "app/drawn_bodies.h"
#include "app/exit_status.h"
#include "app/export_arguments.h"
#include "app/export_file.h"
#include "app/import_arguments.h"
#include "core/message/message.h"
#include "core/model/file_formats.h"
#include "core/session/export_jobs.h"
#include "io/picture/picture_writer.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
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

void writeTo(const ConvertOptions& options, const Model& model, TaskControl& control)
{
    if (isPicture(options.output))
        return writePicture(options.output, drawnBodies(model));
    ExportJob job = exportJobOf(model, {}, {});
    job.options = asWished(options.write, job.options);
    const ExportReport report = exportFile(options.output, std::move(job), control);
    if (options.report)
        writeReportBeside(report);
    if (report.isSound() && !options.report)
        return;
    for (const std::string& line : linesOf(report))
        std::cerr << "knead: " << line << '\n';
}

int convert(const ConvertOptions& options)
{
    if (const std::string problem = problemWithName(options.output);
        !problem.empty()) // before waiting for IN to be read
        return complain(problem, exit_status::wrongUse);
    return carryOut([&](TerminalControl& control, int& failure) {
        ImportOptions how = options.import;
        how.linearDeflection = options.deflection * millimeter;
        const Model model = importInChild(options.input, how, control);
        failure = exit_status::failed;
        writeTo(options, model, control);
        control.clear();
        printWarnings(model.warnings);
        if (model.unitRemark)
            std::cerr << "knead: warning: " << model.unitRemark->sentence.english() << '\n';
        for (const Message& sentence : model.missing)
            std::cerr << "knead: missing: " << sentence.english() << '\n';
        return exit_status::done;
    });
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
    addExportArguments(*command, options->write);
    command->add_flag("--report", options->report,
                      "Say what was found when the file was read back, also as JSON beside it");
    addImportArguments(*command, options->import);
    command->callback([options, &exitStatus] { exitStatus = convert(*options); });
}

} // namespace knead
