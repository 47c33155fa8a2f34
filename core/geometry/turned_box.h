#pragma once

#include "core/geometry/vec3.h"

#include <array>
#include <limits>
#include <span>

namespace knead {

/// A box of any orientation, in single precision.
struct TurnedBox {
    Eigen::Vector3f center = Eigen::Vector3f::Zero();
    Eigen::Matrix3f axes = Eigen::Matrix3f::Identity(); ///< columns, of unit length; the first across what is inside
    Eigen::Vector3f half = Eigen::Vector3f::Constant(-std::numeric_limits<float>::infinity()); ///< sides along the axes

    Eigen::AlignedBox3f upright; ///< around the same, with sides along x, y, z

    bool isEmpty() const { return half.x() < 0; }
};

/// A tight box around triangles near a plane, given by their corners; empty when there are none.
TurnedBox boxAround(std::span<const std::array<Eigen::Vector3f, 3>> triangles);

/// The same around boxes; empty ones do not count.
TurnedBox boxAround(const std::array<TurnedBox, 4>& boxes);

} // namespace knead
