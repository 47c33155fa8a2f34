#pragma once

#include "core/aggregate/aggregate.h"
#include "core/aggregate/cut_cells.h"

#include <cstdint>
#include <vector>

namespace knead {

/// The part of the skin that each object stands for, as a vector outwards in axes of the lattice [a^2]:
///   g_i = integral over the skin of N_i n = integral over the material of grad N_i,
/// N_i linear along each axis between the corners of cells, exact by the moments of cells. Inside it is 0.
///
/// Cells with too little material to be kept may have corners without an object. Displacements there are taken to go on straight
/// from the objects on the other side of the cell and behind it, 2 u_1 - u_2, so those bear what the corner would. Where there are none it
/// is left out.
/// @param isSurface per object, as in CellCorners: what is not is inside
std::vector<Vec3> skinAreas(const CutCells& cells, const Aggregate& aggregate,
                            const std::vector<std::uint8_t>& isSurface);

} // namespace knead
