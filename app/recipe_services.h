#pragma once

#include "ui/project/recipe_services.h"

namespace knead {

/// For the window.
RecipeServices recipeServices();

} // namespace knead
