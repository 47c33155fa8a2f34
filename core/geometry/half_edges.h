#pragma once

#include "core/geometry/triangle_mesh.h"

#include <cstdint>
#include <vector>

namespace knead {

/// Which triangles share an edge. Half-edge 3 t + i runs from corner i to corner i + 1 of triangle t.
/// Triangles that use a vertex twice have no area and no part in this.
struct HalfEdges {
    static constexpr std::uint32_t none = 0xffffffffU;

    std::vector<std::uint32_t> twin; ///< per half-edge: the one running the other way along the same edge, or none
    std::size_t unpaired = 0;        ///< half-edges without a twin of their own: 0 for a closed, consistent surface
};

/// O(n lg n) at worst; linear when few triangles meet in a vertex.
HalfEdges findHalfEdges(const TriangleMesh& mesh);

} // namespace knead
