#include "core/aggregate/lattice.h"

#include "core/task/parallel.h"

#include <algorithm>

namespace knead {

namespace {

// Written out: the comparison of arrays calls memcmp for equality.
bool isBefore(const Lattice::Node& a, const Lattice::Node& b)
{
    return a[0] != b[0] ? a[0] < b[0] : a[1] != b[1] ? a[1] < b[1] : a[2] < b[2];
}
bool isSame(const Lattice::Node& a, const Lattice::Node& b)
{
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

/// Nodes shifted by one direction keep their order, so neighbors are found by merging the list with itself.
std::vector<Lattice::Segment> findSegments(const std::vector<Lattice::Node>& nodes, const Lattice::Node& direction)
{
    std::vector<Lattice::Segment> segments;
    const auto count = static_cast<ObjectIndex>(nodes.size());
    ObjectIndex neighbor = 0;
    for (ObjectIndex object = 0; object < count; ++object) {
        const Lattice::Node wanted = Lattice::sum(nodes[object], direction);
        while (neighbor < count && isBefore(nodes[neighbor], wanted))
            ++neighbor;
        if (neighbor == count)
            break;
        if (!isSame(nodes[neighbor], wanted))
            continue;
        const auto offset = static_cast<std::int32_t>(neighbor - object);
        if (!segments.empty() && segments.back().offset == offset)
            segments.back().end = object + 1;
        else
            segments.push_back({object, object + 1, offset});
    }
    return segments;
}

} // namespace

std::vector<Vec3> Lattice::positions() const
{
    std::vector<Vec3> places(size());
    std::ranges::transform(nodes, places.begin(), [this](const Node& node) { return position(node); });
    return places;
}

ObjectIndex Lattice::find(const Node& node) const
{
    const auto found = std::lower_bound(nodes.begin(), nodes.end(), node);
    const bool there = found != nodes.end() && *found == node;
    return static_cast<ObjectIndex>(there ? found - nodes.begin() : nodes.end() - nodes.begin());
}

void findSegments(Lattice& lattice, std::size_t directions)
{
    forEachBlock(directions, 1, [&](std::size_t d, std::size_t) {
        lattice.segments[d] = findSegments(lattice.nodes, Lattice::directions[d]);
    });
}

} // namespace knead
