#include "app/commands/run_command.h"

#include "app/cad_process.h"
#include "app/commands/command_output.h"
#include "app/commands/force_report.h"
#include "app/commands/run_json.h"
#include "app/complaint.h"
#include "app/exit_status.h"
#include "app/fields_at_nodes.h"
#include "app/recipe_files.h"
#include "app/recipe_to_run.h"
#include "app/set_argument.h"
#include "app/terminal_control.h"
#include "app/thread_limit.h"
#include "core/message/message.h"
#include "core/session/recipe_runner.h"
#include "core/session/recipe_scene.h"
#include "io/recipe/recipe_override.h"
#include "io/worker/own_process.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <iterator>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace knead {

namespace {

struct RunOptions {
    std::string recipe;
    std::string outputFolder = ".";
    unsigned threads = 0;
    std::vector<std::string> settings; ///< "PATH=VALUE"
    RunTables tables;
    FieldsRequest fields;
    bool json = false;
    bool endsWithParent = false;
};

/// What is worth a line only when it happened.
void printDamage(const RunReport& report)
{
    if (report.broken > 0 || report.joints > 0 || report.components != report.bodies)
        std::printf("%zu connections broke, %zu joints hold, %zu %s of material\n", report.broken, report.joints,
                    report.components, report.components == 1 ? "piece" : "pieces");
    if (report.refills > 0)
        std::printf("filled anew %llu times in the shape of the time\n",
                    static_cast<unsigned long long>(report.refills));
    if (report.addedMass > 0)
        std::printf("mass scaling added %.3g %% of the mass\n", 100 * report.addedMass);
}

/// Too few cells are a warning, which is said apart.
void printWalls(const RunReport& report)
{
    if (report.fineness.cellsAcrossWall > 0 && report.fineness.warning.empty())
        std::printf("thinnest walls: %.2g cells across; their bending is right within %.0f %%\n",
                    report.fineness.cellsAcrossWall, 100 * bendingErrorOf(report.fineness.cellsAcrossWall));
}

void printSummary(const RunReport& report)
{
    std::printf("%zu objects, %zu connections in %zu %s\n", report.objects, report.connections, report.bodies,
                report.bodies == 1 ? "body" : "bodies");
    std::printf("%.3f s simulated in %.1f s (%.2fx real time), %llu steps of %.3g ms\n", report.simulated, report.wall,
                report.ratio(), static_cast<unsigned long long>(report.steps), 1000 * report.timeStep);
    std::printf("%s\n", report.integrator.c_str());
    std::printf("energy: elastic %.3g J, kinetic %.3g J, work of the tools %.3g J, dissipated %.3g J\n",
                report.energy.elastic, report.energy.kinetic, report.energy.toolWork, report.energy.dissipated());
    printDamage(report);
    printWalls(report);
    for (const ToolState& tool : report.tools)
        std::printf("tool %s: force (%.3g, %.3g, %.3g) N, peak %.3g N\n", tool.name.c_str(), tool.force.x(),
                    tool.force.y(), tool.force.z(), tool.peakForce);
    printForces(report);
    printWritten(report.files, report.exports);
}

/// Those that were not said at once.
void sayWarnings(const RunReport& report, const std::vector<std::string>& said)
{
    for (const std::string& warning : report.warnings)
        if (std::find(said.begin(), said.end(), warning) == said.end())
            std::cerr << "knead: warning: " << warning << '\n';
}

/// Reads the mesh at once: a run that takes hours should not end at a wrong name.
WriteAtNodes writerAtNodes(const FieldsRequest& request)
{
    checkFields(request);
    if (request.nodes.empty())
        return nullptr;
    auto mesh = std::make_shared<const NodalMesh>(readNodesInChild(request.nodes, request.unit, TaskControl::none()));
    return [request, mesh](const Model& model, std::span<const std::size_t> partOfBody, const Snapshot& snapshot,
                           TaskControl& writing) {
        const std::vector<BodyAtNodes> bodies = bodiesAtNodes(model, partOfBody, snapshot);
        return WrittenAtNodes{request.output, writeFieldsAtNodes(request, *mesh, bodies, writing).warnings};
    };
}

int carryOutRecipe(const Recipe& recipe, const RunOptions& options, const WriteAtNodes& writeAtNodes)
{
    const ThreadLimit limit(options.threads);
    TerminalControl control;
    std::mutex saying;
    std::vector<std::string> said;
    try {
        const auto say = [&](const std::string& sentence) {
            control.say("knead: warning: " + sentence);
            const std::lock_guard lock(saying);
            said.push_back(sentence);
        };
        const RunReport report =
            runRecipe(recipe, recipeFiles(), options.outputFolder, control, say, options.tables, writeAtNodes);
        control.clear();
        sayWarnings(report, said);
        options.json ? printAsJson(jsonOf(report)) : printSummary(report);
        return exit_status::done;
    } catch (const Cancelled&) {
        control.clear();
        return complain("interrupted; no file was left half-written.", exit_status::interrupted);
    } catch (const UnusableInput& error) {
        control.clear();
        return complain(error.what(), exit_status::wrongUse);
    } catch (const RunFailed& failed) {
        control.clear();
        sayWarnings(failed.report, said);
        if (options.json)
            printAsJson(jsonOf(failed.report));
        return complain(failed.what(), exit_status::failed);
    } catch (const std::exception& error) {
        control.clear();
        if (options.json)
            printAsJson({{"failure", {{"kind", "failed"}, {"sentence", error.what()}}}});
        return complain(error.what(), exit_status::failed);
    }
}

Recipe recipeOf(const RunOptions& options)
{
    std::vector<RecipeOverride> changes;
    std::transform(options.settings.begin(), options.settings.end(), std::back_inserter(changes), parseOverride);
    RecipeToRun found = recipeToRun(options.recipe, changes);
    printWarnings(found.remarks);
    return std::move(found.recipe);
}

int run(const RunOptions& options)
{
    if (options.endsWithParent)
        endWithParent();
    Recipe recipe;
    WriteAtNodes writeAtNodes;
    try {
        writeAtNodes = writerAtNodes(options.fields);
        recipe = recipeOf(options);
    } catch (const std::exception& error) {
        return complain(error.what(), exit_status::wrongUse);
    }
    return carryOutRecipe(recipe, options, writeAtNodes);
}

} // namespace

void addRunCommand(CLI::App& program, int& exitStatus)
{
    auto options = std::make_shared<RunOptions>();
    CLI::App* command =
        program.add_subcommand("run", "Carry out a recipe, or what was done in a project, without a window");
    command->add_option("RECIPE", options->recipe, "Recipe to carry out, a JSON file, or a project saved by the window")
        ->required();
    command->add_option("--out", options->outputFolder, "Folder for the exports, made when missing")
        ->type_name("FOLDER")
        ->capture_default_str();
    addSetArgument(*command, options->settings);
    command
        ->add_option("--csv", options->tables.forces,
                     "Write forces and moments of fixtures, tools and loads over time as a table")
        ->type_name("FILE");
    command
        ->add_option("--probes", options->tables.probes,
                     "Write what the probes of the recipe read over time as a table")
        ->type_name("FILE");
    addFieldsArguments(*command, options->fields, "--nodes-unit", "--fields-output");
    command->add_option("--threads", options->threads, "Number of threads; the result is the same for any")
        ->type_name("N")
        ->check(CLI::Range(1U, 1024U));
    command->add_flag("--json", options->json, "Print the report as JSON");
    command->add_flag("--end-with-parent", options->endsWithParent, "For runs of a sweep")->group("");
    command->callback([options, &exitStatus] { exitStatus = run(*options); });
}

} // namespace knead
