#pragma once

#include "core/geometry/half_edges.h"
#include "core/geometry/triangle_mesh.h"

#include <cstdint>
#include <optional>

namespace knead {

/// A triangle and what it is part of.
struct SurfaceTriangle {
    const TriangleMesh& mesh;
    const HalfEdges& halfEdges; ///< of the mesh
    std::uint32_t triangle;
};

/// Where two triangles pass through each other: a piece of the line that their planes have in common [m].
struct CrossingLine {
    Vec3 begin;
    Vec3 end;
};

/// Where two triangles cross; nothing when they are apart or touch. They cross when each goes through the other's plane, to more
/// than `tolerance` [m] on both sides, and the line in both is longer than that. So triangles that lie on each other do not cross,
/// nor do those with an edge in common; those with a common corner may. A triangle that ends with an edge in the other's plane goes
/// through it when its neighbor there lies on the other side.
std::optional<CrossingLine> crossingOf(const SurfaceTriangle& a, const SurfaceTriangle& b, double tolerance);

} // namespace knead
