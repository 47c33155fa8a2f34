#pragma once

#include "core/aggregate/material.h"
#include "core/model/part.h"
#include "core/task/task_control.h"

#include <string>

namespace knead {

/// A recipe to start from, as JSON text: FirstPress, filled and made of what the window would take. Bodies that touch are glued.
/// @param part how the recipe names the file of the model
/// @param material that startMaterialId names
/// @throws std::runtime_error, in a sentence, when no body is closed; Cancelled
std::string firstRecipe(const Model& model, const std::string& part, const Material& material, TaskControl& control);

} // namespace knead
