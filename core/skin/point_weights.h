#pragma once

#include "core/aggregate/lattice.h"

#include <span>
#include <vector>

namespace knead {

/// How much each of some objects carries a point of the skin: shape functions with a support of 2.6 spacings, wider for points
/// far from all objects, on fins too thin for the lattice to hold any. They sum to 1.
/// @param coordinates of the point in the lattice
std::vector<double> pointWeights(const Lattice& lattice, std::span<const ObjectIndex> objects, const Vec3& coordinates);

} // namespace knead
