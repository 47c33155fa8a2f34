#pragma once

#include "core/aggregate/aggregate.h"
#include "core/aggregate/cut_cells.h"

#include <cstdint>
#include <vector>

namespace knead {

/// The number of corners of the kept cells: the objects an aggregate of them has.
std::size_t countCorners(const CutCells& cells);

/// Objects at the corners of the kept cells, with connections and volumes from the cells around them.
struct CellCorners {
    Aggregate aggregate;                 ///< lattice, weights and volumes; no depths, no faces
    std::vector<std::uint8_t> isSurface; ///< per object: 1 when a cell around it is not full
};

/// A cell with fraction f gives f / 4 to the weight of each of its edges, f / 2 to each diagonal of its faces, and
/// f / 8 of a cell's volume to each corner. Then volumes and weights are scaled by one factor that spreads the dropped
/// slivers, so that the volumes sum to that of all cells and the sum of k l^2 is 6 E V with k = 0.4 E a w.
/// @pre at least one cell is kept, and countCorners() fits ObjectIndex
CellCorners joinCells(const CutCells& cells, const CellGrid& grid, TaskControl& control);

} // namespace knead
