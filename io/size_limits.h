#pragma once

#include "core/model/part.h"

#include <string>

namespace knead {

/// Whether a box is finite and no part of it is farther than 100 km from the origin, where positions lose their digits.
bool isWithinReach(const Box& box);

/// @throws std::runtime_error, in a sentence about `path`, when the model is empty, too large, too small or too far
///         away.
void checkPlaceAndSize(const std::string& path, const Model& model);

} // namespace knead
