#pragma once

#include "core/model/part.h"

namespace knead {

/// Moves all parts of a model, with their exact shapes [m].
/// @throws Problem when these are something else
void moveParts(Model& model, const Vec3& by);

} // namespace knead
