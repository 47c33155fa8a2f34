#include "core/aggregate/pieces.h"

#include "core/geometry/disjoint_sets.h"

#include <algorithm>
#include <numeric>

namespace knead {

ObjectIndex upperEnd(const Lattice& lattice, const ConnectionId& connection)
{
    const auto& segments = lattice.segments[connection.direction];
    const auto segment =
        std::ranges::partition_point(segments, [&](const auto& each) { return each.end <= connection.lower; });
    return connection.lower + static_cast<ObjectIndex>(segment->offset);
}

std::vector<std::uint16_t> brokenDirections(const Aggregate& aggregate, std::span<const BrokenConnection> broken)
{
    std::vector<std::uint16_t> bits(aggregate.size(), 0);
    for (const ConnectionId& connection : broken)
        bits[connection.lower] = static_cast<std::uint16_t>(bits[connection.lower] | 1U << connection.direction);
    return bits;
}

Pieces findPieces(const Aggregate& aggregate, std::span<const BrokenConnection> broken)
{
    const std::vector<std::uint16_t> isBroken = brokenDirections(aggregate, broken);
    DisjointSets sets(aggregate.size());
    aggregate.forEachConnection([&](std::uint32_t d, ObjectIndex lower, ObjectIndex upper) {
        if ((isBroken[lower] >> d & 1U) == 0)
            sets.join(lower, upper);
    });

    constexpr std::uint32_t none = 0xffffffffU;
    std::vector<std::uint32_t> pieceOfRoot(aggregate.size(), none);
    Pieces pieces;
    pieces.ofObject.resize(aggregate.size());
    for (std::size_t object = 0; object < aggregate.size(); ++object) {
        std::uint32_t& piece = pieceOfRoot[sets.find(object)];
        if (piece == none)
            piece = static_cast<std::uint32_t>(pieces.count++);
        pieces.ofObject[object] = piece;
    }
    return pieces;
}

/// The node that a place is nearest to.
Lattice::Node nearestNode(const Lattice& lattice, const Vec3& place)
{
    const Vec3 local = lattice.coordinates(place);
    return {static_cast<std::int32_t>(std::lround(local.x())), static_cast<std::int32_t>(std::lround(local.y())),
            static_cast<std::int32_t>(std::lround(local.z()))};
}

Aggregate extract(const Aggregate& aggregate, std::span<const ObjectIndex> objects,
                  std::span<const std::uint16_t> isBroken)
{
    const auto pick = [&](const auto& values) {
        return values.empty() ? std::decay_t<decltype(values)>() : pickedOf(values, objects);
    };
    Aggregate part;
    part.lattice.origin = aggregate.lattice.origin;
    part.lattice.spacing = aggregate.lattice.spacing;
    part.lattice.axes = aggregate.lattice.axes;
    part.lattice.nodes = pick(aggregate.lattice.nodes);
    part.volume = pick(aggregate.volume);
    part.depth = pick(aggregate.depth);
    part.face = pick(aggregate.face);
    part.filledVolume = std::accumulate(part.volume.begin(), part.volume.end(), 0.0);
    part.meshVolume = part.filledVolume;

    std::size_t directions = 0;
    for (std::size_t d = 0; d < Lattice::directionCount; ++d) {
        if (aggregate.weight[d].empty())
            continue;
        directions = d + 1;
        part.weight[d].assign(objects.size(), 0);
        const auto& segments = aggregate.lattice.segments[d];
        auto segment = segments.begin();
        for (std::size_t i = 0; i < objects.size(); ++i) {
            segment = std::partition_point(segment, segments.end(), [&](const auto& s) { return s.end <= objects[i]; });
            if (segment == segments.end())
                break;
            const ObjectIndex neighbor = objects[i] + static_cast<ObjectIndex>(segment->offset);
            if (segment->begin <= objects[i] && (isBroken[objects[i]] >> d & 1U) == 0 &&
                std::ranges::binary_search(objects, neighbor))
                part.weight[d][i] = aggregate.weight[d][objects[i]];
        }
    }
    findSegments(part.lattice, directions);
    for (const SkinPoint& point : aggregate.skin)
        if (part.lattice.find(nearestNode(part.lattice, point.place)) < part.size())
            part.skin.push_back(point);
    return part;
}

std::shared_ptr<const Aggregate> withoutBroken(const std::shared_ptr<const Aggregate>& aggregate,
                                               std::span<const BrokenConnection> broken)
{
    if (broken.empty())
        return aggregate;
    std::vector<ObjectIndex> all(aggregate->size());
    std::iota(all.begin(), all.end(), ObjectIndex{0});
    return std::make_shared<const Aggregate>(extract(*aggregate, all, brokenDirections(*aggregate, broken)));
}

} // namespace knead
