#pragma once

#include "core/aggregate/cut_cells.h"

namespace knead {

/// What a cell needs at least of material for withoutScraps() to keep it, wherever it lies; those with less are never kept.
double leastFraction(double minimumFraction);

/// Cells without those that hold less than minimumFraction, but for two kinds:
/// - Layers of at least leastFraction(), .03 by default, flat or down to wedges, along a face of the cell behind which three cells in
///   a row are full, with nothing in the nine cells beyond but walls beside it: or the skin of holes and curved bars had no objects where it lies just
///   beyond a plane of nodes, and stress there came out up to 29 % too high. What fills but a corner of its cell is dropped: its mass
///   would lie too far outside. Where RowRepair decided, the neighbors tell what is a layer.
/// - Where none of the 26 neighbors is full, in thin walls, those with at least half of minimumFraction. A tilted wall of one cell has
///   many cells with little in them; without those it has holes, and at some tilts falls into rows that only hang together at their
///   corners.
/// @param cells with at least leastFraction()
CutCells withoutScraps(const CutCells& cells, double minimumFraction);

} // namespace knead
