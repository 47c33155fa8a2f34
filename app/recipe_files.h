#pragma once

#include "core/session/recipe_files.h"

namespace knead {

RecipeFiles recipeFiles();

} // namespace knead
