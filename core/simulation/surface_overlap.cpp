#include "core/simulation/surface_overlap.h"

#include "core/task/parallel.h"

#include <algorithm>
#include <vector>

namespace knead {

namespace {

constexpr std::size_t blockSize = 4096;

// Objects this much below the skin must not be in a surface; above, the skin itself is looked at [spacings].
constexpr double shallowest = 0.3;

} // namespace

double overlapOf(const RigidSurface& surface, const VectorArray& position, const Aggregate& aggregate)
{
    const double spacing = aggregate.lattice.spacing;
    const Box reach = surface.reach(spacing);
    std::vector<double> deepest((position.size() + blockSize - 1) / blockSize, -spacing);
    forEachBlock(position.size(), blockSize, [&](std::size_t begin, std::size_t end) {
        double& most = deepest[begin / blockSize];
        for (std::size_t i = begin; i < end; ++i)
            if (const Vec3 place = position.at(i); aggregate.depth[i] > shallowest * spacing && reach.contains(place))
                most = std::max(most, -surface.nearest(place).distance);
    });
    return deepest.empty() ? -spacing : *std::max_element(deepest.begin(), deepest.end());
}

} // namespace knead
