#include "app/recipe_services.h"

#include "app/recipe_progress.h"
#include "app/recipe_script.h"
#include "app/resources.h"
#include "core/model/part_tree.h"
#include "io/files/safe_file.h"
#include "io/material_library.h"
#include "io/recipe/recipe_of_project.h"

#include <filesystem>
#include <utility>

namespace knead {

namespace {

/// All of its bodies as one model.
std::shared_ptr<const Model> modelOf(const Recipe& recipe, const RecipeScene& scene)
{
    auto model = std::make_shared<Model>(scene.source);
    model->file = recipe.part;
    model->parts = scene.parts;
    std::vector<const Part*> parts;
    for (const Part& part : model->parts)
        parts.push_back(&part);
    model->tree = treeOfPaths(parts);
    takeProducts(scene.source.tree, model->tree);
    return model;
}

/// Parts that were turned and moved are in no file.
ImportChoices choicesOf(const Recipe& recipe, const RecipeScene& scene)
{
    ImportChoices choices{.paths = {}, .options = recipe.import};
    if (recipe.extraParts.empty()) {
        choices.paths.push_back(recipe.part);
        choices.paths.insert(choices.paths.end(), recipe.partsBeside.begin(), recipe.partsBeside.end());
    }
    const double spacing = scene.scene.bodies.front().aggregate->lattice.spacing;
    choices.spacing = SpacingChoice{SpacingChoice::Kind::Length, spacing};
    choices.touching = recipe.touching;
    choices.fillsOpenParts = recipe.fillsOpenParts;
    return choices;
}

ProjectStart startOf(const RecipeScene& scene)
{
    ProjectStart start{.scene = scene.scene, .partOfBody = {}};
    for (std::size_t part = 0; part < scene.parts.size(); ++part)
        start.partOfBody.push_back(part);
    return start;
}

void addFaces(const RecipeFixture& fixture, const RecipeScene& scene, std::vector<FaceFixture>& fixtures)
{
    if (fixture.faces.empty())
        return;
    for (const BodyId body : bodiesNamed(fixture.body, scene.parts, fixture.name))
        fixtures.push_back({.key = static_cast<std::uint32_t>(fixtures.size() + 1),
                            .name = fixture.name,
                            .body = body,
                            .faces = fixture.faces,
                            .id = {}});
}

std::vector<FaceFixture> faceFixtures(const Recipe& recipe, const RecipeScene& scene)
{
    std::vector<FaceFixture> fixtures;
    for (const RecipeFixture& fixture : recipe.fixtures)
        addFaces(fixture, scene, fixtures);
    for (const RecipeEvent& event : recipe.events)
        if (const auto* add = std::get_if<AddRecipeFixture>(&event.action))
            addFaces(add->fixture, scene, fixtures);
    return fixtures;
}

RecipeStart open(const std::string& path, TaskControl& control)
{
    auto ready = std::make_shared<ReadyRecipe>();
    ready->recipe = readRecipe(path, readMaterials(materialsFile()));
    ready->scene = buildScene(ready->recipe, control);
    checkEvents(ready->recipe, ready->scene);
    const auto& [recipe, scene] = *ready;
    RecipeStart start{.model = modelOf(recipe, scene),
                      .choices = choicesOf(recipe, scene),
                      .start = startOf(scene),
                      .fixtures = faceFixtures(recipe, scene),
                      .script = {},
                      .warnings = scene.warnings};
    if (recipe.analysis == Analysis::equilibrium)
        start.warnings.push_back(
            "This recipe asks for balance without inertia, which \"knead run\" finds. Play carries it "
            "out as motion in time.");
    start.script = scriptOf(std::move(ready));
    return start;
}

std::vector<std::string> write(const std::string& path, const Project& project, const std::string& projectPath)
{
    RecipeOfProject recipe =
        recipeOfProject(project, {.recipePath = path, .projectPath = projectPath}, readMaterials(materialsFile()));
    writeFileSafely(path, recipe.text);
    return std::move(recipe.remarks);
}

} // namespace

RecipeServices recipeServices()
{
    return {.ending = "json", .open = open, .write = write};
}

} // namespace knead
