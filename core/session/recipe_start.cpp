#include "core/session/recipe_start.h"

#include "core/session/recipe_progress.h"
#include "core/session/recipe_script.h"

#include <utility>

namespace knead {

namespace {

/// Parts that were turned and moved, or deformed, are in no file.
ImportChoices choicesOf(const Recipe& recipe, const RecipeScene& scene)
{
    ImportChoices choices{.paths = {}, .options = recipe.import};
    if (recipe.extraParts.empty() && recipe.deformations.empty()) {
        choices.paths.push_back(recipe.part);
        choices.paths.insert(choices.paths.end(), recipe.partsBeside.begin(), recipe.partsBeside.end());
    }
    const double spacing = scene.scene.bodies.front().aggregate->lattice.spacing;
    choices.spacing = SpacingChoice{SpacingChoice::Kind::Length, spacing};
    choices.touching = recipe.touching;
    choices.fillsOpenParts = recipe.fillsOpenParts;
    return choices;
}

void addFaces(const RecipeFixture& fixture, const RecipeScene& scene, std::vector<FaceFixture>& fixtures)
{
    if (fixture.faces.empty())
        return;
    for (const BodyId body : bodiesNamed(fixture.body, scene.parts(), Message::verbatim(fixture.name)))
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

} // namespace

RecipeStart recipeStart(Recipe wanted, const RecipeFiles& files, TaskControl& control)
{
    auto ready = std::make_shared<ReadyRecipe>();
    ready->recipe = std::move(wanted);
    ready->scene = buildScene(ready->recipe, files, control);
    checkEvents(ready->recipe, ready->scene);
    const auto& [recipe, scene] = *ready;
    RecipeStart start{.model = scene.model,
                      .choices = choicesOf(recipe, scene),
                      .start = {.scene = scene.scene, .partOfBody = scene.partOfBody()},
                      .fixtures = faceFixtures(recipe, scene),
                      .script = {},
                      .exports = recipe.exports,
                      .warnings = scene.warnings};
    if (recipe.analysis == Analysis::equilibrium)
        start.warnings.push_back(Message(
            "Recipe", "This recipe asks for balance without inertia, which \"knead run\" finds. Play carries it out "
                      "as motion in time."));
    if (!recipe.probes.empty())
        start.warnings.push_back(Message("Recipe",
                                         "The probes of this recipe are read by \"knead run\". Put probes on the "
                                         "part to read them here."));
    start.script = scriptOf(std::move(ready));
    return start;
}

} // namespace knead
