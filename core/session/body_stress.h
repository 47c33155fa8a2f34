#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/simulation/snapshot.h"

namespace knead {

/// The largest von Mises stress at the skin of a body.
struct BodyStress {
    double largest = 0;        ///< [Pa]; 0 for a rigid body
    double error = 0;          ///< about how wrong it may be by the resolution, as a share of it: 0.08 is +-8 %
    Vec3 place = Vec3::Zero(); ///< where, at rest [m]
};

/// @param surface the body's, at rest
BodyStress bodyStress(const TriangleMesh& surface, const Snapshot& snapshot, BodyId body);

} // namespace knead
