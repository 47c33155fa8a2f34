#include "core/aggregate/moment_weights.h"

#include "core/aggregate/lattice_rows.h"
#include "core/aggregate/local_shape.h"
#include "core/aggregate/moment_spread.h"
#include "core/aggregate/objects_around.h"
#include "core/aggregate/thin_blocks.h"
#include "core/aggregate/thin_cells.h"
#include "core/aggregate/thin_walls.h"
#include "core/task/parallel_progress.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace knead {

namespace {

constexpr std::size_t familyCount = Lattice::isotropicCount;

constexpr std::array<std::size_t, 3> alongAxes{0, 1, 2};

// Of a full connection. A wall's outermost ones may be asked for less than nothing; springs must push back.
constexpr double leastWeight = 0.016;

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
            if (d >= faceDiagonals[0])
                block.setResidual(d, spread.residual());
        }
    }

    std::vector<std::vector<double>> takeWeights() { return std::move(m_weight); }

private:
    void give(const std::vector<MomentSpread::Share>& shares, std::size_t d, const MomentSpread::Objects& objects)
    {
        for (const auto& [node, weight] : shares)
            m_weight[d][objects[node]] += weight;
        if (d < faceDiagonals[0])
            return;
        // The other diagonal begins one further along the axis that it goes down, if it is there.
        constexpr std::size_t across = MomentSpread::across;
        const std::size_t further = d == faceDiagonals[0] ? across : 1;
        for (const auto& [node, weight] : shares)
            if (const ObjectIndex other = objects[node + further]; other < m_weight[d + 1].size())
                m_weight[d + 1][other] += weight;
    }

    const Aggregate& m_aggregate;
    LatticeRows m_rows;
    std::vector<std::vector<double>> m_weight; // per family
};

void findShapes(const CutCells& cells, std::vector<std::vector<ThinBlock>>& blocks, TaskControl& control)
{
    const CellFinder finder(cells);
    std::vector<ThinBlock*> all; // a sheet across u is one slab
    for (std::vector<ThinBlock>& slab : blocks)
        for (ThinBlock& block : slab)
            all.push_back(&block);
    forEachBlock(all.size(), 256, control, "fitting walls", [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            all[i]->setShape(localShapeAt(finder, all[i]->centerInLattice()));
    });
}

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

} // namespace

Aggregate withFittedMoments(const CutCells& cells, Aggregate aggregate, TaskControl& control)
{
    const std::vector<std::vector<ThinCell>> thin = findThinCells(cells);
    if (std::ranges::all_of(thin, [](const auto& slab) { return slab.empty(); }))
        return aggregate;

    std::vector<std::vector<ThinBlock>> blocks = thinBlocksOf(thin);
    TaskPortion shapes(control, 0, 0.1);
    findShapes(cells, blocks, shapes);
    MomentFit fit(cells, aggregate);
    TaskPortion first(control, 0.1, 0.5);
    fitFamilies(fit, blocks, faceDiagonals, first);
    TaskPortion second(control, 0.5, 1);
    fitFamilies(fit, blocks, alongAxes, second);
    setWeights(aggregate, fit.takeWeights(), cells.volume());
    aggregate.volume = aggregate.borneVolume(); // in thin walls there are not as many connections as in the bulk
    loosenThinWalls(aggregate, blocks);
    return aggregate;
}

} // namespace knead
