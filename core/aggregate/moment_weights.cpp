#include "core/aggregate/moment_weights.h"

#include "core/aggregate/lattice_rows.h"
#include "core/aggregate/moment_stencil.h"
#include "core/task/parallel_progress.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace knead {

namespace {

constexpr std::size_t families = Lattice::isotropicCount;

// [a^2] of second moment that the material gets beside its own: a bar of two cells is -5 % instead of -10 % stiff.
constexpr double softness = 0.025;
constexpr double evenSquare = 1.0 / 12 + softness; // second moment of a full cell

// Of a full connection. A wall's outermost ones may be asked for less than nothing; springs must push back.
constexpr double leastWeight = 0.02;

constexpr std::int32_t thickest = 8; // cells: what is thicker bends right without

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

/// Whether there are `thickest` cells of material behind a cut cell, along all axes that lead inwards rather than along
/// the surface: where the cells on both sides differ at least half as much as along the axis where they differ most.
bool isThick(const CellFinder& finder, const Lattice::Node& cell)
{
    constexpr double unclear = 0.25; // of a cell: two skins may be this near to each other
    std::array<double, 3> inwards{};
    double most = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        inwards[axis] = finder.fraction(moved(cell, axis, 1)) - finder.fraction(moved(cell, axis, -1));
        most = std::max(most, std::abs(inwards[axis]));
    }
    if (most < unclear)
        return false;
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (std::abs(inwards[axis]) >= most / 2)
            for (std::int32_t step = 2; step <= thickest; step += 2)
                if (finder.fraction(moved(cell, axis, inwards[axis] > 0 ? step : -step)) == 0)
                    return false;
    return true;
}

/// Second moment along `axis` of a unit of weight that joinCells() gives the connections of a cell.
double evenlyJoined(std::size_t direction, std::size_t axis)
{
    return Lattice::directions[direction][axis] == 0 ? 0.25 : 0;
}

/// What one cell gives to the connections around it beside what joinCells() does: of each family a functional without sum.
class CellCorrection {
public:
    /// Of a cut cell: the moments of its material, less what it gave already.
    CellCorrection(const CellMoments& moments, double kept)
        : m_center(Vec3(moments.value[1], moments.value[2], moments.value[3]) / moments.value[0])
    {
        for (std::size_t d = 0; d < families; ++d) {
            m_moments[d] = moments.value;
            m_moments[d][0] -= kept;
            for (std::size_t axis = 0; axis < 3; ++axis)
                m_moments[d][4 + axis] += softness * moments.value[0] - kept * evenlyJoined(d, axis);
        }
    }

    /// Of a full cell.
    CellCorrection() = default;

    /// Between full cells the second moments that are too large cancel but for a part at their outer sides:
    ///   -excess / 2 times the derivative along the outward normal, taken over the side.
    /// @param side of this cell along an axis, -1 or 1
    /// @param outward direction of the full cell's normal there: `side` for this cell itself, else the opposite
    void addSide(std::size_t axis, int side, int outward)
    {
        for (std::size_t d = 0; d < families; ++d) {
            const double excess = evenlyJoined(d, axis) - evenSquare;
            const double slope = -0.5 * excess * outward;
            m_moments[d][1 + axis] += slope;
            m_moments[d][4 + axis] += slope * side; // 2 x at x = side / 2
        }
    }

    const Vec3& center() const { return m_center; }
    const QuadraticMoments& moments(std::size_t d) const { return m_moments[d]; }

private:
    Vec3 m_center = Vec3::Zero();
    std::array<QuadraticMoments, families> m_moments{};
};

/// The objects around the cells of one row of cells.
class NodesAround {
public:
    NodesAround(const Lattice& lattice, const LatticeRows& rows)
        : m_lattice(lattice)
        , m_rows(rows)
    {
    }

    /// Numbers of the objects in the order of MomentStencil::Point::node; the number of objects where there is none.
    const std::array<ObjectIndex, MomentStencil::nodes>& around(const Lattice::Node& cell)
    {
        constexpr std::int32_t first = MomentStencil::first;
        constexpr std::int32_t across = MomentStencil::across;
        m_objects.fill(static_cast<ObjectIndex>(m_lattice.size()));
        if (cell[0] != m_row[0] || cell[1] != m_row[1])
            goTo(cell[0], cell[1]);
        const std::int32_t low = cell[2] + first;
        for (std::size_t row = 0; row < m_around.size(); ++row)
            for (ObjectIndex i = m_rows.lowerBound(m_around[row], low); i < m_around[row].end; ++i) {
                const std::int32_t w = m_lattice.nodes[i][2] - low;
                if (w >= across)
                    break;
                m_objects[row * across + static_cast<std::size_t>(w)] = i;
            }
        return m_objects;
    }

private:
    void goTo(std::int32_t u, std::int32_t v)
    {
        constexpr std::int32_t across = MomentStencil::across;
        m_row = {u, v};
        for (std::int32_t row = 0; row < across * across; ++row)
            m_around[static_cast<std::size_t>(row)] =
                m_rows.row(u + MomentStencil::first + row / across, v + MomentStencil::first + row % across);
    }

    const Lattice& m_lattice;
    const LatticeRows& m_rows;
    std::array<std::int32_t, 2> m_row{-1, -1}; ///< (u, v) of the cells now
    std::array<LatticeRows::Row, MomentStencil::nodes / MomentStencil::across> m_around{};
    std::array<ObjectIndex, MomentStencil::nodes> m_objects{};
};

/// Cells that give corrections, of one slab.
struct ThinCells {
    struct Bare {
        Lattice::Node cell;
        std::uint8_t sides = 0; ///< bit 2 axis for the lower one, bit 2 axis + 1 for the upper one
    };
    std::vector<const CutCells::Cut*> cut; ///< all but those of thick walls
    std::vector<Bare> bare; ///< full ones that end on the skin, with fewer than three full cells behind it
};

class ThinCellSearch {
public:
    ThinCellSearch(const CutCells& cells, const CellFinder& finder)
        : m_cells(cells)
        , m_finder(finder)
    {
    }

    ThinCells of(std::size_t u) const
    {
        ThinCells thin;
        const CutCells::Slab& slab = m_cells.slabs[u];
        for (const CutCells::Cut& cut : slab.cut)
            if (!isThick(m_finder, {static_cast<std::int32_t>(u), cut.v, cut.w}))
                thin.cut.push_back(&cut);
        for (std::int32_t v = slab.firstRow; v < slab.rowsEnd(); ++v)
            addBare(static_cast<std::int32_t>(u), v, thin.bare);
        return thin;
    }

private:
    void addBare(std::int32_t u, std::int32_t v, std::vector<ThinCells::Bare>& bare) const
    {
        const CutCells::Row row = m_finder.row(u, v);
        const std::array<CutCells::Row, 6> beside{
            m_finder.row(u - 1, v), m_finder.row(u + 1, v), m_finder.row(u, v - 1), m_finder.row(u, v + 1), row, row};
        for (std::size_t i = 0; i < row.w.size(); ++i) {
            if (row.fraction[i] < CellFinder::full)
                continue;
            ThinCells::Bare cell{{u, v, row.w[i]}, 0};
            for (std::size_t side = 0; side < 6; ++side) {
                const std::int32_t w = row.w[i] + (side < 4 ? 0 : side == 4 ? -1 : 1);
                if (CellFinder::fraction(beside[side], w) == 0 && isBare(cell.cell, side / 2, side % 2 == 0 ? -1 : 1))
                    cell.sides |= static_cast<std::uint8_t>(1U << side);
            }
            if (cell.sides != 0)
                bare.push_back(cell);
        }
    }

    /// @pre the cell beside it is not kept
    bool isBare(const Lattice::Node& cell, std::size_t axis, int side) const
    {
        const bool isThin =
            !m_finder.isFull(moved(cell, axis, -side)) || !m_finder.isFull(moved(cell, axis, -2 * side));
        return isThin && !m_finder.isCut(moved(cell, axis, side));
    }

    const CutCells& m_cells;
    const CellFinder& m_finder;
};

class MomentFit {
public:
    MomentFit(const CutCells& cells, const CellFinder& finder, const Aggregate& aggregate)
        : m_finder(finder)
        , m_aggregate(aggregate)
        , m_rows(aggregate.lattice)
        , m_unspread(cells.keptVolume() / cells.volume())
        , m_weight(families)
    {
        forEachBlock(families, 1, [&](std::size_t d, std::size_t) {
            m_weight[d] = aggregate.weight[d];
            for (double& weight : m_weight[d])
                weight *= m_unspread;
        });
    }

    /// Not for slabs less than MomentStencil::across apart at a time.
    void correct(std::int32_t u, const ThinCells& thin)
    {
        Workspace workspace(m_aggregate.lattice, m_rows);
        for (const CutCells::Cut* cut : thin.cut)
            correctCut(*cut, {u, cut->v, cut->w}, workspace);
        for (const ThinCells::Bare& bare : thin.bare) {
            CellCorrection correction;
            for (std::size_t side = 0; side < 6; ++side)
                if ((bare.sides >> side & 1U) != 0)
                    correction.addSide(side / 2, side % 2 == 0 ? -1 : 1, side % 2 == 0 ? -1 : 1);
            spread(correction, bare.cell, workspace);
        }
    }

    std::vector<std::vector<double>> takeWeights() { return std::move(m_weight); }

private:
    struct Workspace {
        Workspace(const Lattice& lattice, const LatticeRows& rows)
            : nodes(lattice, rows)
        {
        }
        NodesAround nodes;
        std::vector<double> today;
        std::vector<double> more;
    };

    void correctCut(const CutCells::Cut& cut, const Lattice::Node& cell, Workspace& workspace)
    {
        CellCorrection correction(cut.moments, m_finder.fraction(cell) > 0 ? cut.moments.value[0] : 0);
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (const int side : {-1, 1})
                if (m_finder.isFull(moved(cell, axis, side)))
                    correction.addSide(axis, side, -side);
        spread(correction, cell, workspace);
    }

    void spread(const CellCorrection& correction, const Lattice::Node& cell, Workspace& workspace)
    {
        const auto& objects = workspace.nodes.around(cell);
        for (std::size_t d = 0; d < families; ++d) {
            const MomentStencil& stencil = MomentStencil::of(d, correction.center());
            const auto& points = stencil.points();
            const std::vector<double>& weight = m_aggregate.weight[d];
            workspace.today.resize(points.size());
            for (std::size_t b = 0; b < points.size(); ++b) {
                const ObjectIndex object = objects[points[b].node];
                workspace.today[b] = object < weight.size() ? m_unspread * weight[object] : 0;
            }
            stencil.spread(correction.moments(d), workspace.today, workspace.more);
            for (std::size_t b = 0; b < points.size(); ++b)
                if (workspace.today[b] > 0)
                    m_weight[d][objects[points[b].node]] += workspace.more[b];
        }
    }

    const CellFinder& m_finder;
    const Aggregate& m_aggregate;
    LatticeRows m_rows;
    double m_unspread;
    std::vector<std::vector<double>> m_weight; // per family
};

/// Takes new weights, none below the least, each family with the sum that the material has.
void setWeights(Aggregate& aggregate, std::vector<std::vector<double>> weight, double cells)
{
    forEachBlock(families, 1, [&](std::size_t d, std::size_t) {
        std::vector<double>& of = weight[d];
        for (std::size_t i = 0; i < of.size(); ++i)
            of[i] = aggregate.weight[d][i] > 0 ? std::max(of[i], leastWeight) : 0;
        const double scale = cells / std::accumulate(of.begin(), of.end(), 0.0);
        for (double& one : of)
            one *= scale;
        aggregate.weight[d] = std::move(of);
    });
}

/// An eighteenth of the weights of its connections, as in the bulk, where there are as many.
void setVolumes(Aggregate& aggregate)
{
    const double a = aggregate.lattice.spacing;
    const double share = a * a * a / 18;
    std::fill(aggregate.volume.begin(), aggregate.volume.end(), 0.0);
    for (std::size_t d = 0; d < families; ++d)
        for (const Lattice::Segment& segment : aggregate.lattice.segments[d])
            for (ObjectIndex low = segment.begin; low < segment.end; ++low) {
                const double volume = share * aggregate.weight[d][low];
                aggregate.volume[low] += volume;
                aggregate.volume[low + static_cast<ObjectIndex>(segment.offset)] += volume;
            }
}

} // namespace

Aggregate withFittedMoments(const CutCells& cells, Aggregate aggregate, TaskControl& control)
{
    const CellFinder finder(cells);
    const ThinCellSearch search(cells, finder);
    const std::size_t slabs = cells.slabs.size();
    std::vector<ThinCells> thin(slabs);
    forEachBlock(slabs, 1, [&](std::size_t u, std::size_t) { thin[u] = search.of(u); });
    if (std::all_of(thin.begin(), thin.end(), [](const ThinCells& of) { return of.cut.empty() && of.bare.empty(); }))
        return aggregate;

    MomentFit fit(cells, finder, aggregate);
    // Slabs that reach the same objects are done one after the other, so that sums are always taken in the same order.
    constexpr std::size_t apart = MomentStencil::across;
    for (std::size_t color = 0; color < std::min(apart, slabs); ++color) {
        TaskPortion portion(control, static_cast<double>(color) / apart, static_cast<double>(color + 1) / apart);
        forEachBlock((slabs - color + apart - 1) / apart, 1, portion, "fitting walls", [&](std::size_t i, std::size_t) {
            const std::size_t u = color + i * apart;
            fit.correct(static_cast<std::int32_t>(u), thin[u]);
        });
    }
    setWeights(aggregate, fit.takeWeights(), cells.volume());
    setVolumes(aggregate);
    return aggregate;
}

} // namespace knead
