#pragma once

#include "core/aggregate/connection_id.h"

#include <algorithm>

namespace knead {

/// Which ends of connections are looked at.
enum class ConnectionEnd { lower, upper };

/// Calls run(lower, upper, count) for every stretch of connections of direction `d` that have an end in [begin, end),
/// by ascending objects: lower + i is connected with upper + i, i < count. Parameters are at the lower one. Objects
/// without a neighbor may be among them, with a connection of weight 0.
template <ConnectionEnd which = ConnectionEnd::lower, typename Run>
void forEachStretch(const Lattice& lattice, std::size_t d, std::size_t begin, std::size_t end, Run&& run)
{
    const auto shift = [](const Lattice::Segment& s) {
        return which == ConnectionEnd::upper ? static_cast<std::size_t>(s.offset) : 0;
    };
    const auto& segments = lattice.segments[d];
    auto segment = std::partition_point(segments.begin(), segments.end(),
                                        [&](const auto& s) { return s.end + shift(s) <= begin; });
    for (; segment != segments.end() && segment->begin + shift(*segment) < end; ++segment) {
        const std::size_t first = std::max(segment->begin + shift(*segment), begin) - shift(*segment);
        const std::size_t last = std::min(segment->end + shift(*segment), end) - shift(*segment);
        run(first, first + static_cast<std::size_t>(segment->offset), last - first);
    }
}

/// Calls visit(lower, upper) for the connections of direction `d` one by one in the same order.
template <ConnectionEnd which = ConnectionEnd::lower, typename Visit>
void forEachPair(const Lattice& lattice, std::size_t d, std::size_t begin, std::size_t end, Visit&& visit)
{
    forEachStretch<which>(lattice, d, begin, end, [&](std::size_t lower, std::size_t upper, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i)
            visit(static_cast<ObjectIndex>(lower + i), static_cast<ObjectIndex>(upper + i));
    });
}

/// Calls visit(neighbor, connection) for what an object is connected with, by direction, ahead and then behind.
template <typename Visit>
void forEachNeighbor(const Lattice& lattice, ObjectIndex object, Visit&& visit)
{
    for (std::uint32_t d = 0; d < Lattice::directionCount; ++d) {
        forEachPair(lattice, d, object, object + 1, [&](ObjectIndex lower, ObjectIndex upper) {
            visit(upper, ConnectionId{d, lower});
        });
        forEachPair<ConnectionEnd::upper>(lattice, d, object, object + 1, [&](ObjectIndex lower, ObjectIndex) {
            visit(lower, ConnectionId{d, lower});
        });
    }
}

} // namespace knead
