#include "app/commands/recipe_command.h"

#include "app/cad_process.h"
#include "app/exit_status.h"
#include "app/first_recipe.h"
#include "app/terminal_control.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>

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

void writeText(const std::string& path, const std::string& text)
{
    const std::string unfinished = path + ".part";
    std::ofstream file(unfinished);
    file << text;
    file.close();
    std::error_code error;
    if (file)
        fs::rename(unfinished, path, error);
    if (!file || error) {
        fs::remove(unfinished, error);
        throw std::runtime_error(path + ": the file cannot be written; choose another place with --output.");
    }
}

int recipe(const RecipeOptions& options)
{
    std::string text;
    TerminalControl control;
    try {
        const Model model = importInChild(options.file, {}, control);
        control.clear();
        text = firstRecipe(model, options.output.empty() ? fs::absolute(options.file).lexically_normal().string()
                                                         : partSeenFrom(options.output, options.file));
    } catch (const Cancelled&) {
        control.clear();
        std::cerr << "knead: interrupted.\n";
        return exit_status::interrupted;
    } catch (const std::exception& error) {
        control.clear();
        std::cerr << "knead: " << error.what() << '\n';
        return exit_status::wrongUse;
    }
    try {
        options.output.empty() ? void(std::cout << text) : writeText(options.output, text);
    } catch (const std::exception& error) {
        std::cerr << "knead: " << error.what() << '\n';
        return exit_status::failed;
    }
    return exit_status::done;
}

} // namespace

void addRecipeCommand(CLI::App& program, int& exitStatus)
{
    auto options = std::make_shared<RecipeOptions>();
    CLI::App* command = program.add_subcommand("recipe", "Write a recipe to start from: a block pressed into a part");
    command->add_option("FILE", options->file, "CAD or mesh file")->required();
    command->add_option("--output", options->output, "Recipe to write; without it the recipe goes to the terminal")
        ->type_name("RECIPE");
    command->callback([options, &exitStatus] { exitStatus = recipe(*options); });
}

} // namespace knead
