#pragma once

#include "core/geometry/triangle_mesh.h"

#include <array>
#include <vector>

namespace knead {

/// Unit normals for the three corners of each triangle.
using CornerNormals = std::vector<std::array<Vec3, 3>>;

/// Smooth within a CAD face, and across triangles that meet at less than 30 degrees; sharp otherwise. Averages are
/// weighted by the angle of the corner, so that they do not depend on how a face was cut into triangles.
CornerNormals cornerNormals(const TriangleMesh& mesh);

} // namespace knead
