#pragma once

#include "core/aggregate/material.h"
#include "core/session/recipe.h"

#include <string>
#include <vector>

namespace knead {

/// A recipe as JSON that readRecipe() takes for the same one. Where tools go from place to place by time, each place is an event.
/// @param recipePath where it will lie: files are named as seen from there; empty: by their whole paths
/// @param presets bundled materials, which are named
/// @throws Problem for what it cannot say: parts beside the first that were placed, pictures to write
std::string recipeText(const Recipe& recipe, const std::string& recipePath, const std::vector<MaterialPreset>& presets);

} // namespace knead
