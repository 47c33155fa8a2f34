#pragma once

#include "core/geometry/triangle_mesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace knead {

/// How often a surface winds around a point: 1 inside a closed surface that faces outwards, 0 outside; in between where
/// the surface has holes, and it changes smoothly across them. Halves of the value are where one would close them.
///
/// Triangles far away count together, as dipoles (Barill et al. 2018); near ones exactly, by their solid angles (van
/// Oosterom and Strackee 1983). Right to about 0.01. Immutable after construction; queries may run on any number of
/// threads and give the same bits.
class WindingNumber {
public:
    /// Builds a tree, O(n lg n), on all threads.
    explicit WindingNumber(const TriangleMesh& mesh);

    double at(const Vec3& point) const;

private:
    /// Triangles j n / 4^l .. (j + 1) n / 4^l of level l, as in TriangleTree.
    struct Node {
        Vec3 center = Vec3::Zero(); ///< of the area [m]
        Vec3 area = Vec3::Zero();   ///< vector sum [m^2]
        double radius = 0;          ///< of a ball around the center with all of the triangles in it [m]
    };

    std::size_t levelBegin(unsigned level) const { return ((std::size_t{1} << 2 * level) - 1) / 3; }
    std::size_t firstTriangle(unsigned level, std::size_t node) const { return node * m_corners.size() >> 2 * level; }
    Node nodeOf(std::size_t begin, std::size_t end) const;

    unsigned m_depth = 0;
    std::vector<std::array<Vec3, 3>> m_corners; ///< of the triangles, near ones together
    std::vector<Node> m_nodes;                  ///< all levels, the leaves included
};

} // namespace knead
