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
    return !cutInRow(cell[0], cell[1], cell[2], cell[2]).empty();
}

std::span<const CutCells::Cut> CellFinder::cutInRow(std::int32_t u, std::int32_t v, std::int32_t first,
                                                    std::int32_t last) const
{
    if (!hasSlab(u))
        return {};
    const std::vector<CutCells::Cut>& cut = m_cells.slabs[static_cast<std::size_t>(u)].cut;
    const auto begin = std::lower_bound(cut.begin(), cut.end(), first, [v](const CutCells::Cut& one, std::int32_t w) {
        return one.v != v ? one.v < v : one.w < w;
    });
    auto end = begin;
    while (end != cut.end() && end->v == v && end->w <= last)
        ++end;
    return {begin, end};
}

} // namespace knead
