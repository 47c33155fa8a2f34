#include "io/morph/wire_periods.h"

#include "core/geometry/disjoint_sets.h"

#include <TopExp.hxx>
#include <TopoDS_Vertex.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <vector>

namespace knead {

namespace {

/// Where an edge begins or ends.
struct WireEnd {
    TopoDS_Vertex vertex;
    Vec2 at;
};

std::array<WireEnd, 2> endsOf(const FaceEdge& edge)
{
    const gp_Pnt2d first = edge.curves[0]->Value(edge.first).Translated(edge.shift);
    const gp_Pnt2d last = edge.curves[0]->Value(edge.last).Translated(edge.shift);
    return {WireEnd{TopExp::FirstVertex(edge.edge), Vec2(first.X(), first.Y())},
            WireEnd{TopExp::LastVertex(edge.edge), Vec2(last.X(), last.Y())}};
}

/// Two edges of a wire that share a vertex.
struct Contact {
    std::size_t first;
    std::size_t second;
    Vec2 gap; ///< from the second to the first one there, as whole periods
};

/// Where they share two vertices: the one where they are nearer to each other.
std::optional<Vec2> gapBetween(const std::array<WireEnd, 2>& a, const std::array<WireEnd, 2>& b, const Vec2& period)
{
    std::optional<Vec2> least;
    for (const WireEnd& one : a)
        for (const WireEnd& other : b) {
            if (one.vertex.IsNull() || !one.vertex.IsSame(other.vertex))
                continue;
            Vec2 gap = Vec2::Zero();
            for (Eigen::Index axis = 0; axis < 2; ++axis)
                if (period[axis] > 0)
                    gap[axis] = period[axis] * std::round((one.at[axis] - other.at[axis]) / period[axis]);
            if (!least || gap.norm() < least->norm())
                least = gap;
        }
    return least;
}

/// Those that run on come first: they say which edges lie together, before these are shifted as a whole.
std::vector<Contact> contactsOf(std::span<const FaceEdge> wire, const Vec2& period)
{
    std::vector<std::array<WireEnd, 2>> ends;
    std::ranges::transform(wire, std::back_inserter(ends), endsOf);
    std::vector<Contact> contacts;
    for (std::size_t a = 0; a < ends.size(); ++a)
        for (std::size_t b = a + 1; b < ends.size(); ++b)
            if (const std::optional<Vec2> gap = gapBetween(ends[a], ends[b], period))
                contacts.push_back({a, b, *gap});
    std::ranges::stable_partition(contacts, [](const Contact& contact) { return contact.gap.isZero(); });
    return contacts;
}

} // namespace

void bringIntoOnePeriod(std::span<FaceEdge> wire, const Vec2& period)
{
    if (wire.size() < 2 || period.isZero() ||
        std::ranges::any_of(wire, [](const FaceEdge& edge) { return !edge.curves[1].IsNull(); }))
        return;
    std::vector<Vec2> shifts(wire.size(), Vec2::Zero());
    DisjointSets together(wire.size());
    const auto countOf = [&](std::size_t edge) {
        std::size_t count = 0;
        for (std::size_t other = 0; other < wire.size(); ++other)
            count += together.find(other) == together.find(edge) ? 1 : 0;
        return count;
    };
    for (const Contact& contact : contactsOf(wire, period)) {
        const auto [a, b, gap] = contact;
        if (together.find(a) == together.find(b))
            continue;
        const Vec2 apart = gap + shifts[a] - shifts[b];
        const bool movesFirst = countOf(a) < countOf(b);
        const std::size_t moved = together.find(movesFirst ? a : b);
        if (!apart.isZero())
            for (std::size_t edge = 0; edge < wire.size(); ++edge)
                if (together.find(edge) == moved)
                    shifts[edge] += movesFirst ? Vec2(-apart) : apart;
        together.join(a, b);
    }
    for (std::size_t edge = 0; edge < wire.size(); ++edge)
        wire[edge].shift += gp_Vec2d(shifts[edge].x(), shifts[edge].y());
}

} // namespace knead
