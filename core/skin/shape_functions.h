#pragma once

#include "core/geometry/vec3.h"

#include <span>
#include <vector>

namespace knead {

/// Moving-least-squares shape functions at the origin for nodes at `offsets`, with the Wendland C2 weight
/// (1 - r)^4 (4 r + 1) of the given support. They reproduce quadratic functions, with a wider support where too few
/// nodes are near; where the nodes do not determine one, linear functions; where they do not determine that either,
/// constants. They sum to 1; nodes beyond the support get 0.
/// @pre at least one node is closer than the support
std::vector<double> shapeFunctions(std::span<const Vec3> offsets, double support);

} // namespace knead
