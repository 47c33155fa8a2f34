#include "app/recipe_services.h"

#include "app/part_application.h"
#include "app/recipe_files.h"
#include "app/resources.h"
#include "core/message/message.h"
#include "io/files/safe_file.h"
#include "io/material_library.h"
#include "io/recipe/recipe_of_project.h"
#include "io/recipe/recipe_reader.h"

#include <filesystem>
#include <utility>

namespace knead {

namespace {

RecipeStart open(const std::string& path, TaskControl& control)
{
    return recipeStart(readRecipe(path, readMaterials(materialsFile())), recipeFiles(), control);
}

std::vector<Message> write(const std::string& path, const Project& project, const std::string& projectPath)
{
    RecipeOfProject recipe =
        recipeOfProject(project, {.recipePath = path, .projectPath = projectPath}, readMaterials(materialsFile()));
    writeFileSafely(path, recipe.text);
    return std::move(recipe.remarks);
}

AppliedPart apply(const std::string& part, const Project& project, const std::string& projectPath,
                  const TransferOptions& options, TaskControl& control)
{
    constexpr double found = 0.6; // of the progress
    TaskPortion finding(control, 0, found);
    PartTransfer transfer = transferProject(project, projectPath, part, options, finding);
    TaskPortion starting(control, found, 1);
    return {recipeStart(std::move(transfer.recipe), recipeFiles(), starting), std::move(transfer.report)};
}

} // namespace

RecipeServices recipeServices()
{
    return {.ending = "json", .open = open, .write = write, .apply = apply};
}

} // namespace knead
