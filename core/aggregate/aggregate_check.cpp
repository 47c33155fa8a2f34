#include "core/aggregate/aggregate_check.h"

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

constexpr std::int32_t furthestNode = 1 << 28; // neighbors of nodes and their differences stay numbers
constexpr double farthestPoint = 1e8;          // [spacings]
constexpr double largestArea = 1e12;           // [m^2]

/// Segments go on over objects that have no neighbor in their direction.
bool hasNeighbor(const Lattice& lattice, std::size_t direction, const Lattice::Segment& segment, ObjectIndex object)
{
    const Lattice::Node& there = lattice.nodes[object + static_cast<ObjectIndex>(segment.offset)];
    return there == Lattice::sum(lattice.nodes[object], Lattice::directions[direction]);
}

} // namespace

bool isSound(const Lattice& lattice)
{
    const auto isNear = [](const Lattice::Node& node) {
        return std::ranges::all_of(node, [](std::int32_t n) { return n >= -furthestNode && n <= furthestNode; });
    };
    const auto isNotAfter = [](const Lattice::Node& a, const Lattice::Node& b) { return !(a < b); };
    return lattice.origin.allFinite() && lattice.spacing > 0 && std::isfinite(lattice.spacing) &&
           (lattice.axes.transpose() * lattice.axes - Mat3::Identity()).cwiseAbs().maxCoeff() < 1e-9 &&
           std::ranges::all_of(lattice.nodes, isNear) &&
           std::ranges::adjacent_find(lattice.nodes, isNotAfter) == lattice.nodes.end();
}

bool areSoundWeights(const std::vector<double>& weights, const Lattice& lattice, std::size_t direction)
{
    std::vector<std::uint8_t> mayBe(lattice.size(), 0);
    for (const Lattice::Segment& segment : lattice.segments[direction])
        for (ObjectIndex object = segment.begin; object < segment.end; ++object)
            mayBe[object] = hasNeighbor(lattice, direction, segment, object) ? 1 : 0;
    for (std::size_t i = 0; i < weights.size(); ++i)
        if (!(weights[i] >= 0) || !std::isfinite(weights[i]) || (mayBe[i] == 0 && weights[i] != 0))
            return false;
    return true;
}

bool areSoundBroken(std::span<const BrokenConnection> broken, const Aggregate& aggregate)
{
    const auto isNotBefore = [](const BrokenConnection& a, const BrokenConnection& b) { return !(a < b); };
    return std::ranges::adjacent_find(broken, isNotBefore) == broken.end() &&
           std::ranges::all_of(broken, [&](const BrokenConnection& one) {
               return one.direction < Lattice::isotropicCount && one.lower < aggregate.size() &&
                      aggregate.weight[one.direction].size() == aggregate.size() &&
                      aggregate.weight[one.direction][one.lower] > 0 && one.cutAt >= 0 && one.cutAt < 1;
           });
}

bool areSoundPoints(const std::vector<SkinPoint>& skin, const Lattice& lattice)
{
    return std::ranges::all_of(skin, [&](const SkinPoint& point) {
        return point.place.allFinite() && point.area >= 0 && point.area <= largestArea &&
               lattice.coordinates(point.place).cwiseAbs().maxCoeff() <= farthestPoint;
    });
}

} // namespace knead
