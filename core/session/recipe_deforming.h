#pragma once

#include "core/model/part.h"
#include "core/session/recipe.h"
#include "core/session/recipe_files.h"
#include "core/task/task_control.h"

#include <vector>

namespace knead {

/// Parts as the deformations of a recipe leave them.
/// @param warnings gets what there is to say of fields, and of parts that did not come out sound
/// @throws std::runtime_error, in a sentence: no such body or face, a field that cannot be read, a fold. @throws Cancelled
Model deformedParts(Model model, const Recipe& recipe, const RecipeFiles& files, std::vector<Message>& warnings,
                    TaskControl& control);

} // namespace knead
