#pragma once

#include "core/geometry/vec3.h"

#include <span>

namespace knead {

/// A rigid motion x -> turn (x - from) + to, and how well it fits.
struct RigidFit {
    Mat3 turn = Mat3::Identity(); ///< a rotation, no mirror image
    Vec3 from = Vec3::Zero();
    Vec3 to = Vec3::Zero();
    double deviation = 0; ///< largest distance between a point and where the motion takes it
};

/// The rigid motion that takes points `before` to places `after` with the least sum of squares. The identity for no points.
/// @pre as many points before as after
RigidFit fitRigidMotion(std::span<const Vec3> before, std::span<const Vec3> after);

/// How far points have moved from where a rigid motion would have taken them [m]. 0 for no points.
inline double deviationFromRigidMotion(std::span<const Vec3> before, std::span<const Vec3> after)
{
    return fitRigidMotion(before, after).deviation;
}

} // namespace knead
