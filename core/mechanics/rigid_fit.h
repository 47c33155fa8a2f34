#pragma once

#include "core/geometry/vec3.h"

#include <span>

namespace knead {

/// How far points have moved from where a rigid motion would have taken them: the largest distance to the motion that fits
/// all of them best [m]. 0 for no points.
/// @pre as many points before as after
double deviationFromRigidMotion(std::span<const Vec3> before, std::span<const Vec3> after);

} // namespace knead
