#include "core/aggregate/cell_finder.h"

#include <algorithm>

namespace knead {

double CellFinder::fraction(const CutCells::Row& row, std::int32_t w)
{
    if (row.w.empty() || w < row.w.front() || w > row.w.back())
        return 0;
    // Most rows have no gaps.
    const auto guess = static_cast<std::size_t>(w - row.w.front());
    if (guess < row.w.size() && row.w[guess] == w)
        return row.fraction[guess];
    const auto found = std::lower_bound(row.w.begin(), row.w.end(), w);
    return *found == w ? row.fraction[static_cast<std::size_t>(found - row.w.begin())] : 0;
}

bool CellFinder::isCut(const Lattice::Node& cell) const
{
    if (!hasSlab(cell[0]))
        return false;
    const std::vector<CutCells::Cut>& cut = m_cells.slabs[static_cast<std::size_t>(cell[0])].cut;
    const auto found =
        std::lower_bound(cut.begin(), cut.end(), cell, [](const CutCells::Cut& one, const Lattice::Node& other) {
            return one.v != other[1] ? one.v < other[1] : one.w < other[2];
        });
    return found != cut.end() && found->v == cell[1] && found->w == cell[2];
}

} // namespace knead
