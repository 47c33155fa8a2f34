#include "core/aggregate/cell_corners.h"

#include "core/task/parallel_progress.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace knead {

namespace {

constexpr double full = 1 - 1e-9; // fraction of a cell that has no surface in it, but for rounding

/// The fractions of the eight cells around a node; 0 for cells that are not kept.
/// The four rows of cells are (u - 1, v - 1), (u - 1, v), (u, v - 1), (u, v).
struct Surroundings {
    std::array<double, 4> below{}; ///< cells w - 1
    std::array<double, 4> above{}; ///< cells w

    double sum() const
    {
        return std::accumulate(below.begin(), below.end(), std::accumulate(above.begin(), above.end(), 0.0));
    }

    double least() const { return std::min(*std::ranges::min_element(below), *std::ranges::min_element(above)); }

    /// In the order of Lattice::directions: mean over the cells that share the connection.
    std::array<double, Lattice::isotropicCount> weights() const
    {
        return {(below[2] + below[3] + above[2] + above[3]) / 4,
                (below[1] + below[3] + above[1] + above[3]) / 4,
                (above[0] + above[1] + above[2] + above[3]) / 4,
                (below[3] + above[3]) / 2,
                (below[2] + above[2]) / 2,
                (above[2] + above[3]) / 2,
                (below[2] + below[3]) / 2,
                (above[1] + above[3]) / 2,
                (below[1] + below[3]) / 2};
    }
};

/// Walks along the four rows of cells around a row of nodes.
class NodeRow {
public:
    explicit NodeRow(const std::array<CutCells::Row, 4>& cells)
        : m_cells(cells)
    {
    }

    /// Calls visit(w, surroundings) for every node with a kept cell around it, in ascending w.
    template <typename Visit>
    void forEach(Visit&& visit)
    {
        Surroundings around;
        for (std::int32_t w = nextCell(); w != none;) {
            bool more = false;
            for (std::size_t row = 0; row < 4; ++row) {
                around.above[row] = take(row, w);
                more = more || around.above[row] > 0;
            }
            visit(w, around);
            around.below = around.above;
            w = more ? w + 1 : nextCell();
        }
    }

private:
    static constexpr std::int32_t none = std::numeric_limits<std::int32_t>::max();

    std::int32_t nextCell() const
    {
        std::int32_t next = none;
        for (std::size_t row = 0; row < 4; ++row)
            if (m_place[row] < m_cells[row].w.size())
                next = std::min(next, m_cells[row].w[m_place[row]]);
        return next;
    }

    double take(std::size_t row, std::int32_t w)
    {
        const CutCells::Row& cells = m_cells[row];
        const bool there = m_place[row] < cells.w.size() && cells.w[m_place[row]] == w;
        return there ? cells.fraction[m_place[row]++] : 0;
    }

    std::array<CutCells::Row, 4> m_cells;
    std::array<std::size_t, 4> m_place{};
};

/// Calls visit(node, surroundings) for the nodes of plane u in ascending order.
template <typename Visit>
void forEachNode(const CutCells& cells, std::size_t u, Visit&& visit)
{
    static const CutCells::Slab nothing;
    const CutCells::Slab& before = u > 0 ? cells.slabs[u - 1] : nothing;
    const CutCells::Slab& after = u < cells.slabs.size() ? cells.slabs[u] : nothing;
    if (before.w.empty() && after.w.empty())
        return;
    const CutCells::Slab& lower = before.w.empty() ? after : before;
    const CutCells::Slab& upper = after.w.empty() ? before : after;
    const std::int32_t first = std::min(lower.firstRow, upper.firstRow);
    const std::int32_t last = std::max(lower.rowsEnd(), upper.rowsEnd());
    for (std::int32_t v = first; v <= last; ++v) {
        NodeRow row({before.row(v - 1), before.row(v), after.row(v - 1), after.row(v)});
        row.forEach([&](std::int32_t w, const Surroundings& around) {
            visit(Lattice::Node{static_cast<std::int32_t>(u), v, w}, around);
        });
    }
}

/// Per plane of nodes the number of its first object, and the end.
std::vector<std::size_t> numberPlanes(const CutCells& cells)
{
    std::vector<std::size_t> first(cells.slabs.size() + 2, 0);
    forEachBlock(cells.slabs.size() + 1, 1, [&](std::size_t u, std::size_t) {
        forEachNode(cells, u, [&](const Lattice::Node&, const Surroundings&) { ++first[u + 1]; });
    });
    std::partial_sum(first.begin(), first.end(), first.begin());
    return first;
}

CellCorners allocate(const CellGrid& grid, std::size_t objects)
{
    CellCorners corners;
    corners.aggregate.lattice = grid.frame;
    corners.aggregate.lattice.nodes.resize(objects);
    for (std::size_t d = 0; d < Lattice::isotropicCount; ++d)
        corners.aggregate.weight[d].resize(objects);
    corners.aggregate.volume.resize(objects);
    corners.isSurface.resize(objects);
    return corners;
}

} // namespace

std::size_t countCorners(const CutCells& cells)
{
    return numberPlanes(cells).back();
}

CellCorners joinCells(const CutCells& cells, const CellGrid& grid, TaskControl& control)
{
    const std::vector<std::size_t> first = numberPlanes(cells);
    CellCorners corners = allocate(grid, first.back());
    Aggregate& aggregate = corners.aggregate;
    const double cellVolume = grid.frame.spacing * grid.frame.spacing * grid.frame.spacing;
    const double spread = cells.volume() / cells.keptVolume();
    forEachBlock(cells.slabs.size() + 1, 1, control, "placing objects", [&](std::size_t u, std::size_t) {
        std::size_t object = first[u];
        forEachNode(cells, u, [&](const Lattice::Node& node, const Surroundings& around) {
            aggregate.lattice.nodes[object] = node;
            const auto weights = around.weights();
            for (std::size_t d = 0; d < weights.size(); ++d)
                aggregate.weight[d][object] = spread * weights[d];
            aggregate.volume[object] = spread * around.sum() / 8 * cellVolume;
            corners.isSurface[object] = around.least() < full ? 1 : 0;
            ++object;
        });
    });
    findSegments(aggregate.lattice);
    aggregate.cells = cells.size();
    aggregate.filledVolume = cells.volume() * cellVolume;
    return corners;
}

} // namespace knead
