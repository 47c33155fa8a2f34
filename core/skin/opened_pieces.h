#pragma once

#include "core/aggregate/aggregate.h"
#include "core/aggregate/connection_id.h"
#include "core/geometry/triangle_mesh.h"
#include "core/skin/former_shape.h"
#include "core/skin/fragments.h"
#include "core/skin/opened_state.h"
#include "core/task/task_control.h"

#include <cstdint>
#include <span>
#include <vector>

namespace knead {

/// A piece of a body that has come apart, at rest as it was opened.
struct OpenedPiece {
    TriangleMesh mesh;                 ///< closed; faces as in Fragment
    std::vector<ObjectIndex> carriers; ///< of the first filling: those that do not dangle, ascending
    std::vector<ObjectIndex> present;  ///< objects of the present filling that carry it, ascending
    std::size_t dust = 0;              ///< objects of the first filling in it that are of pieces without a shape

    /// Sides of cracks that end in it, see Fragment; empty where none was opened.
    std::vector<std::uint8_t> lipOfVertex;
    std::vector<std::uint8_t> lipOfCarrier; ///< per entry of carriers
    std::vector<std::uint8_t> lipOfPresent; ///< per entry of present
};

/// The pieces of a body, and what parted them.
struct OpenedPieces {
    std::vector<BrokenConnection> parting; ///< of the first filling: those from one piece to another, ascending
    std::vector<OpenedPiece>
        pieces;             ///< two or more, or one with lips; none where it hangs together, or what is said below
    bool isUnknown = false; ///< its cracks could not be made surfaces, or a piece has no objects now
    std::vector<std::uint32_t> ofFirst;   ///< per object of the first filling: its piece
    std::vector<std::uint32_t> ofPresent; ///< the same of the present one
};

/// Objects of a present filling belong to the piece of the object of the first one that was nearest when it was filled.
/// @param opened closed surface of the opened part
/// @param broken of `present`
/// @param healed of its objects: what makes pieces one again, see regrown()
/// @throws Cancelled
OpenedPieces openedPieces(const Aggregate& present, const TriangleMesh& opened,
                          std::span<const BrokenConnection> broken, std::span<const GrownTogether> healed = {},
                          TaskControl& control = TaskControl::none(), const FragmentOptions& options = {});

/// The same to be looked at: where cracks of a body that was filled in pieces cannot be made surfaces, as many as it was filled in.
OpenedPieces piecesToShow(const Aggregate& present, const TriangleMesh& opened,
                          std::span<const BrokenConnection> broken, TaskControl& control = TaskControl::none(),
                          const FragmentOptions& options = {});

/// Objects of one piece as an aggregate of their own, whatever cracks are in it.
Aggregate wholePiece(const Aggregate& aggregate, std::span<const ObjectIndex> objects);

} // namespace knead
