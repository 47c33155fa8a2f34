#pragma once

#include "core/geometry/triangle_mesh.h"

#include <span>

namespace knead {

/// How far a surface was moved.
struct SurfaceMove {
    double largest = 0;        ///< |x - X| [m]
    double mean = 0;           ///< the same, by area at rest [m]
    Vec3 where = Vec3::Zero(); ///< X of the largest [m]
};

/// @param places where the vertices are now, one each
SurfaceMove surfaceMove(const TriangleMesh& rest, std::span<const Vec3> places);

} // namespace knead
