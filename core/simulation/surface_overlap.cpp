#include "core/simulation/surface_overlap.h"

#include "core/task/parallel.h"

#include <algorithm>
#include <vector>

namespace knead {

namespace {

constexpr std::size_t blockSize = 4096;

// Objects so deep feel surfaces with this radius [spacings], so that edges do not slip in between those of the skin.
constexpr double innerReach = 1.0 / 3;

double reachOf(double depth, double spacing)
{
    return depth < spacing ? std::max(depth, -spacing) : innerReach * spacing;
}

} // namespace

double overlapOf(const RigidSurface& surface, const VectorArray& position, const Aggregate& aggregate)
{
    const double spacing = aggregate.lattice.spacing;
    const Box reach = surface.reach(spacing);
    std::vector<double> deepest((position.size() + blockSize - 1) / blockSize, -spacing);
    forEachBlock(position.size(), blockSize, [&](std::size_t begin, std::size_t end) {
        double& most = deepest[begin / blockSize];
        for (std::size_t i = begin; i < end; ++i)
            if (const Vec3 place = position.at(i); reach.contains(place))
                most = std::max(most, reachOf(aggregate.depth[i], spacing) - surface.nearest(place).distance);
    });
    return deepest.empty() ? -spacing : *std::max_element(deepest.begin(), deepest.end());
}

} // namespace knead
