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

constexpr std::size_t families = Lattice::isotropicCount;

/// Second moment [a^2] that the material gets beside its own, per family.
///
/// A lattice bends a little softer than the continuum between its surfaces, and twists stiffer, as few objects across
/// cannot warp: a bar of two cells is -10 % in bending and +19 % in torsion with nothing. Connections along the axes bear
/// bending alone, diagonal ones bear all of torsion, so the former get it. With 0.025 for all, torsion is +28 % there.
constexpr double softness(std::size_t direction)
{
    return direction < 3 ? 0.065 : 0;
}

// Of a full connection. A wall's outermost ones may be asked for less than nothing; springs must push back.
constexpr double leastWeight = 0.02;

/// Second moment along `axis` of a unit of weight that joinCells() gives the connections of a cell.
double evenlyJoined(std::size_t direction, std::size_t axis)
{
    return Lattice::directions[direction][axis] == 0 ? 0.25 : 0;
}

/// What one cell gives to the connections of a family around it beside what joinCells() does.
class CellCorrection {
public:
    CellCorrection(const ThinCell& cell, std::size_t direction)
        : m_direction(direction)
    {
        if (cell.cut != nullptr)
            takeMoments(cell.cut->moments, cell.isKept);
        // A full cell gives its part of the sides that are skin, a cut one that of the full cells beside it.
        cell.forEachSide([&](std::size_t axis, int side) { addSide(axis, side, cell.cut != nullptr ? -side : side); });
    }

    const QuadraticMoments& moments() const { return m_moments; }

private:
    /// Of a cut cell: the moments of its material, less what it gave already.
    void takeMoments(const CellMoments& moments, bool isKept)
    {
        m_moments = moments.value;
        const double kept = isKept ? moments.value[0] : 0;
        m_moments[0] -= kept;
        for (std::size_t axis = 0; axis < 3; ++axis)
            m_moments[4 + axis] += softness(m_direction) * moments.value[0] - kept * evenlyJoined(m_direction, axis);
    }

    /// Between full cells the second moments that are too large cancel but for a part at their outer sides:
    ///   -excess / 2 times the derivative along the outward normal, taken over the side.
    /// @param side of this cell along an axis, -1 or 1
    /// @param outward direction of the full cell's normal there
    void addSide(std::size_t axis, int side, int outward)
    {
        const double excess = evenlyJoined(m_direction, axis) - (1.0 / 12 + softness(m_direction));
        const double slope = -0.5 * excess * outward;
        m_moments[1 + axis] += slope;
        m_moments[4 + axis] += slope * side; // 2 x at x = side / 2
    }

    std::size_t m_direction;
    QuadraticMoments m_moments{};
};

/// Middle of the material, from the middle of the cell [a].
Vec3 centerOf(const ThinCell& cell)
{
    if (cell.cut == nullptr)
        return Vec3::Zero();
    const auto& m = cell.cut->moments.value;
    return Vec3(m[1], m[2], m[3]) / m[0];
}

/// Two cells per axis, whose corrections are spread together: a quarter to a seventh of the time of doing it cell by cell.
struct ThinBlock {
    std::array<std::int32_t, 3> place{}; ///< of its first cell, halved
    std::vector<ThinCell> cells;

    Lattice::Node middle() const { return {2 * place[0] + 1, 2 * place[1] + 1, 2 * place[2] + 1}; }

    Vec3 fromMiddle(const Lattice::Node& cell) const
    {
        const Lattice::Node at = middle();
        return Vec3(cell[0] - at[0], cell[1] - at[1], cell[2] - at[2]) + Vec3::Constant(0.5);
    }

    /// Middle of the material, from the middle of the block [a].
    Vec3 center() const
    {
        Vec3 sum = Vec3::Zero();
        for (const ThinCell& cell : cells)
            sum += fromMiddle(cell.cell) + centerOf(cell);
        return sum / static_cast<double>(cells.size());
    }

    QuadraticMoments moments(std::size_t direction) const
    {
        QuadraticMoments sum{};
        for (const ThinCell& cell : cells) {
            const QuadraticMoments one = moved(CellCorrection(cell, direction).moments(), fromMiddle(cell.cell));
            for (std::size_t k = 0; k < sum.size(); ++k)
                sum[k] += one[k];
        }
        return sum;
    }
};

/// The blocks of two slabs, ascending.
std::vector<ThinBlock> blocksOf(std::span<const std::vector<ThinCell>> slabs)
{
    std::vector<ThinCell> cells;
    for (const std::vector<ThinCell>& slab : slabs)
        cells.insert(cells.end(), slab.begin(), slab.end());
    const auto place = [](const ThinCell& cell) {
        return std::array<std::int32_t, 3>{cell.cell[0] / 2, cell.cell[1] / 2, cell.cell[2] / 2};
    };
    std::stable_sort(cells.begin(), cells.end(),
                     [&](const ThinCell& one, const ThinCell& other) { return place(one) < place(other); });
    std::vector<ThinBlock> blocks;
    for (const ThinCell& cell : cells) {
        if (blocks.empty() || blocks.back().place != place(cell))
            blocks.push_back({place(cell), {}});
        blocks.back().cells.push_back(cell);
    }
    return blocks;
}

/// The objects around nodes, quicker for nodes of the same row one after the other.
class ObjectsAround {
public:
    explicit ObjectsAround(const Lattice& lattice, const LatticeRows& rows)
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
        , m_weight(families)
    {
        const double unspread = cells.keptVolume() / cells.volume();
        forEachBlock(families, 1, [&](std::size_t d, std::size_t) {
            m_weight[d] = aggregate.weight[d];
            for (double& weight : m_weight[d])
                weight *= unspread;
        });
    }

    /// Not for blocks less than MomentSpread::across apart at a time in one family.
    /// @param familyGroup 0 .. familyGroups - 1: a third of the families, so that flat bodies have work for many threads
    void correct(const std::vector<ThinBlock>& blocks, std::size_t familyGroup)
    {
        ObjectsAround objects(m_aggregate.lattice, m_rows);
        MomentSpread spread;
        for (const ThinBlock& block : blocks) {
            const MomentSpread::Objects& around = objects.around(block.middle());
            const Vec3 center = block.center();
            for (std::size_t d = familyGroup; d < families; d += familyGroups)
                for (const auto& [object, weight] :
                     spread.spread(d, block.moments(d), center, around, m_aggregate.weight[d]))
                    m_weight[d][object] += weight;
        }
    }

    std::vector<std::vector<double>> takeWeights() { return std::move(m_weight); }

    static constexpr std::size_t familyGroups = 3;

private:
    const Aggregate& m_aggregate;
    LatticeRows m_rows;
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
    const std::vector<std::vector<ThinCell>> thin = findThinCells(cells);
    if (std::all_of(thin.begin(), thin.end(), [](const auto& slab) { return slab.empty(); }))
        return aggregate;

    const std::size_t slabs = thin.size();
    std::vector<std::vector<ThinBlock>> blocks((slabs + 1) / 2);
    forEachBlock(blocks.size(), 1, [&](std::size_t i, std::size_t) {
        blocks[i] = blocksOf(std::span(thin).subspan(2 * i, std::min<std::size_t>(2, slabs - 2 * i)));
    });
    MomentFit fit(cells, aggregate);
    // Blocks that reach the same objects are done one after the other, so that sums are always taken in the same order.
    constexpr std::size_t apart = (MomentSpread::across + 1) / 2;
    constexpr std::size_t groups = MomentFit::familyGroups;
    for (std::size_t color = 0; color < std::min(apart, blocks.size()); ++color) {
        TaskPortion portion(control, static_cast<double>(color) / apart, static_cast<double>(color + 1) / apart);
        const std::size_t count = (blocks.size() - color + apart - 1) / apart;
        forEachBlock(count * groups, 1, portion, "fitting walls", [&](std::size_t i, std::size_t) {
            fit.correct(blocks[color + i / groups * apart], i % groups);
        });
    }
    setWeights(aggregate, fit.takeWeights(), cells.volume());
    setVolumes(aggregate);
    return aggregate;
}

} // namespace knead
