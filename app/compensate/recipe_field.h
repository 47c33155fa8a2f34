#pragma once

#include "core/session/compensation_study.h"
#include "core/task/task_control.h"

#include <string>

namespace knead {

/// A recipe to be carried out on another part than its own.
struct RecipeOfShape {
    std::string recipe; ///< path
    std::string part;   ///< path of the part that takes the place of the recipe's
    std::string field;  ///< path of the table to write: where each point of the part was, and how far it has moved
    double spacing = 0; ///< of points of its surface [m]; 0: that of the objects
};

/// Carries a recipe out and writes what it did to the part; its exports are not written.
/// @throws std::runtime_error, in a sentence. @throws Cancelled
void writeFieldOfRecipe(const RecipeOfShape& what, TaskControl& control);

} // namespace knead
