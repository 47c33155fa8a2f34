#pragma once

#include "io/json_reader.h"
#include "io/recipe.h"

#include <string>
#include <vector>

namespace knead {

// The sections of a recipe, one reader each. All of them throw as readRecipe() does.

constexpr double millimeter = 1e-3;      ///< [m]
constexpr double strongestGravity = 1e4; ///< [m/s^2], a thousand times that of the earth

RecipeMaterial readRecipeMaterial(const JsonNode& node, const std::vector<MaterialPreset>& presets);
RecipeFixture readRecipeFixture(const JsonNode& node);
Manipulator readRecipeManipulator(const JsonNode& node);
RecipeEvent readRecipeEvent(const JsonNode& node, const std::vector<MaterialPreset>& presets, double duration);
RecipeExport readRecipeExport(const JsonNode& node);

/// Three numbers, none larger than `limit` in size.
Vec3 readVector(const JsonNode& node, double limit);

/// "stl" for "out/Bar.STL"; empty without an ending.
std::string lowerCaseEnding(const std::string& file);

} // namespace knead
