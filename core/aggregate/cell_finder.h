#pragma once

#include "core/aggregate/cut_cells.h"

#include <cstdint>

namespace knead {

/// How much of a cell is material, by where it is. Cells must outlive it.
class CellFinder {
public:
    static constexpr double full = 1 - 1e-9; // as cutCells() takes it

    explicit CellFinder(const CutCells& cells)
        : m_cells(cells)
    {
    }

    /// 0 for a cell that is not kept.
    static double fraction(const CutCells::Row& row, std::int32_t w);
    double fraction(const Lattice::Node& cell) const { return fraction(row(cell[0], cell[1]), cell[2]); }

    /// Empty outside the grid.
    CutCells::Row row(std::int32_t u, std::int32_t v) const
    {
        return hasSlab(u) ? m_cells.slabs[static_cast<std::size_t>(u)].row(v) : CutCells::Row{};
    }

    bool isFull(const Lattice::Node& cell) const { return fraction(cell) >= full; }

    /// Whether the surface goes through its inside.
    bool isCut(const Lattice::Node& cell) const;

    /// Those that the surface goes through, from one w to another, both included.
    std::span<const CutCells::Cut> cutInRow(std::int32_t u, std::int32_t v, std::int32_t first,
                                            std::int32_t last) const;

private:
    bool hasSlab(std::int32_t u) const { return u >= 0 && static_cast<std::size_t>(u) < m_cells.slabs.size(); }

    const CutCells& m_cells;
};

} // namespace knead
