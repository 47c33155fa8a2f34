#pragma once

#include "core/aggregate/lattice.h"

#include <algorithm>

namespace knead {

/// Calls run(object, neighbor, lower, count) for every stretch of connections of direction `d` that starts in [begin, end).
/// `lower` is where the stretch's parameters are: at the object.
template <typename Run>
void forEachForward(const Lattice& lattice, std::size_t d, std::size_t begin, std::size_t end, Run run)
{
    const auto& segments = lattice.segments[d];
    auto segment =
        std::partition_point(segments.begin(), segments.end(), [&](const auto& s) { return s.end <= begin; });
    for (; segment != segments.end() && segment->begin < end; ++segment) {
        const std::size_t first = std::max<std::size_t>(segment->begin, begin);
        const std::size_t last = std::min<std::size_t>(segment->end, end);
        run(first, first + static_cast<std::size_t>(segment->offset), first, last - first);
    }
}

/// The same for the connections that end in [begin, end); `lower` is at the neighbor.
template <typename Run>
void forEachBackward(const Lattice& lattice, std::size_t d, std::size_t begin, std::size_t end, Run run)
{
    const auto& segments = lattice.segments[d];
    const auto shift = [](const auto& s, ObjectIndex i) { return i + static_cast<std::size_t>(s.offset); };
    auto segment =
        std::partition_point(segments.begin(), segments.end(), [&](const auto& s) { return shift(s, s.end) <= begin; });
    for (; segment != segments.end() && shift(*segment, segment->begin) < end; ++segment) {
        const std::size_t first = std::max(shift(*segment, segment->begin), begin);
        const std::size_t last = std::min(shift(*segment, segment->end), end);
        const std::size_t lower = first - static_cast<std::size_t>(segment->offset);
        run(first, lower, lower, last - first);
    }
}

/// Calls run(lower, upper, count) for every stretch of connections of direction `d` with an end in [begin, end), in pieces of
/// at most `most` connections. Of a piece, both, one or neither end of a connection may lie in the block.
template <typename Run>
void forEachTouching(const Lattice& lattice, std::size_t d, std::size_t begin, std::size_t end, std::size_t most,
                     Run run)
{
    const auto& segments = lattice.segments[d];
    const auto upper = [](const auto& s, ObjectIndex i) { return i + static_cast<std::size_t>(s.offset); };
    auto segment =
        std::partition_point(segments.begin(), segments.end(), [&](const auto& s) { return upper(s, s.end) <= begin; });
    for (; segment != segments.end() && segment->begin < end; ++segment) {
        const auto offset = static_cast<std::size_t>(segment->offset);
        const std::size_t first = std::max<std::size_t>(segment->begin, begin > offset ? begin - offset : 0);
        const std::size_t last = std::min<std::size_t>(segment->end, end);
        for (std::size_t lower = first; lower < last; lower += most) {
            const std::size_t count = std::min(most, last - lower);
            const bool missesBoth = lower + count <= begin && lower + offset >= end; // an offset longer than the block
            if (!missesBoth)
                run(lower, lower + offset, count);
        }
    }
}

} // namespace knead
