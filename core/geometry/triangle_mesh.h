#pragma once

#include "core/geometry/vec3.h"

#include <array>
#include <cstdint>
#include <vector>

namespace knead {

/// A triangulated surface. Vertices are shared between triangles (welded), so that a closed surface is closed in its
/// indices too; triangles run counter-clockwise seen from outside.
struct TriangleMesh {
    using Triangle = std::array<std::uint32_t, 3>;

    std::vector<Vec3> vertices;      ///< [m]
    std::vector<Triangle> triangles; ///< indices into vertices
    std::vector<std::uint32_t>
        faceOfTriangle; ///< CAD face of each triangle (index into Part::faces); empty for a plain mesh

    bool empty() const { return triangles.empty(); }
};

/// Joins vertices closer than `tolerance` [m] and drops triangles that collapse by it; face ids are kept.
TriangleMesh weld(const TriangleMesh& mesh, double tolerance);

} // namespace knead
