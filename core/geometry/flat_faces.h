#pragma once

#include "core/geometry/triangle_mesh.h"

#include <cstdint>
#include <vector>

namespace knead {

/// A flat face made of triangles that lie in one plane.
struct FlatFace {
    Vec3 point = Vec3::Zero();   ///< in its plane
    Vec3 normal = Vec3::UnitZ(); ///< outward, unit length
    std::vector<std::vector<std::uint32_t>>
        loops;                  ///< its border, by vertices, with the face on the left; the others around holes
    std::uint32_t triangle = 0; ///< one of those it is made of
};

/// The faces of a closed surface of triangles, as few as describe it: neighbors of one CAD face that lie in a plane become one,
/// and edges of their borders that lie on a line do. Neighbors share all vertices along a border. A border does not meet itself in
/// a vertex; where it would, triangles stay by themselves.
/// @param tolerance how far vertices may be off the plane, and borders move [m]; 0: each triangle is a face
std::vector<FlatFace> flatFaces(const TriangleMesh& mesh, double tolerance);

} // namespace knead
