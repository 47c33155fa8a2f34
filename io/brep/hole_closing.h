#pragma once

#include "core/geometry/triangle_mesh.h"

#include <cstddef>

namespace knead {

struct HoleClosing {
    TriangleMesh mesh;
    std::size_t holes = 0;
    double addedShare = 0; ///< of the area of the mesh
};

/// Closes holes with flat patches where one may: the hole is below 1 % of the area, and its border within a tenth of
/// its width of a plane. All other holes stay, since something is missing there.
/// @param largestShare of the area of the mesh that a hole may be
HoleClosing closeHoles(TriangleMesh mesh, double largestShare = 0.01);

} // namespace knead
