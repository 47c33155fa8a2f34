#pragma once

#include "core/geometry/vec3.h"

namespace knead {

/// The least turn that makes `from` point as `onto` does: about their common normal, and about some normal of theirs where they are
/// opposite. Any lengths but 0. In a file of its own: Eigen's takes the compiler seconds wherever it is used.
Quaternion turnOnto(const Vec3& from, const Vec3& onto);

} // namespace knead
