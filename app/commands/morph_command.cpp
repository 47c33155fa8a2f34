#include "app/commands/morph_command.h"

#include "app/commands/carry_out.h"
#include "app/commands/command_output.h"
#include "app/commands/deformation_arguments.h"
#include "app/commands/morph_report.h"
#include "app/complaint.h"
#include "app/exit_status.h"
#include "app/export_arguments.h"
#include "app/export_file.h"
#include "app/import_arguments.h"
#include "app/morph_file.h"
#include "app/opened_shape.h"
#include "core/message/message.h"
#include "core/model/file_formats.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace knead {

namespace {

struct MorphOptions {
    explicit MorphOptions(CLI::App& command)
        : deformations(command)
    {
    }

    std::string input;
    std::string output;
    DeformationArguments deformations;
    std::vector<std::string> parts; ///< that are deformed; empty: all
    ImportOptions import;
    ExportOptions write;
    bool report = false;
    bool json = false;
};

int carryOutMorph(const MorphOptions& options, std::vector<DeformationWish> wishes)
{
    return carryOut([&](TerminalControl& control, int& failure) {
        const auto isReady = [&failure] { failure = exit_status::failed; };
        const MorphReport report = morphFile({.input = options.input,
                                              .output = options.output,
                                              .wishes = std::move(wishes),
                                              .parts = options.parts,
                                              .import = options.import,
                                              .write = options.write},
                                             control, isReady);
        if (options.report)
            writeReportBeside(report.written);
        control.clear();
        printWarnings(remarksOnImport(report.model));
        printWarnings(report.plan.remarks);
        options.json ? printAsJson(jsonOf(report)) : printMorph(report);
        return exit_status::done;
    });
}

int morph(const MorphOptions& options)
{
    if (formatToWrite(options.output) == nullptr)
        return complain(options.output + ": the ending is none of " + formatEndings(" and ") +
                            "; name the file after its format.",
                        exit_status::wrongUse);
    std::vector<DeformationWish> wishes;
    try {
        wishes = options.deformations.wishes();
    } catch (const Problem& problem) {
        return complain(problem.what(), exit_status::wrongUse);
    }
    if (wishes.empty())
        return complain("nothing is said to deform the parts; give --field FILE, or a number such as --bend 90.",
                        exit_status::wrongUse);
    return carryOutMorph(options, std::move(wishes));
}

} // namespace

void addMorphCommand(CLI::App& program, int& exitStatus)
{
    CLI::App* command = program.add_subcommand(
        "morph", "Deform the parts of a CAD or mesh file by a field or by numbers; smooth faces stay smooth faces");
    auto options = std::make_shared<MorphOptions>(*command);
    command->add_option("PART", options->input, formatNames(" or ") + " file")->required();
    command->add_option("--output", options->output, "File to write: " + formatEndings(" and "))
        ->required()
        ->type_name("FILE");
    addRepeatedOption(
        *command, "--part", options->parts,
        "Name of a part, or path of a part or assembly, that is deformed; may be given several times. All "
        "others are written as they are")
        ->type_name("NAME");
    command->add_flag("--report", options->report,
                      "Write what was found when the file was read back as JSON beside it");
    command->add_flag("--json", options->json, "Print it all as JSON");
    addExportArguments(*command, options->write);
    addReadingArguments(*command, options->import);
    command->callback([options, &exitStatus] { exitStatus = morph(*options); });
}

} // namespace knead
