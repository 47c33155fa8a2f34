#pragma once

#include "core/geometry/vec3.h"
#include "core/skin/carried_piece.h"
#include "core/task/task_control.h"

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace knead {

/// Whether the nodes of a mesh lie in the parts as they were opened or as they are now.
enum class NodesAt : std::uint8_t { rest, now };

/// Which nodes belong to one another by the cells of a mesh: cell c has the nodes connectivity[offsets[c] .. offsets[c + 1]).
struct NodeCells {
    std::span<const std::int64_t> connectivity = {};
    std::span<const std::int64_t> offsets = {}; ///< one more than cells, or none
};

/// Where in material a node is.
struct NodePlace {
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    std::uint32_t piece = none; ///< that it lies in, or nearest to; none: farther outside than a spacing of its objects
    std::uint32_t triangle = 0; ///< of its mesh, the nearest one
    /// Signed distance from the surface of that piece, negative inside, or of the nearest one [m].
    double depth = std::numeric_limits<double>::infinity();
    Vec3 shares = Vec3::Zero(); ///< of the corners of the triangle, at the nearest point
};

/// Finds the piece of each node: where pieces overlap, that in which it lies deepest. A node that lies on the surfaces of several,
/// as where two parts touch or along a crack, goes with the most of the nodes in its cells, else with the first of these pieces.
/// Any thread; uses several. @throws Cancelled
std::vector<NodePlace> nodePlaces(std::span<const CarriedPiece> pieces, std::span<const Vec3> nodes, NodesAt at,
                                  const NodeCells& cells = {}, TaskControl& control = TaskControl::none());

} // namespace knead
