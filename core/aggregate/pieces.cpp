#include "core/aggregate/pieces.h"

#include "core/geometry/disjoint_sets.h"

#include <algorithm>

namespace knead {

namespace {

/// Per object: bit d for a broken connection in direction d.
std::vector<std::uint16_t> brokenDirections(std::size_t objects, std::span<const ConnectionId> broken)
{
    std::vector<std::uint16_t> bits(objects, 0);
    for (const ConnectionId& connection : broken)
        bits[connection.lower] = static_cast<std::uint16_t>(bits[connection.lower] | 1U << connection.direction);
    return bits;
}

} // namespace

Pieces findPieces(const Aggregate& aggregate, std::span<const ConnectionId> broken)
{
    const std::vector<std::uint16_t> isBroken = brokenDirections(aggregate.size(), broken);
    DisjointSets sets(aggregate.size());
    for (std::size_t d = 0; d < Lattice::directionCount; ++d)
        for (const Lattice::Segment& segment : aggregate.lattice.segments[d])
            for (ObjectIndex object = segment.begin; object < segment.end; ++object)
                if (aggregate.weight[d][object] > 0 && (isBroken[object] >> d & 1U) == 0)
                    sets.join(object, object + static_cast<ObjectIndex>(segment.offset));

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

Aggregate extract(const Aggregate& aggregate, std::span<const ObjectIndex> objects,
                  std::span<const ConnectionId> broken)
{
    constexpr ObjectIndex absent = 0xffffffffU;
    std::vector<ObjectIndex> placeInPart(aggregate.size(), absent);
    for (std::size_t i = 0; i < objects.size(); ++i)
        placeInPart[objects[i]] = static_cast<ObjectIndex>(i);

    const auto pick = [&](const auto& values) {
        std::decay_t<decltype(values)> picked;
        if (!values.empty())
            for (const ObjectIndex object : objects)
                picked.push_back(values[object]);
        return picked;
    };
    Aggregate part;
    part.lattice.origin = aggregate.lattice.origin;
    part.lattice.spacing = aggregate.lattice.spacing;
    part.lattice.axes = aggregate.lattice.axes;
    part.lattice.nodes = pick(aggregate.lattice.nodes);
    part.volume = pick(aggregate.volume);
    part.depth = pick(aggregate.depth);
    part.face = pick(aggregate.face);
    for (const double volume : part.volume)
        part.filledVolume += volume;
    part.meshVolume = part.filledVolume;

    std::size_t directions = 0;
    const std::vector<std::uint16_t> isBroken = brokenDirections(aggregate.size(), broken);
    for (std::size_t d = 0; d < Lattice::directionCount; ++d) {
        if (aggregate.weight[d].empty())
            continue;
        directions = d + 1;
        part.weight[d].assign(objects.size(), 0);
        for (const Lattice::Segment& segment : aggregate.lattice.segments[d]) {
            const auto begin = std::lower_bound(objects.begin(), objects.end(), segment.begin);
            for (auto object = begin; object != objects.end() && *object < segment.end; ++object) {
                const ObjectIndex neighbor = *object + static_cast<ObjectIndex>(segment.offset);
                if (placeInPart[neighbor] != absent && (isBroken[*object] >> d & 1U) == 0)
                    part.weight[d][placeInPart[*object]] = aggregate.weight[d][*object];
            }
        }
    }
    findSegments(part.lattice, directions);
    return part;
}

} // namespace knead
