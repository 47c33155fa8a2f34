#include "app/commands/morph_command.h"

#include "app/commands/carry_out.h"
#include "app/commands/command_output.h"
#include "app/commands/deformation_arguments.h"
#include "app/commands/morph_report.h"
#include "app/commands/run_json.h"
#include "app/complaint.h"
#include "app/exit_status.h"
#include "app/export_arguments.h"
#include "app/export_file.h"
#include "app/import_arguments.h"
#include "app/morph_file.h"
#include "app/opened_shape.h"
#include "app/physical_morph.h"
#include "core/message/message.h"
#include "core/model/file_formats.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cstdio>
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
    bool isByPhysics = false;
    PhysicsWish physics;
};

int carryOutByPhysics(const MorphOptions& options, std::vector<DeformationWish> wishes)
{
    return carryOut([&](TerminalControl& control, int& failure) {
        const auto say = [&control](const std::string& sentence) { control.say("knead: warning: " + sentence); };
        const RunReport report = morphByPhysics({.input = options.input,
                                                 .output = options.output,
                                                 .wishes = std::move(wishes),
                                                 .parts = options.parts,
                                                 .import = options.import,
                                                 .write = options.write,
                                                 .wantsReport = options.report,
                                                 .physics = options.physics},
                                                control, say);
        failure = exit_status::failed;
        control.clear();
        for (const std::string& warning : report.warnings)
            std::fprintf(stderr, "knead: warning: %s\n", warning.c_str());
        options.json ? printAsJson(jsonOf(report)) : printWritten(report.files, report.exports);
        return exit_status::done;
    });
}

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
    if (!options.isByPhysics && options.physics.saysAnything())
        return complain("--material, --time, --let-go and --objects say how physics does it; give --physics too.",
                        exit_status::wrongUse);
    return options.isByPhysics ? carryOutByPhysics(options, std::move(wishes))
                               : carryOutMorph(options, std::move(wishes));
}

void addPhysicsArguments(CLI::App& command, MorphOptions& options)
{
    const char* const group = "By physics";
    command
        .add_flag("--physics", options.isByPhysics,
                  "Hold what lies beyond the planes by grips that go as the formula says, and let the material between "
                  "find its own shape; for --bend, --twist, --stretch and --shear")
        ->group(group);
    command.add_option("--material", options.physics.material, "What the part is made of, as \"plasticine\"")
        ->type_name("NAME")
        ->group(group);
    command.add_option("--time", options.physics.duration, "That the way of the grips takes in s; 1 without it")
        ->type_name("S")
        ->check(CLI::Range(0.01, 3600.0))
        ->group(group);
    command
        .add_flag("--let-go", options.physics.letsGo,
                  "Open the grip that has moved most at the end, so that the material springs back")
        ->group(group);
    command
        .add_option("--objects", options.physics.objects, "About how many the part is filled with; 20000 without it")
        ->type_name("N")
        ->check(CLI::Range(8U, 20'000'000U))
        ->group(group);
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
    addPhysicsArguments(*command, *options);
    addExportArguments(*command, options->write);
    addReadingArguments(*command, options->import);
    command->callback([options, &exitStatus] { exitStatus = morph(*options); });
}

} // namespace knead
