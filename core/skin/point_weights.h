#pragma once

#include "core/skin/neighborhood.h"
#include "core/skin/shape_functions.h"

#include <vector>

namespace knead {

/// How much each object of a neighborhood carries a point of the skin, in so far as it belongs to the material around it: shape
/// functions with a support that holds as much of the objects everywhere: about 3 spacings below a flat face, 3.8 at sharp edges,
/// 4.2 at corners, more for points far from all objects, on fins too thin for the lattice to hold any. They sum to 1 and change
/// continuously as the point moves.
/// @param coordinates of the point in the lattice
std::vector<double> pointWeights(const Neighborhood& around, const Vec3& coordinates);

/// The same with slopes, in lattice coordinates: per spacing and along the lattice's axes. Its support is narrower, about 2.6
/// spacings below a flat face: slopes get the better.
ShapeSlopes pointSlopes(const Neighborhood& around, const Vec3& coordinates);

} // namespace knead
