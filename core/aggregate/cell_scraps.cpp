#include "core/aggregate/cell_scraps.h"

#include "core/aggregate/cell_finder.h"
#include "core/task/parallel.h"

#include <algorithm>
#include <array>

namespace knead {

namespace {

constexpr double rounding = 1e-9;       // of a cell
constexpr double thinnestLayer = 0.03;  // of a cell
constexpr double inWalls = 0.5;         // of the least fraction
constexpr int underLayer = 3;           // full cells: thinner walls have their weights fitted without
constexpr double evenSpread = 1.0 / 12; // variance of what reaches from one face of a cell to the opposite one
constexpr double ofLayer = 0.6; // and of a layer at least, along two axes, in this unit: a wedge has two thirds of it

/// Tells which cells of others are kept.
class Scraps {
public:
    Scraps(const CutCells& cells, double minimumFraction)
        : m_finder(cells)
        , m_minimumFraction(minimumFraction)
    {
    }

    bool isKept(const Lattice::Node& cell, double fraction) const
    {
        if (fraction >= m_minimumFraction - rounding)
            return true;
        return touchesFull(cell) ? isLayer(cell) : fraction >= inWalls * m_minimumFraction - rounding;
    }

private:
    /// One of its 26 neighbors.
    bool touchesFull(const Lattice::Node& cell) const
    {
        for (const std::int32_t u : {-1, 0, 1})
            for (const std::int32_t v : {-1, 0, 1}) {
                const CutCells::Row row = m_finder.row(cell[0] + u, cell[1] + v);
                for (const std::int32_t w : {-1, 0, 1})
                    if (CellFinder::fraction(row, cell[2] + w) >= CellFinder::full)
                        return true;
            }
        return false;
    }

    /// Whether its material lies along a face of it, over full cells.
    bool isLayer(const Lattice::Node& cell) const
    {
        const auto cut = m_finder.cutInRow(cell[0], cell[1], cell[2], cell[2]);
        if (cut.empty())
            return false;
        const auto& moments = cut.front().moments.value;
        std::array<bool, 3> isWide{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double mean = moments[1 + axis] / moments[0];
            isWide[axis] = moments[4 + axis] / moments[0] - mean * mean >= ofLayer * evenSpread;
        }
        const bool isKnown = !(isWide[0] && isWide[1] && isWide[2]); // else RowRepair decided, and it is spread evenly
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::size_t b = (axis + 1) % 3;
            const std::size_t c = (axis + 2) % 3;
            if ((isOverFullCells(cell, axis, -1) || isOverFullCells(cell, axis, 1)) && isWide[b] && isWide[c] &&
                (isKnown || filledBeside(cell, b) + filledBeside(cell, c) >= 3))
                return true;
        }
        return false;
    }

    bool isOverFullCells(Lattice::Node cell, std::size_t axis, std::int32_t way) const
    {
        for (int i = 0; i < underLayer; ++i) {
            cell[axis] += way;
            if (!m_finder.isFull(cell))
                return false;
        }
        return true;
    }

    /// How many of the two neighbors along an axis have something.
    int filledBeside(Lattice::Node cell, std::size_t axis) const
    {
        cell[axis] -= 1;
        const bool before = m_finder.fraction(cell) > 0;
        cell[axis] += 2;
        return (before ? 1 : 0) + (m_finder.fraction(cell) > 0 ? 1 : 0);
    }

    CellFinder m_finder;
    double m_minimumFraction;
};

} // namespace

double leastFraction(double minimumFraction)
{
    return std::min(thinnestLayer, inWalls * minimumFraction);
}

CutCells withoutScraps(const CutCells& cells, double minimumFraction)
{
    const Scraps scraps(cells, minimumFraction);
    CutCells left;
    left.slabs.resize(cells.slabs.size());
    forEachBlock(cells.slabs.size(), 1, [&](std::size_t u, std::size_t) {
        const CutCells::Slab& from = cells.slabs[u];
        CutCells::Slab& to = left.slabs[u];
        to.firstRow = from.firstRow;
        to.cut = from.cut;
        to.volume = from.volume;
        to.decided = from.decided;
        to.doubtful = from.doubtful;
        for (std::int32_t v = from.firstRow; v < from.rowsEnd(); ++v) {
            const CutCells::Row row = from.row(v);
            for (std::size_t i = 0; i < row.w.size(); ++i)
                if (scraps.isKept({static_cast<std::int32_t>(u), v, row.w[i]}, row.fraction[i])) {
                    to.w.push_back(row.w[i]);
                    to.fraction.push_back(row.fraction[i]);
                }
            to.rowBegin.push_back(to.w.size());
        }
    });
    return left;
}

} // namespace knead
