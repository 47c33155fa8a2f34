#pragma once

#include "core/geometry/triangle_mesh.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace knead {

/// A corner of a triangle.
struct MeshCorner {
    std::uint32_t triangle;
    std::uint32_t index; ///< 0..2
};

/// Unit normals for the three corners of each triangle.
using CornerNormals = std::vector<std::array<Vec3, 3>>;

/// Smooth within a CAD face, and across triangles that meet at less than 30 degrees; sharp otherwise. Averages are
/// weighted by the angle of the corner, so that they do not depend on how a face was cut into triangles.
CornerNormals cornerNormals(const TriangleMesh& mesh);

/// The same for the corners at one vertex. @param fan all of them
std::vector<Vec3> fanNormals(const TriangleMesh& mesh, std::span<const MeshCorner> fan);

} // namespace knead
