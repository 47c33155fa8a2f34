#include "app/commands/apply_command.h"

#include "app/cad_process.h"
#include "app/commands/carry_out.h"
#include "app/commands/command_output.h"
#include "app/commands/run_json.h"
#include "app/commands/transfer_report.h"
#include "app/complaint.h"
#include "app/exit_status.h"
#include "app/export_file.h"
#include "app/part_application.h"
#include "app/recipe_files.h"
#include "app/resources.h"
#include "app/thread_limit.h"
#include "core/message/message.h"
#include "core/model/file_names.h"
#include "core/session/recipe_runner.h"
#include "io/export/job_file.h"
#include "io/files/safe_file.h"
#include "io/material_library.h"
#include "io/project/project_file.h"
#include "io/recipe/recipe_text.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace knead {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct ApplyOptions {
    std::string session;
    std::string part;
    std::string outputFolder; ///< empty: nothing is carried out
    std::string recipe;       ///< to write; empty: none
    std::optional<std::uint32_t> entry;
    std::string mirror;
    std::string scale;
    std::string unit;
    bool byField = false;
    unsigned threads = 0;
    bool json = false;
};

/// "x", "y", "z", or the three numbers of a normal with commas between them.
std::optional<Vec3> mirrorOf(const std::string& text)
{
    if (text.empty())
        return std::nullopt;
    for (int axis = 0; axis < 3; ++axis)
        if (text == std::string(1, "xyz"[axis]))
            return Vec3::Unit(axis);
    Vec3 normal = Vec3::Zero();
    char rest = 0;
    if (std::sscanf(text.c_str(), "%lf,%lf,%lf%c", &normal.x(), &normal.y(), &normal.z(), &rest) != 3 ||
        !normal.allFinite() || normal.norm() < 1e-9)
        throw Problem(Message("Transfer",
                              "--mirror \"%1\" is no mirror; say x, y or z, across which it is mirrored, or "
                              "the normal of a plane as 1,1,0.")
                          .with(text));
    return normal;
}

/// None: as the boxes say.
std::optional<double> scaleOf(const std::string& text)
{
    if (text.empty())
        return 1;
    if (text == "auto")
        return std::nullopt;
    char* end = nullptr;
    const double scale = std::strtod(text.c_str(), &end);
    if (*end != '\0' || !(scale >= 1e-3 && scale <= 1e3))
        throw Problem(
            Message("Transfer", "--scale \"%1\" is no scale; say auto or a number from 0.001 to 1000.").with(text));
    return scale;
}

/// Its name, with what was done to it: "bracket-2-deformed.step".
std::string exportName(const ApplyOptions& options)
{
    return fs::path(options.part).stem().string() + "-deformed.step";
}

Project sessionOf(const ApplyOptions& options, TaskControl& control)
{
    if (!isProjectFile(options.session))
        throw Problem(
            aboutFile(options.session, Message("Transfer", "this is no project of Knead. A recipe goes to "
                                                           "another part with knead run --set part.file=...")));
    Project project = readProjectAfterTrial(options.session, control);
    project.current = options.entry.value_or(project.current);
    if (project.current >= project.entries.size())
        throw Problem(aboutFile(options.session, Message("Transfer", "the project has no entry %1; its last is %2.")
                                                     .with(project.current, project.entries.size() - 1)));
    return project;
}

void writeRecipe(const ApplyOptions& options, Recipe recipe)
{
    recipe.exports = {{.file = exportName(options)}};
    writeFileSafely(options.recipe, recipeText(recipe, options.recipe, readMaterials(materialsFile())));
}

/// The shape without a simulation.
void carry(const ApplyOptions& options, const PartTransfer& transfer, std::uint32_t entry, TerminalControl& control,
           Json& json)
{
    fs::create_directories(options.outputFolder);
    const std::string path = (fs::path(options.outputFolder) / exportName(options)).string();
    TaskPortion carrying(control, 0.5, 1);
    const ExportReport report = carryShape(options.session, transfer, entry, path, carrying);
    writeReportBeside(report);
    control.clear();
    json["files"] = {path};
    json["exports"] = {Json::parse(reportToJson(report))};
    if (!options.json)
        printWritten({path}, {report});
}

/// As `knead run` does.
void carryOutRecipe(const ApplyOptions& options, const PartTransfer& transfer, TerminalControl& control, Json& json)
{
    Recipe recipe = transfer.recipe;
    recipe.exports = {{.file = exportName(options), .wantsReport = true}};
    TaskPortion running(control, 0.5, 1);
    const RunReport report = runRecipe(recipe, recipeFiles(), options.outputFolder, running);
    control.clear();
    for (const std::string& warning : report.warnings)
        std::fprintf(stderr, "knead: warning: %s\n", warning.c_str());
    json["run"] = jsonOf(report);
    if (!options.json)
        printWritten(report.files, report.exports);
}

int carryOver(const ApplyOptions& options, TerminalControl& control, int& failure)
{
    const TransferOptions how{
        .mirror = mirrorOf(options.mirror), .scale = scaleOf(options.scale), .unit = options.unit};
    TaskPortion reading(control, 0, 0.1);
    const Project project = sessionOf(options, reading);
    TaskPortion finding(control, 0.1, 0.5);
    const PartTransfer transfer = transferProject(project, options.session, options.part, how, finding);
    control.clear();
    Json json{{"transfer", jsonOf(transfer.report)}};
    if (!options.json)
        printTransfer(transfer.report);
    printWarnings(transfer.report.leftOut);
    failure = exit_status::failed;
    if (!options.recipe.empty())
        writeRecipe(options, transfer.recipe);
    if (!options.outputFolder.empty())
        options.byField ? carry(options, transfer, project.current, control, json)
                        : carryOutRecipe(options, transfer, control, json);
    if (options.json)
        printAsJson(json);
    return exit_status::done;
}

int apply(const ApplyOptions& options)
{
    if (options.outputFolder.empty() && options.recipe.empty())
        return complain("say where to: --output FOLDER carries it out, --recipe FILE writes the recipe only.",
                        exit_status::wrongUse);
    if (options.byField && options.outputFolder.empty())
        return complain("--by-field writes a shape; say where to with --output FOLDER.", exit_status::wrongUse);
    const ThreadLimit limit(options.threads);
    return carryOut([&](TerminalControl& control, int& failure) { return carryOver(options, control, failure); });
}

} // namespace

void addApplyCommand(CLI::App& program, int& exitStatus)
{
    auto options = std::make_shared<ApplyOptions>();
    CLI::App* command = program.add_subcommand(
        "apply",
        "Do to another part what was done in a project: to its next revision, a mirrored partner, another size");
    command->add_option("SESSION", options->session, "Project saved by the window")->required();
    command->add_option("PART", options->part, "CAD file of the other part")->required();
    command->add_option("-o,--output", options->outputFolder, "Folder for the deformed part, made when missing")
        ->type_name("FOLDER");
    command->add_option("--recipe", options->recipe, "Write the recipe for the other part")->type_name("FILE");
    command->add_option("--entry", options->entry, "Entry of the history to come to; without it the present one")
        ->type_name("N");
    command
        ->add_option("--mirror", options->mirror,
                     "The other part is the mirrored partner: across x, y or z, or a plane by its normal, as 1,1,0")
        ->type_name("PLANE");
    command->add_option("--scale", options->scale, "The other part is so many times as large; auto: as its box says")
        ->type_name("F");
    command->add_option("--unit", options->unit, "Length unit of its file, where that does not say it")
        ->type_name("UNIT");
    command->add_flag("--by-field", options->byField, "Carry the shape over as it is, without a simulation");
    command->add_option("--threads", options->threads, "Number of threads; the result is the same for any")
        ->type_name("N")
        ->check(CLI::Range(1U, 1024U));
    command->add_flag("--json", options->json, "Print the report as JSON");
    command->callback([options, &exitStatus] { exitStatus = apply(*options); });
}

} // namespace knead
