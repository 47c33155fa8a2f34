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
/// cannot warp. Connections along the axes bear bending alone, diagonal ones bear all of torsion, so the former get more.
constexpr double softness(std::size_t direction)
{
    return direction < 3 ? 0.05 : 0.005;
}

// What diagonal connections across a wall of less than three cells have too much or too little of, those along the axes make
// up for. In a bar bent along u, diagonals have (1 - nu)^2 / 2 of the energy of connections along u; for nu = 1/4 and four of them.
constexpr double borneByAxes = 1.125;

// Of a full connection. A wall's outermost ones may be asked for less than nothing; springs must push back.
constexpr double leastWeight = 0.02;

/// Second moment along `axis` of a unit of weight that joinCells() gives the connections of a cell.
double evenlyJoined(std::size_t direction, std::size_t axis)
{
    return Lattice::directions[direction][axis] == 0 ? 0.25 : 0;
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
    using Place = std::array<std::int32_t, 3>;

    /// @param cell any of it
    static Place placeOf(const Lattice::Node& cell) { return {cell[0] / 2, cell[1] / 2, cell[2] / 2}; }

    explicit ThinBlock(const Place& place)
        : m_place(place)
    {
    }

    void add(const ThinCell& cell)
    {
        const Lattice::Node at = middle();
        Vec3 step(cell.cell[0] - at[0], cell.cell[1] - at[1], cell.cell[2] - at[2]);
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
    Lattice::Node middle() const { return {2 * m_place[0] + 1, 2 * m_place[1] + 1, 2 * m_place[2] + 1}; }

    /// Middle of the material, from the middle of the block [a].
    Vec3 center() const { return m_centers / m_cells; }

    /// About the middle of the block. Those of connections along the axes are known once setResidual() was called for all diagonals.
    QuadraticMoments moments(std::size_t direction) const
    {
        QuadraticMoments sum = m_material;
        if (direction < diagonals.size())
            for (std::size_t k = 4; k < sum.size(); ++k)
                sum[k] -= borneByAxes * meanResidual(direction, k);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double even = evenlyJoined(direction, axis);
            const double excess = even - 1.0 / 12 - softness(direction);
            sum[4 + axis] += softness(direction) * m_volume - even * m_keptVolume;
            for (std::size_t k = 0; k < sum.size(); ++k)
                sum[k] += excess * m_sides[axis][k];
        }
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

    Place m_place; // of its first cell, halved
    Vec3 m_centers = Vec3::Zero();
    double m_cells = 0;
    double m_volume = 0;     // of cut cells
    double m_keptVolume = 0; // of those that joinCells() has seen
    QuadraticMoments m_material{};
    std::array<QuadraticMoments, 3> m_sides{};    // per axis of the sides
    std::array<QuadraticMoments, 3> m_residual{}; // per pair of diagonals
};

/// The blocks of two slabs, ascending.
std::vector<ThinBlock> blocksOf(std::span<const std::vector<ThinCell>> slabs)
{
    std::vector<ThinCell> cells;
    for (const std::vector<ThinCell>& slab : slabs)
        cells.insert(cells.end(), slab.begin(), slab.end());
    std::stable_sort(cells.begin(), cells.end(), [](const ThinCell& one, const ThinCell& other) {
        return ThinBlock::placeOf(one.cell) < ThinBlock::placeOf(other.cell);
    });
    std::vector<ThinBlock> blocks;
    for (const ThinCell& cell : cells) {
        const ThinBlock::Place place = ThinBlock::placeOf(cell.cell);
        if (blocks.empty() || blocks.back().place() != place)
            blocks.emplace_back(place);
        blocks.back().add(cell);
    }
    return blocks;
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
            const MomentSpread::Objects& around = objects.around(block.middle());
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
    constexpr std::size_t apart = (MomentSpread::across + 1) / 2;
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

    const std::size_t slabs = thin.size();
    std::vector<std::vector<ThinBlock>> blocks((slabs + 1) / 2);
    forEachBlock(blocks.size(), 1, [&](std::size_t i, std::size_t) {
        blocks[i] = blocksOf(std::span(thin).subspan(2 * i, std::min<std::size_t>(2, slabs - 2 * i)));
    });
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
