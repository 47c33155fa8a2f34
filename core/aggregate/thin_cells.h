#pragma once

#include "core/aggregate/cut_cells.h"

#include <cstdint>
#include <vector>

namespace knead {

/// A cell at the skin of a wall, see WallMeasure.
struct ThinCell {
    Lattice::Node cell{};
    const CutCells::Cut* cut = nullptr; ///< null: a full cell whose side is skin
    bool isKept = true;
    double share =
        1; ///< of a wall, 0..1: so much of what it lacks is given; 1 where sides are skin, which keeps what leads inwards
    std::uint8_t sides =
        0; ///< of a cut cell those to full cells, of a full one those that are skin; bit 2 axis for the
           ///< lower one, bit 2 axis + 1 for the upper one

    /// Calls visit(axis, side) for those, side being -1 or 1.
    template <typename Visit>
    void forEachSide(Visit visit) const
    {
        for (std::size_t side = 0; side < 6; ++side)
            if ((sides >> side & 1U) != 0)
                visit(side / 2, side % 2 == 0 ? -1 : 1);
    }
};

/// Per slab, in ascending (v, w), cut ones first. The cells must outlive the result.
std::vector<std::vector<ThinCell>> findThinCells(const CutCells& cells);

} // namespace knead
