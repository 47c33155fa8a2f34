#pragma once

#include "io/json/json_reader.h"
#include "io/recipe/recipe_reader.h"

#include <string>
#include <vector>

namespace knead {

// The sections of a recipe, one reader each. All of them throw as readRecipe() does.

/// The part of the recipe with the choices of its import.
void readRecipePart(const JsonNode& node, Recipe& recipe);
RecipeMaterial readRecipeMaterial(const JsonNode& node, const std::vector<MaterialPreset>& presets);
RecipeExtraPart readRecipeExtraPart(const JsonNode& node, const std::string& recipePath);
RecipeBody readRecipeBody(const JsonNode& node, const std::string& name);
RecipeFixture readRecipeFixture(const JsonNode& node);
RecipeLoad readRecipeLoad(const JsonNode& node);
RecipeMaterialRegion readRecipeMaterialRegion(const JsonNode& node, const std::vector<MaterialPreset>& presets);
RecipeManipulator readRecipeManipulator(const JsonNode& node, const std::string& recipePath);

/// Name, form and limits of a manipulator, as an event changes them.
RecipeManipulator readReshaping(const JsonNode& node, const std::string& recipePath);

/// How a grip turns.
GripTurn readGripTurn(const JsonNode& node);

/// Name, amount and ramp of a load, as an event changes them.
ChangeRecipeLoad readChangeOfLoad(const JsonNode& node);

/// What of a region says where it is: `body`, and one of `faces`, `box_mm` and `objects`.
RecipeRegion readRecipePlace(const JsonNode& node);

/// `objects` with `objects_in_body`; none without the key.
std::optional<RecipeObjects> readRecipeObjects(const JsonNode& node);

/// How a manipulator moves, by exactly one of the keys of motionKeys().
Motion readMotion(const JsonNode& node);
const std::vector<std::string>& motionKeys();

/// A place of a path: a manipulator sets out for it so many steps after the event.
struct PathRow {
    std::uint64_t step = 0;
    Pose target;
};
std::vector<PathRow> readPath(const JsonNode& node);

/// What events are checked against.
struct EventContext {
    const std::vector<MaterialPreset>& presets;
    const std::string& recipePath;
    double duration = 0; ///< that no time of an event may exceed [s]
};

/// One event, or several: a path is one for each of its places.
std::vector<RecipeEvent> readRecipeEvent(const JsonNode& node, const EventContext& context);
RecipeExport readRecipeExport(const JsonNode& node);

/// "deformable", "rigid" or "glue".
BodyKind readBodyKind(const JsonNode& node);

} // namespace knead
