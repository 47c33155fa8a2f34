#pragma once

#include "core/geometry/vec3.h"

#include <span>
#include <vector>

namespace knead {

/// A force at a place.
struct PlacedForce {
    Vec3 place = Vec3::Zero(); ///< [m]
    Vec3 force = Vec3::Zero(); ///< [N]
};

/// Shares forces out to nodes: each to the nearest eight, with weights w of least sum w^2 / v that keep the force and its torque
/// about every point, sum w = 1 and sum w x = place, v falling with distance. Where the nodes lie so that this takes weights beyond
/// 2, as on one side of the place only, the torque is not kept.
/// @param spacing about as far as nodes lie apart [m], > 0
/// @return per node [N]; all zero where there are no nodes
std::vector<Vec3> sharedForces(std::span<const PlacedForce> forces, std::span<const Vec3> nodes, double spacing);

} // namespace knead
