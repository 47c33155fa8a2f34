#pragma once

#include "io/fields/nodal_mesh.h"

#include <cstdint>
#include <span>
#include <string_view>

namespace knead {

/// Appends cells as VTK's XML files and version 5 of its older ones hold them.
/// @param firstNode what is added to each node
/// @param ends where the nodes of each cell end; a 0 before them all is allowed
/// @throws Problem, when the arrays do not go together
void appendCells(NodalCells& cells, std::int64_t firstNode, std::span<const std::int64_t> connectivity,
                 std::span<const std::int64_t> ends, std::span<const std::int64_t> types);

/// The same for cells of a surface, whose types follow from how many nodes they have.
/// @param kind "Verts", "Lines" or "Polys"
void appendSurfaceCells(NodalCells& cells, std::string_view kind, std::int64_t firstNode,
                        std::span<const std::int64_t> connectivity, std::span<const std::int64_t> ends);

/// VTK's type of a cell of a surface.
std::uint8_t typeOfSurfaceCell(std::string_view kind, std::size_t nodes);

} // namespace knead
