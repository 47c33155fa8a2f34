#pragma once

#include "core/model/part.h"

#include <string>

namespace knead {

/// A recipe to start from, as JSON text. What is at least twice as long as thick is held at one end and bent by a block near
/// the other; what is compact is held at the bottom and squeezed. The stroke is a share of the size, so that any part moves
/// visibly and none is crushed; bodies that touch are glued.
/// @param part how the recipe names the file of the model
/// @throws std::runtime_error, in a sentence, when no body is closed.
std::string firstRecipe(const Model& model, const std::string& part);

} // namespace knead
