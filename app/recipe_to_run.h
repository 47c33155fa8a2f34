#pragma once

#include "core/message/message.h"
#include "core/session/recipe.h"
#include "io/recipe/recipe_override.h"

#include <string>
#include <vector>

namespace knead {

/// A recipe to be carried out, and what it leaves out of a project.
struct RecipeToRun {
    Recipe recipe;
    std::vector<Message> remarks;
};

/// A recipe, or what was done in a project, with the parts that it keeps. Where something of a project is changed, what was set before
/// the first step is the start, so that the change counts.
/// @throws std::runtime_error, in a sentence
RecipeToRun recipeToRun(const std::string& path, const std::vector<RecipeOverride>& changes);

} // namespace knead
