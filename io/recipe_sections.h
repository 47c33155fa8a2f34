#pragma once

#include "io/json_reader.h"
#include "io/recipe.h"

#include <string>
#include <vector>

namespace knead {

// The sections of a recipe, one reader each. All of them throw as readRecipe() does.

constexpr double strongestGravity = 1e4; ///< [m/s^2], a thousand times that of the earth

RecipeMaterial readRecipeMaterial(const JsonNode& node, const std::vector<MaterialPreset>& presets);
RecipeExtraPart readRecipeExtraPart(const JsonNode& node, const std::string& recipePath);
RecipeBody readRecipeBody(const JsonNode& node, const std::string& name);
RecipeFixture readRecipeFixture(const JsonNode& node);
RecipeMaterialRegion readRecipeMaterialRegion(const JsonNode& node, const std::vector<MaterialPreset>& presets);
RecipeManipulator readRecipeManipulator(const JsonNode& node, const std::string& recipePath);
RecipeEvent readRecipeEvent(const JsonNode& node, const std::vector<MaterialPreset>& presets, double duration);
RecipeExport readRecipeExport(const JsonNode& node);

/// "deformable", "rigid" or "glue".
BodyKind readBodyKind(const JsonNode& node);

} // namespace knead
