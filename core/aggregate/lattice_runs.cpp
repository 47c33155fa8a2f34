#include "core/aggregate/lattice_runs.h"

#include <algorithm>
#include <optional>

namespace knead {

namespace {

// Lanes that compute for nothing cost less than beginning another run, up to about this many.
constexpr ObjectIndex longestGap = 48;

/// The segments of one direction as seen from the objects at their begin (`side` 0) or at their end (`side` 1).
class SegmentCursor {
public:
    SegmentCursor(const std::vector<Lattice::Segment>& segments, int side)
        : m_segments(&segments)
        , m_side(side)
    {
    }

    /// The offset at `object`, 0 for none; `change` is lowered to where that is no longer so. Objects must not descend.
    std::int32_t offsetAt(ObjectIndex object, ObjectIndex& change)
    {
        while (m_next < m_segments->size() && shifted((*m_segments)[m_next].end) <= object)
            ++m_next;
        if (m_next == m_segments->size())
            return 0;
        const Lattice::Segment& segment = (*m_segments)[m_next];
        const bool inside = shifted(segment.begin) <= object;
        change = std::min(change, shifted(inside ? segment.end : segment.begin));
        return inside ? segment.offset : 0;
    }

private:
    ObjectIndex shifted(ObjectIndex object) const
    {
        return m_side == 0 ? object : object + static_cast<ObjectIndex>((*m_segments)[m_next].offset);
    }

    const std::vector<Lattice::Segment>* m_segments;
    int m_side;
    std::size_t m_next = 0;
};

/// Merges offsets of one direction that differ in being there only. @return false when they are of two neighbors
bool merge(std::int32_t& offset, std::int32_t other)
{
    if (other == 0 || other == offset)
        return true;
    if (offset != 0)
        return false;
    offset = other;
    return true;
}

std::uint32_t maskOf(const LatticeRun::Offsets& offsets)
{
    std::uint32_t mask = 0;
    for (std::size_t d = 0; d < offsets.size(); ++d)
        mask |= offsets[d] != 0 ? 1U << d : 0U;
    return mask;
}

/// `run` lengthened by a stretch right behind it, if one set of offsets serves both and leads to objects everywhere.
std::optional<LatticeRun> joined(const LatticeRun& run, const LatticeRun& stretch, ObjectIndex objects)
{
    LatticeRun all = run;
    all.end = stretch.end;
    // Lanes that one of the two would have to compute for nothing.
    const auto idle = [&](std::int32_t first, std::int32_t second) {
        return (first == 0) == (second == 0) ? 0 : first == 0 ? run.end - run.begin : stretch.end - stretch.begin;
    };
    for (std::size_t d = 0; d < Lattice::directionCount; ++d) {
        if (std::max(idle(run.ahead[d], stretch.ahead[d]), idle(run.behind[d], stretch.behind[d])) > longestGap)
            return {};
        if (!merge(all.ahead[d], stretch.ahead[d]) || !merge(all.behind[d], stretch.behind[d]))
            return {};
        if (all.end - 1 + static_cast<ObjectIndex>(all.ahead[d]) >= objects ||
            all.begin < static_cast<ObjectIndex>(all.behind[d]))
            return {};
    }
    return all;
}

} // namespace

std::vector<LatticeRun> findRuns(const Lattice& lattice, RunNeighbors neighbors)
{
    std::vector<SegmentCursor> ahead;
    std::vector<SegmentCursor> behind;
    for (const auto& segments : lattice.segments) {
        ahead.emplace_back(segments, 0);
        behind.emplace_back(segments, 1);
    }
    std::vector<LatticeRun> runs;
    const auto objects = static_cast<ObjectIndex>(lattice.size());
    for (ObjectIndex object = 0; object < objects;) {
        LatticeRun stretch{.begin = object, .end = objects};
        for (std::size_t d = 0; d < Lattice::directionCount; ++d) {
            stretch.ahead[d] = ahead[d].offsetAt(object, stretch.end);
            if (neighbors == RunNeighbors::all)
                stretch.behind[d] = behind[d].offsetAt(object, stretch.end);
        }
        object = stretch.end;
        if (!runs.empty())
            if (const auto longer = joined(runs.back(), stretch, objects)) {
                runs.back() = *longer;
                continue;
            }
        runs.push_back(stretch);
    }
    for (LatticeRun& run : runs) {
        run.forward = maskOf(run.ahead);
        run.backward = maskOf(run.behind);
    }
    return runs;
}

std::vector<std::uint32_t> neighborsBehind(const Lattice& lattice)
{
    std::vector<std::uint32_t> masks(lattice.size(), 0);
    for (std::size_t d = 0; d < Lattice::directionCount; ++d)
        for (const Lattice::Segment& segment : lattice.segments[d])
            for (ObjectIndex lower = segment.begin; lower < segment.end; ++lower)
                masks[lower + static_cast<ObjectIndex>(segment.offset)] |= 1U << d;
    return masks;
}

} // namespace knead
