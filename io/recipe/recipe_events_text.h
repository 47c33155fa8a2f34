#pragma once

#include "io/recipe/recipe_words.h"

#include <span>
#include <string>
#include <vector>

namespace knead {

/// One gesture of a session.
struct RecipeGesture {
    std::string name;
    std::span<const RecordedCommand> commands;
};

/// Commands as events of a recipe, one item each; a tool that goes from place to place is one.
/// @throws Problem, for what a recipe cannot say
std::vector<std::string> eventTexts(const RecipeWords& words, std::span<const RecipeGesture> gestures);

} // namespace knead
