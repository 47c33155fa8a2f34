#pragma once

#include "core/geometry/vec3.h"

#include <span>
#include <vector>

namespace knead {

/// Completes a field on a grid of lines smoothly where it is not known: the integral of the squares of its second derivatives
/// along all lines becomes least, which goes on linearly from what is known. A field without any known value is left alone.
/// @param u,v places of the grid lines, ascending, in the same unit of length
/// @param known one per value
/// @param values u.size() x v.size() of them, those of a u beside each other; unknown ones are written
void completeGrid(std::span<const double> u, std::span<const double> v, const std::vector<bool>& known,
                  std::span<Vec3> values);

} // namespace knead
