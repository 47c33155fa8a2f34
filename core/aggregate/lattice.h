#pragma once

#include "core/aggregate/lattice_directions.h"
#include "core/geometry/vec3.h"

#include <array>
#include <cstdint>
#include <vector>

namespace knead {

using ObjectIndex = std::uint32_t;

/// The simple cubic lattice on which the objects of an aggregate start, restricted to the occupied nodes.
///
/// Lattice coordinates are (u, v, w). Objects are numbered in lexicographic order of (u, v, w), so that a row along w
/// is a contiguous range of objects. w runs along the longest side of the part, which makes rows long and few.
/// Each object has up to 18 neighbors (26 as published); a connection is stored with its lower object, in the array of its direction.
struct Lattice {
    using Node = std::array<std::int32_t, 3>;

    static constexpr int directionCount = latticeDirectionCount;
    static constexpr int isotropicCount = 9; ///< the first ones: of the 18 neighbors
    static constexpr const auto& directions = latticeDirections;

    static constexpr Node sum(const Node& a, const Node& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
    static constexpr Node difference(const Node& a, const Node& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

    /// Corners of a cell from its lowest one, (i, j, k) at place 4 i + 2 j + k.
    static constexpr std::array<Node, 8> cellCorners{
        {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, {0, 1, 1}, {1, 0, 0}, {1, 0, 1}, {1, 1, 0}, {1, 1, 1}}};

    /// A stretch of objects whose neighbor in one direction is `offset` further on.
    /// Objects inside it that have no such neighbor carry a connection of weight 0; begin + offset .. end + offset exist.
    struct Segment {
        ObjectIndex begin = 0;
        ObjectIndex end = 0;
        std::int32_t offset = 0; ///< > 0
    };

    Vec3 origin = Vec3::Zero();   ///< place of node (0, 0, 0) [m]
    double spacing = 0;           ///< a [m]
    Mat3 axes = Mat3::Identity(); ///< columns: world directions of u, v, w (a cyclic permutation of x, y, z)
    std::vector<Node> nodes;      ///< per object, sorted
    std::array<std::vector<Segment>, directionCount> segments; ///< per direction, ascending, not overlapping;
                                                               ///< none for a direction that is not used

    std::size_t size() const { return nodes.size(); }

    Vec3 position(const Node& node) const { return origin + spacing * (axes * Vec3(node[0], node[1], node[2])); }
    Vec3 position(ObjectIndex object) const { return position(nodes[object]); }
    std::vector<Vec3> positions() const; ///< of all objects

    /// Vector from an object to its neighbor in a direction, at rest [m].
    Vec3 direction(int d) const
    {
        const Node& n = directions[static_cast<std::size_t>(d)];
        return spacing * (axes * Vec3(n[0], n[1], n[2]));
    }

    /// The object at a node, or size() when none is there. O(lg n).
    ObjectIndex find(const Node& node) const;

    /// Lattice coordinates of a place, not rounded.
    Vec3 coordinates(const Vec3& place) const { return axes.transpose() * (place - origin) / spacing; }
};

/// Finds the segments of the first `directions` directions for sorted nodes. Stretches with equal offset are joined over gaps.
void findSegments(Lattice& lattice, std::size_t directions = Lattice::isotropicCount);

} // namespace knead
