#include "core/aggregate/thin_cells.h"

#include "core/task/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace knead {

namespace {

// Walls with their skins on nodes are fitted up to so many whole cells: bars of them are 3.5 / n^2 too stiff in torsion otherwise.
constexpr std::int32_t mostWholeCells = 4;

Lattice::Node moved(Lattice::Node cell, std::size_t axis, std::int32_t steps)
{
    cell[axis] += steps;
    return cell;
}

/// Where cells are in the slabs of CutCells.
class CellFinder {
public:
    explicit CellFinder(const CutCells& cells)
        : m_cells(cells)
    {
    }

    /// 0 for a cell that is not kept.
    static double fraction(const CutCells::Row& row, std::int32_t w)
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

    CutCells::Row row(std::int32_t u, std::int32_t v) const
    {
        return hasSlab(u) ? m_cells.slabs[static_cast<std::size_t>(u)].row(v) : CutCells::Row{};
    }

    double fraction(const Lattice::Node& cell) const { return fraction(row(cell[0], cell[1]), cell[2]); }
    bool isFull(const Lattice::Node& cell) const { return fraction(cell) >= full; }

    /// Whether the surface goes through its inside.
    bool isCut(const Lattice::Node& cell) const
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

    static constexpr double full = 1 - 1e-9; // as cutCells() takes it

private:
    bool hasSlab(std::int32_t u) const { return u >= 0 && static_cast<std::size_t>(u) < m_cells.slabs.size(); }

    const CutCells& m_cells;
};

class ThinCellSearch {
public:
    explicit ThinCellSearch(const CutCells& cells)
        : m_cells(cells)
        , m_finder(cells)
    {
    }

    std::vector<ThinCell> of(std::size_t slab) const
    {
        const auto u = static_cast<std::int32_t>(slab);
        std::vector<ThinCell> thin;
        for (const CutCells::Cut& cut : m_cells.slabs[slab].cut)
            if (const Lattice::Node cell{u, cut.v, cut.w}; !isThick(cell))
                thin.push_back({cell, &cut, m_finder.fraction(cell) > 0, sidesToFull(cell)});
        for (std::int32_t v = m_cells.slabs[slab].firstRow; v < m_cells.slabs[slab].rowsEnd(); ++v)
            addBare(u, v, thin);
        return thin;
    }

private:
    /// Whether there are thickestThinWall cells of material behind a cut cell, along all axes that lead inwards rather than
    /// along the surface: where the cells on both sides differ at least half as much as along the axis where they differ most.
    bool isThick(const Lattice::Node& cell) const
    {
        constexpr double unclear = 0.25; // of a cell: two skins may be this near to each other
        std::array<double, 3> inwards{};
        double most = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            inwards[axis] = m_finder.fraction(moved(cell, axis, 1)) - m_finder.fraction(moved(cell, axis, -1));
            most = std::max(most, std::abs(inwards[axis]));
        }
        if (most < unclear)
            return false;
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (std::abs(inwards[axis]) >= most / 2)
                for (std::int32_t step = 2; step <= thickestThinWall; step += 2)
                    if (m_finder.fraction(moved(cell, axis, inwards[axis] > 0 ? step : -step)) == 0)
                        return false;
        return true;
    }

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
