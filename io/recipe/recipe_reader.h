#pragma once

#include "core/session/recipe.h"
#include "io/recipe/recipe_override.h"

#include <string>
#include <vector>

namespace knead {

/// Reads and checks a recipe; resources/examples/README.md documents every key. Nothing is guessed: an unknown key, a
/// wrong type or a number out of range is an error. Whether the names of bodies and faces exist is seen when the part
/// is opened.
/// @param changes made to what the file says before it is checked
/// @throws std::runtime_error, in a sentence: the file, the place in it, and what is allowed there.
Recipe readRecipe(const std::string& path, const std::vector<MaterialPreset>& presets,
                  const std::vector<RecipeOverride>& changes = {});

/// The same of a text that nobody sees, as if it lay at the path.
Recipe readRecipeText(const std::string& text, const std::string& path, const std::vector<MaterialPreset>& presets,
                      const std::vector<RecipeOverride>& changes = {});

} // namespace knead
