#pragma once

#include "core/geometry/vec3.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
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

/// The corners of a triangle.
/// @param places of the vertices
inline std::array<Vec3, 3> cornersOf(std::span<const Vec3> places, const TriangleMesh::Triangle& t)
{
    return {places[t[0]], places[t[1]], places[t[2]]};
}

/// Along the normal of a triangle, twice as long as its area.
inline Vec3 crossOf(const std::array<Vec3, 3>& corners)
{
    return (corners[1] - corners[0]).cross(corners[2] - corners[0]);
}
inline Vec3 crossOf(std::span<const Vec3> places, const TriangleMesh::Triangle& t)
{
    return crossOf(cornersOf(places, t));
}

/// Two vertices or the like as one number, whichever comes first.
inline std::uint64_t pairKey(std::uint32_t a, std::uint32_t b)
{
    return std::uint64_t{std::min(a, b)} << 32U | std::max(a, b);
}

/// Joins vertices closer than `tolerance` [m] and drops triangles that collapse by it; face ids are kept.
TriangleMesh weld(const TriangleMesh& mesh, double tolerance);

} // namespace knead
