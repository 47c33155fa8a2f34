#pragma once

#include "core/session/recipe.h"
#include "core/session/recipe_scene.h"
#include "core/simulation/scripted_events.h"

#include <memory>

namespace knead {

/// A recipe that is ready to run, kept as long as anybody plays it.
struct ReadyRecipe {
    Recipe recipe;
    RecipeScene scene;
};

/// What a recipe does while time runs, for a window: its events, each before the step at which `knead run` carries it out, and
/// its end. Played without a person who does something else, it comes to the same bits as `knead run`.
ScriptedEventsMaker scriptOf(std::shared_ptr<const ReadyRecipe> ready);

} // namespace knead
