#pragma once

#include "core/geometry/vec3.h"

#include <vector>

namespace knead {

/// Displacements u(X) known at scattered points: what a simulation program, a measurement or a person's work gave.
struct DisplacementField {
    std::vector<Vec3> nodes;         ///< X, no two in one place [m]
    std::vector<Vec3> displacements; ///< one per node [m]

    bool isEmpty() const { return nodes.empty(); }
};

} // namespace knead
