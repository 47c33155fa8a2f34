#include "core/aggregate/cell_scraps.h"

#include "core/aggregate/cell_finder.h"
#include "core/task/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace knead {

namespace {

constexpr double rounding = 1e-9; // of a cell
constexpr double inWalls = 0.5;   // of the least fraction

constexpr double thinnestLayer = 0.03;  // of a cell
constexpr double thinnestGuess = 0.06;  // where RowRepair decided by 32 points: more than one of them
constexpr double evenSpread = 1.0 / 12; // variance of what reaches from one face of a cell to the opposite one
constexpr double ofLayer = 0.6; // and of a layer at least, along two axes, in this unit: a wedge has two thirds of it
constexpr double highest = 0.8; // middle over its face, by its mean thickness: half in flat ones, two thirds in wedges
constexpr int underLayer = 3;   // full cells: thinner walls have their weights fitted without
constexpr double nearlyFull = 1 - 1e-6; // places in files may be of single precision

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
        return touchesFull(cell) ? isLayer(cell, fraction) : fraction >= inWalls * m_minimumFraction - rounding;
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

    /// Whether its material lies along a face of it, over full cells and under empty ones.
    bool isLayer(const Lattice::Node& cell, double fraction) const
    {
        const auto cut = m_finder.cutInRow(cell[0], cell[1], cell[2], cell[2]);
        if (cut.empty())
            return false;
        const auto& moments = cut.front().moments.value;
        std::array<double, 3> middle{};
        std::array<double, 3> variance{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            middle[axis] = moments[1 + axis] / moments[0];
            variance[axis] = moments[4 + axis] / moments[0] - middle[axis] * middle[axis];
        }
        const bool isGuess = std::ranges::all_of(
            variance, [](double one) { return std::abs(one - evenSpread) < rounding; }); // RowRepair spreads it evenly
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (const std::int32_t way : {-1, 1}) {
                const std::size_t b = (axis + 1) % 3;
                const std::size_t c = (axis + 2) % 3;
                if (!isOverFullCells(cell, axis, way) || !isFreeBeyond(cell, axis, -way))
                    continue;
                const bool fits = isGuess
                                      ? fraction >= thinnestGuess && filledBeside(cell, b) + filledBeside(cell, c) >= 3
                                      : 0.5 - way * middle[axis] <= highest * fraction &&
                                            std::min(variance[b], variance[c]) >= ofLayer * evenSpread;
                if (fits)
                    return true;
            }
        return false;
    }

    /// Nothing lies on the other side so near that both would share objects, but for walls that rise beside it.
    bool isFreeBeyond(const Lattice::Node& cell, std::size_t axis, std::int32_t way) const
    {
        for (const std::int32_t b : {-1, 0, 1})
            for (const std::int32_t c : {-1, 0, 1}) {
                Lattice::Node beside = cell;
                beside[(axis + 1) % 3] += b;
                beside[(axis + 2) % 3] += c;
                Lattice::Node beyond = beside;
                beyond[axis] += way;
                if (m_finder.fraction(beyond) > 0 && m_finder.fraction(beside) < nearlyFull)
                    return false;
            }
        return true;
    }

    bool isOverFullCells(Lattice::Node cell, std::size_t axis, std::int32_t way) const
    {
        for (int i = 0; i < underLayer; ++i) {
            cell[axis] += way;
            if (m_finder.fraction(cell) < nearlyFull)
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
