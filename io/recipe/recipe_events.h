#pragma once

#include "core/session/recipe.h"
#include "io/recipe/recipe_fields.h"

namespace knead::recipe_keys {

// Events of a recipe: what changes on the way.

/// One event, or several: a path is one for each of its places.
/// @param latest that no time of an event may exceed [s]
std::vector<RecipeEvent> readEvent(const JsonNode& node, double latest, const Context& context);

/// What happens, with the key that says so. @pre it is no path
void putAction(ObjectText& event, const RecipeAction& action, const Context& context);

} // namespace knead::recipe_keys
