#include "core/aggregate/moment_weights.h"

#include "core/aggregate/lattice_rows.h"
#include "core/aggregate/moment_spread.h"
#include "core/aggregate/thin_cells.h"
#include "core/task/parallel_progress.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace knead {

namespace {

constexpr std::size_t familyCount = Lattice::isotropicCount;

// The two diagonals of a face of cells cross in their middles and have the same weights, so only one of them is fitted: uv, uw, vw.
constexpr std::array<std::size_t, 3> diagonals{3, 5, 7};
constexpr std::array<std::size_t, 3> alongAxes{0, 1, 2};

/// Second moment [a^2] that the material gets beside its own, per family.
///
/// A lattice bends a little softer than the continuum between its surfaces, and twists stiffer, as few objects across
/// cannot warp: with two cells across not at all, which takes a sixth of a square's stiffness. Connections along the axes bear
/// bending alone, diagonal ones bear all of torsion, so the former get more and the latter less.
constexpr double softness(std::size_t direction)
{
    return direction < 3 ? 0.082 : -0.007;
}

// What diagonal connections across a wall of less than three cells have too much or too little of, those along the axes make
// up for. In a bar bent along u, diagonals have (1 - nu)^2 / 2 of the energy of connections along u, 1.125 of it for nu = 1/4 and
// four of them. A sheet, which stays as wide, needs more, and so does what the least weight leaves over: bars of 1.15 cells are
// 1.31 with 1.125, 1.09 with 2 and .97 with 3 times as stiff as they should be, of 2 cells 1.04, 1.08 and 1.13.
constexpr double borneByAxes = 1.9;

// Of a full connection. A wall's outermost ones may be asked for less than nothing; springs must push back. A bar of one cell is
// 1.31 times as stiff as it should be with .01, 1.20 times with this.
constexpr double leastWeight = 0.005;

/// Second moment along `axis` of a unit of weight that joinCells() gives the connections of a cell.
double evenlyJoined(std::size_t direction, std::size_t axis)
{
    return Lattice::directions[direction][axis] == 0 ? 0.25 : 0;
}

/// Which cells of an axis go together: pairs from both ends, so that a symmetric body is fitted symmetrically. Where their
/// number is odd, the one in the middle and up to one beside it on each side are alone.
class CellPairs {
public:
    /// @param cells from first to first + cells - 1
    CellPairs(std::int32_t first, std::int32_t cells)
        : m_first(first)
        , m_cells(cells)
    {
    }

    /// Ascending with the cells.
    std::int32_t numberOf(std::int32_t cell) const
    {
        const std::int32_t at = cell - m_first;
        const std::int32_t middle = m_cells / 2;
        if (m_cells % 2 == 0 || at < middle)
            return at / 2;
        const std::int32_t below = (middle + 1) / 2;
        return at == middle ? below : 2 * below - (m_cells - 1 - at) / 2;
    }

    /// The first one of its pair.
    std::int32_t firstOf(std::int32_t cell) const
    {
        return cell > m_first && numberOf(cell - 1) == numberOf(cell) ? cell - 1 : cell;
    }

    std::int32_t count() const { return m_cells <= 0 ? 0 : numberOf(m_first + m_cells - 1) + 1; }

private:
    std::int32_t m_first;
    std::int32_t m_cells;
};

using Pairing = std::array<CellPairs, 3>;
using Place = std::array<std::int32_t, 3>; ///< of a block: numbers of its pairs

Place placeOf(const Lattice::Node& cell, const Pairing& pairing)
{
    return {pairing[0].numberOf(cell[0]), pairing[1].numberOf(cell[1]), pairing[2].numberOf(cell[2])};
}

/// Two cells per axis, whose corrections are spread together: an eighth to a quarter of the work of one after the other.
///
/// What they give to the connections of a family beside what joinCells() does:
///  - of a cut cell the moments of its material, less what it gave already;
///  - of the sides of full cells -excess / 2 times the derivative along the outward normal, taken over the side. Between full
///    cells the second moments that are too large cancel but for these.
/// excess = evenlyJoined() - 1/12 - softness() differs from family to family, so what it multiplies is summed up apart.
class ThinBlock {
public:
    /// @param cell any of it
    ThinBlock(const Pairing& pairing, const Lattice::Node& cell)
        : m_place(placeOf(cell, pairing))
        , m_node{pairing[0].firstOf(cell[0]) + 1, pairing[1].firstOf(cell[1]) + 1, pairing[2].firstOf(cell[2]) + 1}
    {
    }

    void add(const ThinCell& cell)
    {
        Vec3 step(cell.cell[0] - m_node[0], cell.cell[1] - m_node[1], cell.cell[2] - m_node[2]);
        step += Vec3::Constant(0.5);
        // A full cell gives its part of the sides that are skin, a cut one that of the full cells beside it.
        cell.forEachSide(
            [&](std::size_t axis, int side) { addSide(axis, side, cell.cut != nullptr ? -side : side, step); });
        if (cell.cut != nullptr)
            addMaterial(cell.cut->moments.value, cell.isKept, step);
        m_centers += step;
        ++m_cells;
    }

    const Place& place() const { return m_place; }
    const Lattice::Node& node() const { return m_node; } ///< in it

    /// Middle of the material, from the node [a].
    Vec3 center() const { return m_centers / m_cells; }

    /// About the middle of the material. Those of connections along the axes are known once setResidual() was called for all diagonals.
    QuadraticMoments moments(std::size_t direction) const
    {
        QuadraticMoments sum = m_material;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double even = evenlyJoined(direction, axis);
            const double excess = even - 1.0 / 12 - softness(direction);
            sum[4 + axis] += softness(direction) * m_volume - even * m_keptVolume;
            for (std::size_t k = 0; k < sum.size(); ++k)
                sum[k] += excess * m_sides[axis][k];
        }
        sum = moved(sum, -center());
        if (direction < diagonals.size())
            for (std::size_t k = 4; k < sum.size(); ++k)
                sum[k] -= borneByAxes * meanResidual(direction, k);
        return sum;
    }

    /// What a fit of diagonals has beside what it should.
    void setResidual(std::size_t direction, const QuadraticMoments& residual)
    {
        m_residual[diagonalNumber(direction)] = residual;
    }

private:
    static std::size_t diagonalNumber(std::size_t direction) { return (direction - diagonals[0]) / 2; }

    /// Over the diagonals that go along an axis: all but those of the face across it.
    double meanResidual(std::size_t axis, std::size_t term) const
    {
        double sum = 0;
        for (std::size_t number = 0; number < diagonals.size(); ++number)
            if (number != diagonals.size() - 1 - axis)
                sum += m_residual[number][term];
        return sum / 2;
    }

    void addMaterial(const QuadraticMoments& moments, bool isKept, const Vec3& step)
    {
        m_volume += moments[0];
        m_centers += Vec3(moments[1], moments[2], moments[3]) / moments[0];
        QuadraticMoments lacking = moments;
        if (isKept) {
            m_keptVolume += moments[0];
            // What was given lies at the cell's middle, but for its second moments there.
            lacking[0] = 0;
        }
        addTo(m_material, moved(lacking, step));
    }

    void addSide(std::size_t axis, int side, int outward, const Vec3& step)
    {
        QuadraticMoments slope{};
        slope[1 + axis] = -0.5 * outward;
        slope[4 + axis] = -0.5 * outward * side; // 2 x at x = side / 2
        addTo(m_sides[axis], moved(slope, step));
    }

    static void addTo(QuadraticMoments& sum, const QuadraticMoments& one)
    {
        for (std::size_t k = 0; k < sum.size(); ++k)
            sum[k] += one[k];
    }

    Place m_place;
    Lattice::Node m_node;
    Vec3 m_centers = Vec3::Zero();
    double m_cells = 0;
    double m_volume = 0;     // of cut cells
    double m_keptVolume = 0; // of those that joinCells() has seen
    QuadraticMoments m_material{};
    std::array<QuadraticMoments, 3> m_sides{};    // per axis of the sides
    std::array<QuadraticMoments, 3> m_residual{}; // per pair of diagonals
};

/// Pairs of the cells that there are.
Pairing pairsOf(const std::vector<std::vector<ThinCell>>& slabs)
{
    Eigen::AlignedBox3i bounds;
    for (const std::vector<ThinCell>& slab : slabs)
        for (const ThinCell& cell : slab)
            bounds.extend(Eigen::Map<const Eigen::Vector3i>(cell.cell.data()));
    const auto along = [&](Eigen::Index axis) {
        return CellPairs(bounds.min()[axis], bounds.max()[axis] - bounds.min()[axis] + 1);
    };
    return {along(0), along(1), along(2)};
}

/// By the number of their first pair, ascending.
std::vector<std::vector<ThinBlock>> blocksOf(const std::vector<std::vector<ThinCell>>& slabs)
{
    const Pairing pairing = pairsOf(slabs);
    std::vector<std::vector<ThinCell>> together(static_cast<std::size_t>(pairing[0].count()));
    for (const std::vector<ThinCell>& slab : slabs)
        if (!slab.empty()) {
            auto& cells = together[static_cast<std::size_t>(pairing[0].numberOf(slab.front().cell[0]))];
            cells.insert(cells.end(), slab.begin(), slab.end());
        }
    std::vector<std::vector<ThinBlock>> all(together.size());
    forEachBlock(all.size(), 1, [&](std::size_t i, std::size_t) {
        std::vector<ThinCell>& cells = together[i];
        const auto isBefore = [&](const ThinCell& one, const ThinCell& other) {
            return std::pair(placeOf(one.cell, pairing), one.cell) <
                   std::pair(placeOf(other.cell, pairing), other.cell);
        };
        std::stable_sort(cells.begin(), cells.end(), isBefore);
        for (const ThinCell& cell : cells) {
            if (all[i].empty() || all[i].back().place() != placeOf(cell.cell, pairing))
                all[i].emplace_back(pairing, cell.cell);
            all[i].back().add(cell);
        }
    });
    return all;
}

/// The objects around nodes, quicker for nodes of the same row one after the other.
class ObjectsAround {
public:
    ObjectsAround(const Lattice& lattice, const LatticeRows& rows)
        : m_lattice(lattice)
        , m_rows(rows)
    {
    }

    const MomentSpread::Objects& around(const Lattice::Node& node)
    {
        constexpr std::int32_t across = MomentSpread::across;
        m_objects.fill(static_cast<ObjectIndex>(m_lattice.size()));
        if (m_row != std::array{node[0], node[1]})
            goTo(node[0], node[1]);
        const std::int32_t low = node[2] - MomentSpread::reach;
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
        constexpr std::int32_t across = MomentSpread::across;
        m_row = {u, v};
        for (std::int32_t row = 0; row < across * across; ++row)
            m_around[static_cast<std::size_t>(row)] =
                m_rows.row(u - MomentSpread::reach + row / across, v - MomentSpread::reach + row % across);
    }

    const Lattice& m_lattice;
    const LatticeRows& m_rows;
    std::array<std::int32_t, 2> m_row{-1, -1}; ///< (u, v) of the node now
    std::array<LatticeRows::Row, MomentSpread::nodes / MomentSpread::across> m_around{};
    MomentSpread::Objects m_objects{};
};

class MomentFit {
public:
    MomentFit(const CutCells& cells, const Aggregate& aggregate)
        : m_aggregate(aggregate)
        , m_rows(aggregate.lattice)
        , m_weight(familyCount)
    {
        const double unspread = cells.keptVolume() / cells.volume();
        forEachBlock(familyCount, 1, [&](std::size_t d, std::size_t) {
            m_weight[d] = aggregate.weight[d];
            for (double& weight : m_weight[d])
                weight *= unspread;
        });
    }

    /// Not for blocks less than MomentSpread::across apart at a time in one family.
    /// @param d the diagonals first, then alongAxes
    void correct(std::vector<ThinBlock>& blocks, std::size_t d)
    {
        ObjectsAround objects(m_aggregate.lattice, m_rows);
        MomentSpread spread;
        for (ThinBlock& block : blocks) {
            const MomentSpread::Objects& around = objects.around(block.node());
            give(spread.spread(d, block.moments(d), block.center(), around, m_aggregate.weight[d]), d, around);
            if (d >= diagonals[0])
                block.setResidual(d, spread.residual());
        }
    }

    std::vector<std::vector<double>> takeWeights() { return std::move(m_weight); }

private:
    void give(const std::vector<MomentSpread::Share>& shares, std::size_t d, const MomentSpread::Objects& objects)
    {
        for (const auto& [node, weight] : shares)
            m_weight[d][objects[node]] += weight;
        if (d < diagonals[0])
            return;
        // The other diagonal begins one further along the axis that it goes down.
        constexpr std::size_t across = MomentSpread::across;
        const std::size_t further = d == diagonals[0] ? across : 1;
        for (const auto& [node, weight] : shares)
            m_weight[d + 1][objects[node + further]] += weight;
    }

    const Aggregate& m_aggregate;
    LatticeRows m_rows;
    std::vector<std::vector<double>> m_weight; // per family
};

/// One family of a pair of slabs at a time, so that flat bodies have work for several threads.
void fitFamilies(MomentFit& fit, std::vector<std::vector<ThinBlock>>& blocks,
                 const std::array<std::size_t, 3>& families, TaskControl& control)
{
    // Blocks that reach the same objects are done one after the other, so that sums are always taken in the same order.
    // Five blocks are seven nodes at least, with three single cells among them.
    constexpr std::size_t apart = 5;
    for (std::size_t color = 0; color < std::min(apart, blocks.size()); ++color) {
        TaskPortion portion(control, static_cast<double>(color) / apart, static_cast<double>(color + 1) / apart);
        const std::size_t count = (blocks.size() - color + apart - 1) / apart;
        forEachBlock(count * families.size(), 1, portion, "fitting walls", [&](std::size_t i, std::size_t) {
            fit.correct(blocks[color + i / families.size() * apart], families[i % families.size()]);
        });
    }
}

/// Takes new weights, none below the least, each family with the sum that the material has.
void setWeights(Aggregate& aggregate, std::vector<std::vector<double>> weight, double cells)
{
    forEachBlock(familyCount, 1, [&](std::size_t d, std::size_t) {
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
    for (std::size_t d = 0; d < familyCount; ++d)
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
    const std::vector<std::vector<ThinCell>> thin = findThinCells(cells);
    if (std::all_of(thin.begin(), thin.end(), [](const auto& slab) { return slab.empty(); }))
        return aggregate;

    std::vector<std::vector<ThinBlock>> blocks = blocksOf(thin);
    MomentFit fit(cells, aggregate);
    TaskPortion first(control, 0, 0.5);
    fitFamilies(fit, blocks, diagonals, first);
    TaskPortion second(control, 0.5, 1);
    fitFamilies(fit, blocks, alongAxes, second);
    setWeights(aggregate, fit.takeWeights(), cells.volume());
    setVolumes(aggregate);
    return aggregate;
}

} // namespace knead
