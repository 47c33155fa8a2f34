#pragma once

#include "core/geometry/triangle_mesh.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace knead {

/// Which triangles share an edge. Half-edge 3 t + i runs from corner i to corner i + 1 of triangle t.
/// Triangles that use a vertex twice have no area and no part in this.
struct HalfEdges {
    static constexpr std::uint32_t none = 0xffffffffU;

    std::vector<std::uint32_t> twin; ///< per half-edge: the one running the other way along the same edge, or none
    std::size_t unpaired = 0;        ///< half-edges without a twin of their own: 0 for a closed, consistent surface

    std::vector<std::uint32_t> fanBegin; ///< per vertex: place of its fan in `fans`, and the end
    std::vector<std::uint32_t> fans;     ///< half-edges by the vertex they leave, then by the one they run to

    /// The half-edges that leave a vertex.
    std::span<const std::uint32_t> leaving(std::uint32_t vertex) const
    {
        return {fans.data() + fanBegin[vertex], fanBegin[vertex + 1] - fanBegin[vertex]};
    }
};

/// O(n lg n) at worst; linear when few triangles meet in a vertex. On all threads.
HalfEdges findHalfEdges(const TriangleMesh& mesh);

} // namespace knead
