#pragma once

#include "core/geometry/vec3.h"
#include "core/skin/labeled_nodes.h"
#include "core/task/task_control.h"

#include <array>
#include <cstdint>
#include <vector>

namespace knead {

/// Where the parts of a body meet: triangles with one label behind and one in front of them. Two triangles of the same
/// labels, or three of three labels, meet in each edge, but for the outermost, which lie outside of the material.
struct CrackSurface {
    struct Triangle {
        std::array<std::uint32_t, 3> corners; ///< counter-clockwise seen from the front
        std::array<std::uint32_t, 3> edges{}; ///< from corner i to corner i + 1
        std::uint32_t back = 0;               ///< label
        std::uint32_t front = 0;              ///< label
    };

    /// Triangles between two corners of the lattice of labels.
    struct Cell {
        Lattice::Node lowest{};
        std::uint32_t begin = 0; ///< first triangle
        std::uint32_t end = 0;
    };

    std::vector<Vec3> vertices; ///< [m]
    std::vector<Triangle> triangles;
    std::vector<std::array<std::uint32_t, 2>> edges; ///< vertices, the lower one first
    std::vector<Cell> cells;                         ///< ascending; all that have triangles
};

/// Marching tetrahedra with any number of labels: each cell is cut into six tetrahedra along its diagonal, and in each of
/// them the corners' labels are kept apart by planes through the points where shares are equal.
///
/// Vertices are moved by some 1e-6 cells each, a way that depends on `salt`, so that hardly ever one of them lies in a
/// plane of the surface that the cracks are to be cut by.
/// @throws Cancelled
CrackSurface findCrackSurface(const LabeledNodes& nodes, std::uint64_t salt, TaskControl& control);

} // namespace knead
