#include "core/aggregate/thin_cells.h"

#include "core/aggregate/wall_measure.h"
#include "core/task/parallel.h"

#include <algorithm>
#include <array>

namespace knead {

namespace {

// Walls with their skins on nodes are fitted up to so many whole cells: bars of them are 3.5 / n^2 too stiff in torsion otherwise.
constexpr std::int32_t mostWholeCells = 4;

Lattice::Node moved(Lattice::Node cell, std::size_t axis, std::int32_t steps)
{
    cell[axis] += steps;
    return cell;
}

class ThinCellSearch {
public:
    explicit ThinCellSearch(const CutCells& cells)
        : m_cells(cells)
        , m_finder(cells)
        , m_measure(m_finder)
    {
    }

    std::vector<ThinCell> of(std::size_t slab) const
    {
        const auto u = static_cast<std::int32_t>(slab);
        std::vector<ThinCell> thin;
        for (const CutCells::Cut& cut : m_cells.slabs[slab].cut)
            if (const Lattice::Node cell{u, cut.v, cut.w}; const double share = m_measure.share(cell))
                thin.push_back({cell, &cut, m_finder.fraction(cell) > 0, share, sidesToFull(cell)});
        for (std::int32_t v = m_cells.slabs[slab].firstRow; v < m_cells.slabs[slab].rowsEnd(); ++v)
            addBare(u, v, thin);
        return thin;
    }

private:
    std::uint8_t sidesToFull(const Lattice::Node& cell) const
    {
        std::uint8_t sides = 0;
        for (std::size_t side = 0; side < 6; ++side)
            if (m_finder.isFull(moved(cell, side / 2, side % 2 == 0 ? -1 : 1)))
                sides |= static_cast<std::uint8_t>(1U << side);
        return sides;
    }

    void addBare(std::int32_t u, std::int32_t v, std::vector<ThinCell>& thin) const
    {
        const CutCells::Row row = m_finder.row(u, v);
        const std::array<CutCells::Row, 6> beside{
            m_finder.row(u - 1, v), m_finder.row(u + 1, v), m_finder.row(u, v - 1), m_finder.row(u, v + 1), row, row};
        for (std::size_t i = 0; i < row.w.size(); ++i) {
            if (row.fraction[i] < CellFinder::full)
                continue;
            ThinCell cell{.cell = {u, v, row.w[i]}};
            for (std::size_t side = 0; side < 6; ++side) {
                const std::int32_t w = row.w[i] + (side < 4 ? 0 : side == 4 ? -1 : 1);
                if (CellFinder::fraction(beside[side], w) == 0 && isBare(cell.cell, side / 2, side % 2 == 0 ? -1 : 1))
                    cell.sides |= static_cast<std::uint8_t>(1U << side);
            }
            if (cell.sides != 0)
                thin.push_back(cell);
        }
    }

    /// @pre the cell beside it is not kept
    bool isBare(const Lattice::Node& cell, std::size_t axis, int side) const
    {
        std::int32_t behind = 1;
        while (behind <= mostWholeCells && m_finder.isFull(moved(cell, axis, -behind * side)))
            ++behind;
        return behind <= mostWholeCells && !m_finder.isCut(moved(cell, axis, side));
    }

    const CutCells& m_cells;
    CellFinder m_finder;
    WallMeasure m_measure;
};

} // namespace

std::vector<std::vector<ThinCell>> findThinCells(const CutCells& cells)
{
    const ThinCellSearch search(cells);
    std::vector<std::vector<ThinCell>> thin(cells.slabs.size());
    forEachBlock(thin.size(), 1, [&](std::size_t u, std::size_t) { thin[u] = search.of(u); });
    return thin;
}

} // namespace knead
