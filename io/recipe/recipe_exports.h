#pragma once

#include "core/session/recipe.h"
#include "io/recipe/recipe_fields.h"

namespace knead::recipe_keys {

/// A file that a recipe writes at the end: which keys it has follows from its name.
RecipeExport readExport(const JsonNode& node, const Context& context);

} // namespace knead::recipe_keys
