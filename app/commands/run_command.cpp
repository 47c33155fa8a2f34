#include "app/commands/run_command.h"

#include "app/commands/force_report.h"
#include "app/complaint.h"
#include "app/exit_status.h"
#include "app/hexadecimal.h"
#include "app/recipe_runner.h"
#include "app/recipe_scene.h"
#include "app/resources.h"
#include "app/set_argument.h"
#include "app/terminal_control.h"
#include "app/thread_limit.h"
#include "io/export/job_file.h"
#include "io/material_library.h"
#include "io/project/project_file.h"
#include "io/project/recipe_of_project.h"
#include "io/recipe.h"
#include "io/worker/child_process.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <iterator>
#include <memory>
#include <mutex>
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
    std::string forcesFile;            ///< for a table of forces; empty: none
    bool json = false;
    bool endsWithParent = false;
};

nlohmann::ordered_json list(const Vec3& vector)
{
    return {vector.x(), vector.y(), vector.z()};
}

void printJson(const RunReport& report)
{
    const EnergyLedger& energy = report.energy;
    nlohmann::ordered_json json{
        {"objects", report.objects},
        {"connections", report.connections},
        {"broken", report.broken},
        {"joints", report.joints},
        {"components", report.components},
        {"added_mass", report.addedMass},
        {"steps", report.steps},
        {"time_step_s", report.timeStep},
        {"simulated_s", report.simulated},
        {"wall_s", report.wall},
        {"ratio", report.ratio()},
        {"state_hash", hexadecimal(report.stateHash)},
        {"integrator", report.integrator},
        {"energy_j",
         {{"kinetic", energy.kinetic},
          {"elastic", energy.elastic},
          {"gravity", energy.gravity},
          {"contact", energy.contact},
          {"tool_work", energy.toolWork},
          {"viscous", energy.viscous},
          {"friction", energy.friction},
          {"plastic", energy.plastic},
          {"fracture", energy.fracture},
          {"numerical", energy.numerical},
          {"imbalance", energy.imbalance}}},
        {"bodies", nlohmann::ordered_json::array()},
        {"tools", nlohmann::ordered_json::array()},
        {"files", report.files},
        {"quality", qualityToJson(report.quality)},
        {"warnings", report.warnings},
    };
    for (const BodyMotion& motion : report.motions)
        json["bodies"].push_back({{"name", motion.name},
                                  {"mean_displacement_mm", list(1000 * motion.meanDisplacement)},
                                  {"largest_displacement_mm", 1000 * motion.largestDisplacement},
                                  {"von_mises_stress",
                                   {{"largest_pa", motion.stress.largest},
                                    {"error_share", motion.stress.error},
                                    {"at_rest_mm", list(1000 * motion.stress.place)}}}});
    for (const ToolState& tool : report.tools)
        json["tools"].push_back({{"name", tool.name},
                                 {"force_n", list(tool.force)},
                                 {"peak_force_n", tool.peakForce},
                                 {"torque_nm", list(tool.torque)}});
    addForces(json, report);
    json["exports"] = nlohmann::ordered_json::array();
    for (const ExportReport& exported : report.exports)
        json["exports"].push_back(nlohmann::ordered_json::parse(reportToJson(exported)));
    std::cout << json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
}

/// What is worth a line only when it happened.
void printDamage(const RunReport& report)
{
    if (report.broken > 0 || report.joints > 0 || report.components != report.bodies)
        std::printf("%zu connections broke, %zu joints hold, %zu %s of material\n", report.broken, report.joints,
                    report.components, report.components == 1 ? "piece" : "pieces");
    if (report.addedMass > 0)
        std::printf("mass scaling added %.3g %% of the mass\n", 100 * report.addedMass);
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
    for (const ToolState& tool : report.tools)
        std::printf("tool %s: force (%.3g, %.3g, %.3g) N, peak %.3g N\n", tool.name.c_str(), tool.force.x(),
                    tool.force.y(), tool.force.z(), tool.peakForce);
    printForces(report);
    for (const std::string& file : report.files)
        std::printf("wrote %s\n", file.c_str());
    for (const ExportReport& exported : report.exports)
        for (const std::string& line : linesOf(exported))
            std::printf("%s\n", line.c_str());
}

int carryOut(const Recipe& recipe, const RunOptions& options)
{
    const ThreadLimit limit(options.threads);
    TerminalControl control;
    try {
        std::mutex saying;
        std::vector<std::string> said;
        const auto say = [&](const std::string& sentence) {
            control.say("knead: warning: " + sentence);
            const std::lock_guard lock(saying);
            said.push_back(sentence);
        };
        const RunReport report = runRecipe(recipe, options.outputFolder, control, say, options.forcesFile);
        control.clear();
        for (const std::string& warning : report.warnings)
            if (std::find(said.begin(), said.end(), warning) == said.end())
                std::cerr << "knead: warning: " << warning << '\n';
        options.json ? printJson(report) : printSummary(report);
        return exit_status::done;
    } catch (const Cancelled&) {
        control.clear();
        return complain("interrupted; no file was left half-written.", exit_status::interrupted);
    } catch (const UnusableInput& error) {
        control.clear();
        return complain(error.what(), exit_status::wrongUse);
    } catch (const std::exception& error) {
        control.clear();
        return complain(error.what(), exit_status::failed);
    }
}

/// What was done in a project, with the parts that it keeps. Where something is changed, what was set before the first step
/// is the start, so that the change counts.
Recipe recipeOfSession(const RunOptions& options, const std::vector<MaterialPreset>& presets,
                       const std::vector<RecipeOverride>& changes)
{
    Project project = readProject(options.recipe);
    if (!changes.empty())
        project = withSettingsFirst(std::move(project));
    const RecipeOfProjectChoices choices{
        .recipePath = options.recipe, .projectPath = options.recipe, .namesProject = true};
    const RecipeOfProject recipe = recipeOfProject(project, choices, presets);
    for (const std::string& remark : recipe.remarks)
        std::cerr << "knead: warning: " << remark << '\n';
    return readRecipeText(recipe.text, options.recipe, presets, changes);
}

Recipe recipeOf(const RunOptions& options)
{
    std::vector<RecipeOverride> changes;
    std::transform(options.settings.begin(), options.settings.end(), std::back_inserter(changes), parseOverride);
    const std::vector<MaterialPreset> presets = readMaterials(materialsFile());
    return isProjectFile(options.recipe) ? recipeOfSession(options, presets, changes)
                                         : readRecipe(options.recipe, presets, changes);
}

int run(const RunOptions& options)
{
    if (options.endsWithParent)
        endWithParent();
    Recipe recipe;
    try {
        recipe = recipeOf(options);
    } catch (const std::exception& error) {
        return complain(error.what(), exit_status::wrongUse);
    }
    return carryOut(recipe, options);
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
        ->add_option("--csv", options->forcesFile,
                     "Write forces and moments of fixtures, tools and loads over time as a table")
        ->type_name("FILE");
    command->add_option("--threads", options->threads, "Number of threads; the result is the same for any")
        ->type_name("N")
        ->check(CLI::Range(1U, 1024U));
    command->add_flag("--json", options->json, "Print the report as JSON");
    command->add_flag("--end-with-parent", options->endsWithParent, "For runs of a sweep")->group("");
    command->callback([options, &exitStatus] { exitStatus = run(*options); });
}

} // namespace knead
