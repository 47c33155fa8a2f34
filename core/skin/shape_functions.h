#pragma once

#include "core/geometry/vec3.h"

#include <span>
#include <vector>

namespace knead {

/// Moving-least-squares shape functions at the origin for nodes at `offsets`, with the weight (1 - r)^3 (3 r + 1) of the given
/// support, twice continuously differentiable (Wendland). They reproduce quadratic functions; where the nodes hardly determine
/// one, such as across a sheet of two layers, linear functions, with the second derivatives that they leave open kept small; where
/// they do not determine that either, constants. From one to the other they change by and by, so that they are continuous in the
/// offsets. They sum to 1; nodes beyond the support get 0.
/// @param shares by which the weights of the nodes are multiplied, from 0 to 1; all 1 if there are none
/// @pre at least one node with a share is closer than the support
std::vector<double> shapeFunctions(std::span<const Vec3> offsets, double support, std::span<const double> shares = {});

} // namespace knead
