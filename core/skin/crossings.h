#pragma once

#include "core/geometry/half_edges.h"
#include "core/geometry/triangle_mesh.h"
#include "core/message/message.h"
#include "core/skin/crack_surface.h"
#include "core/task/task_control.h"

#include <cstdint>
#include <vector>

namespace knead {

/// Thrown when cracks lie in a plane with the surface, so that nothing can be said of where they cross: with other
/// numbers for the jitter they will not.
struct DegenerateCut : Problem {
    DegenerateCut()
        : Problem(Message("Filling", "cracks touch the surface without crossing it"))
    {
    }
};

/// Where a surface is crossed by cracks. A point is where an edge of one passes through a triangle of the other, and is there
/// once, however many triangles share the edge; a segment is where two triangles cross.
struct SurfaceCrossings {
    struct Point {
        bool isOnCrack = false;     ///< on an edge of the cracks, else of the surface
        std::uint32_t edge = 0;     ///< of the surface: the lower of its half-edges
        double along = 0;           ///< 0..1 from its start: of the half-edge, or of the lower vertex
        std::uint32_t triangle = 0; ///< of the other
        Vec3 place = Vec3::Zero();  ///< [m]
    };

    /// Runs so that, seen from outside of the surface, the back of the crack is left and the front is right; and, seen from
    /// the front of the crack, the outside is left and the inside right.
    struct Segment {
        std::uint32_t skinTriangle = 0;
        std::uint32_t crackTriangle = 0;
        std::uint32_t start = 0; ///< points
        std::uint32_t end = 0;
    };

    std::vector<Point> points;     ///< those of the surface's edges, then those of the cracks'; by edge and along it
    std::vector<Segment> segments; ///< by triangle of the surface, then of the cracks

    /// Points of an edge, in their order along it.
    struct Range {
        std::uint32_t begin = 0;
        std::uint32_t end = 0;
        std::uint32_t size() const { return end - begin; }
    };
    Range on(bool isOnCrack, std::uint32_t edge) const;
};

/// The lower of a half-edge and its twin: the name of the edge.
inline std::uint32_t edgeOf(const HalfEdges& halfEdges, std::uint32_t halfEdge)
{
    const std::uint32_t twin = halfEdges.twin[halfEdge];
    return twin < halfEdge ? twin : halfEdge;
}

/// Each pair of triangles is decided by exact orientations, so that segments always make whole lines.
/// @param frame the lattice in whose cells the cracks are listed
/// @throws DegenerateCut, Cancelled
SurfaceCrossings findCrossings(const TriangleMesh& skin, const HalfEdges& halfEdges, const CrackSurface& cracks,
                               const Lattice& frame, TaskControl& control);

} // namespace knead
