#include "app/commands/recipe_command.h"

#include "app/cad_process.h"
#include "app/commands/carry_out.h"
#include "app/commands/command_output.h"
#include "app/exit_status.h"
#include "app/first_recipe.h"
#include "app/resources.h"
#include "core/message/message.h"
#include "io/material_library.h"
#include "io/project/project_file.h"
#include "io/recipe/recipe_of_project.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace knead {

namespace fs = std::filesystem;

namespace {

struct RecipeOptions {
    std::string file;
    std::string output; ///< empty: stdout
};

/// How a recipe names its part: seen from the folder of the recipe, since both may move together.
std::string partSeenFrom(const std::string& recipe, const std::string& part)
{
    const fs::path folder = fs::absolute(recipe).parent_path();
    return fs::absolute(part).lexically_normal().lexically_proximate(folder.lexically_normal()).string();
}

std::string recipeOfPart(const RecipeOptions& options, TerminalControl& control)
{
    const Model model = importInChild(options.file, {}, control);
    return firstRecipe(model, options.output.empty() ? fs::absolute(options.file).lexically_normal().string()
                                                     : partSeenFrom(options.output, options.file));
}

/// @param remarks get what the recipe leaves out
std::string recipeOfSession(const RecipeOptions& options, TerminalControl& control, std::vector<Message>& remarks)
{
    RecipeOfProject recipe =
        recipeOfProject(readProjectAfterTrial(options.file, control),
                        {.recipePath = options.output, .projectPath = options.file}, readMaterials(materialsFile()));
    remarks = std::move(recipe.remarks);
    return recipe.text;
}

int recipe(const RecipeOptions& options)
{
    return carryOut([&](TerminalControl& control, int& failure) {
        std::vector<Message> remarks;
        const std::string text =
            isProjectFile(options.file) ? recipeOfSession(options, control, remarks) : recipeOfPart(options, control);
        control.clear();
        printWarnings(remarks);
        failure = exit_status::failed;
        putOut(options.output, text);
        return exit_status::done;
    });
}

} // namespace

void addRecipeCommand(CLI::App& program, int& exitStatus)
{
    auto options = std::make_shared<RecipeOptions>();
    CLI::App* command = program.add_subcommand(
        "recipe", "Write a recipe: to start from, a part bent or squeezed by a block; or what was done in a project");
    command->add_option("FILE", options->file, "CAD or mesh file, or a project saved by the window")->required();
    command->add_option("-o,--output", options->output, "Recipe to write; without it the recipe goes to the terminal")
        ->type_name("RECIPE");
    command->callback([options, &exitStatus] { exitStatus = recipe(*options); });
}

} // namespace knead
