#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/geometry/triangle_tree.h"

#include <optional>

namespace knead {

/// Finds where rays leave the material that a surface bounds. Immutable after construction; queries may run on any
/// number of threads. The mesh must outlive it.
class SurfaceRay {
public:
    struct Exit {
        double distance = 0; ///< from the start [m]
        double cosine = 0;   ///< between the ray and the outward normal there, 0..1
        std::uint32_t triangle = 0;
    };

    /// Builds the tree of boxes, O(n lg n), on all threads.
    /// @param orientation 1 when the triangles face outwards, -1 when they face inwards
    SurfaceRay(const TriangleMesh& mesh, double orientation);

    /// The first triangle that the ray goes out through.
    /// @param direction of unit length
    /// @param from that is left out: the triangle on which the ray starts
    std::optional<Exit> firstExit(const Vec3& start, const Vec3& direction, std::uint32_t from) const;

private:
    const TriangleMesh& m_mesh;
    TriangleTree m_tree;
    double m_orientation;
    double m_size; ///< beyond which nothing lies [m]
};

} // namespace knead
