#pragma once

#include "core/model/part.h"

#include <string>

namespace knead {

/// A recipe to start from, as JSON text: FirstPress, in silicone rubber. Bodies that touch are glued.
/// @param part how the recipe names the file of the model
/// @throws std::runtime_error, in a sentence, when no body is closed.
std::string firstRecipe(const Model& model, const std::string& part);

} // namespace knead
