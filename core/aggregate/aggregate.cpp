#include "core/aggregate/aggregate.h"

#include <algorithm>

namespace knead {

std::size_t Aggregate::connectionCount() const
{
    std::size_t count = 0;
    for (const std::vector<double>& weights : weight)
        count += static_cast<std::size_t>(std::ranges::count_if(weights, [](double w) { return w > 0; }));
    return count;
}

std::vector<double> Aggregate::borneVolume() const
{
    if (!weight[Lattice::isotropicCount].empty())
        return volume; // as published, with up to 26 neighbors of one weight, of which a volume is not a sum
    const double share = lattice.spacing * lattice.spacing * lattice.spacing / 18;
    std::vector<double> borne(size(), 0);
    forEachConnection([&](std::uint32_t d, ObjectIndex lower, ObjectIndex upper) {
        borne[lower] += share * weight[d][lower];
        borne[upper] += share * weight[d][lower];
    });
    return borne;
}

} // namespace knead
