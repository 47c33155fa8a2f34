#include "core/aggregate/thin_walls.h"

#include "core/aggregate/objects_around.h"

#include <algorithm>

namespace knead {

namespace {

constexpr double thin = 1.75;      // [cells]
constexpr double leastKept = 0.83; // at one cell
constexpr double reach = 2.5;      // [a] that a block is heard from its middle

double keptAt(double thickness)
{
    return 1 - (1 - leastKept) * std::clamp((thin - thickness) / (thin - 1), 0.0, 1.0);
}

/// Per object, by the blocks around it.
std::vector<double> keptByObjects(const Aggregate& aggregate, const std::vector<std::vector<ThinBlock>>& blocks)
{
    const LatticeRows rows(aggregate.lattice);
    ObjectsAround objects(aggregate.lattice, rows);
    std::vector<double> kept(aggregate.size(), 0);
    std::vector<double> heard(aggregate.size(), 0);
    for (const std::vector<ThinBlock>& slab : blocks)
        for (const ThinBlock& block : slab) {
            const MomentSpread::Objects& around = objects.around(block.node());
            const double here = keptAt(block.shape().thickness());
            for (std::size_t i = 0; i < around.size(); ++i) {
                const double part = 1 - (MomentSpread::stepTo(i) - block.center()).squaredNorm() / (reach * reach);
                if (around[i] >= kept.size() || part <= 0)
                    continue;
                kept[around[i]] += part * here;
                heard[around[i]] += part;
            }
        }
    for (std::size_t i = 0; i < kept.size(); ++i)
        kept[i] = heard[i] > 0 ? kept[i] / heard[i] : 1;
    return kept;
}

} // namespace

void loosenThinWalls(Aggregate& aggregate, const std::vector<std::vector<ThinBlock>>& blocks)
{
    const auto isThin = [](const ThinBlock& block) { return block.shape().thickness() < thin; };
    if (std::ranges::none_of(blocks, [&](const auto& slab) { return std::ranges::any_of(slab, isThin); }))
        return;
    const std::vector<double> kept = keptByObjects(aggregate, blocks);
    aggregate.forEachConnection([&](std::uint32_t d, ObjectIndex lower, ObjectIndex upper) {
        aggregate.weight[d][lower] *= 0.5 * (kept[lower] + kept[upper]);
    });
}

} // namespace knead
