#include "app/recipe_to_run.h"

#include "app/cad_process.h"
#include "app/resources.h"
#include "core/document/project.h"
#include "io/material_library.h"
#include "io/project/project_file.h"
#include "io/recipe/recipe_of_project.h"
#include "io/recipe/recipe_reader.h"

#include <utility>

namespace knead {

namespace {

RecipeToRun recipeOfSession(const std::string& path, const std::vector<MaterialPreset>& presets,
                            const std::vector<RecipeOverride>& changes)
{
    Project project = readProjectAfterTrial(path, TaskControl::none());
    if (!changes.empty())
        project = withSettingsFirst(std::move(project));
    const RecipeOfProjectChoices choices{.recipePath = path, .projectPath = path, .namesProject = true};
    RecipeOfProject recipe = recipeOfProject(project, choices, presets);
    return {readRecipeText(recipe.text, path, presets, changes), std::move(recipe.remarks)};
}

} // namespace

RecipeToRun recipeToRun(const std::string& path, const std::vector<RecipeOverride>& changes)
{
    const std::vector<MaterialPreset> presets = readMaterials(materialsFile());
    if (isProjectFile(path))
        return recipeOfSession(path, presets, changes);
    return {readRecipe(path, presets, changes), {}};
}

} // namespace knead
