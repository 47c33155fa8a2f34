#pragma once

#include "core/geometry/triangle_mesh.h"

namespace knead {

/// Integral properties of a surface and of the solid it bounds.
struct MassProperties {
    double volume = 0;            ///< [m^3], negative when the triangles face inwards
    double area = 0;              ///< [m^2]
    Vec3 centroid = Vec3::Zero(); ///< of the solid [m]; the middle of the box when the volume is 0
    Box box;                      ///< [m]
};

/// Exact for the triangles given, by the divergence theorem about the middle of the box.
MassProperties massProperties(const TriangleMesh& mesh);

/// True when every edge is used once in each direction: a closed, consistently oriented surface.
bool isWatertight(const TriangleMesh& mesh);

} // namespace knead
