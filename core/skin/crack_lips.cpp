#include "core/skin/crack_lips.h"

#include <algorithm>
#include <utility>

namespace knead {

namespace {

constexpr std::uint8_t uncolored = 2;
constexpr std::size_t leastBroken = 12;  // connections of a crack with lips: less than across one cell are none
constexpr double mostConflicts = 0.05;   // of a crack's connections that join ends of one color
constexpr std::size_t voters = 8;        // connections that say whether a border is open
constexpr double besideReach = 2.5;      // [spacings]
constexpr std::size_t besideVoters = 32; // all that are as near, about

/// The objects at the other ends of connections.
struct Links {
    std::vector<std::uint32_t> begin; ///< per object, and the end
    std::vector<ObjectIndex> others;

    Links(std::size_t objects, std::span<const std::pair<ObjectIndex, ObjectIndex>> ends)
        : begin(objects + 1, 0)
        , others(2 * ends.size())
    {
        for (const auto& [a, b] : ends) {
            ++begin[a + 1];
            ++begin[b + 1];
        }
        for (std::size_t i = 0; i < objects; ++i)
            begin[i + 1] += begin[i];
        std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
        for (const auto& [a, b] : ends) {
            others[next[a]++] = b;
            others[next[b]++] = a;
        }
    }
    std::span<const ObjectIndex> of(ObjectIndex object) const
    {
        return {others.data() + begin[object], begin[object + 1] - begin[object]};
    }
};

using Ends = std::vector<std::pair<ObjectIndex, ObjectIndex>>;

/// Colors the ends of each crack, those that are connected by broken connections.
void colorCracks(const Ends& broken, std::vector<std::uint8_t>& lip)
{
    const Links across(lip.size(), broken);
    std::vector<ObjectIndex> crack;
    std::vector<std::uint8_t> isSeen(lip.size(), 0);
    for (ObjectIndex first = 0; first < lip.size(); ++first) {
        if (isSeen[first] != 0 || across.of(first).empty())
            continue;
        crack.assign(1, first);
        isSeen[first] = 1;
        lip[first] = 0;
        std::size_t ends = 0; // two per connection
        std::size_t conflicts = 0;
        for (std::size_t i = 0; i < crack.size(); ++i)
            for (const ObjectIndex other : across.of(crack[i])) {
                ++ends;
                if (isSeen[other] == 0) {
                    isSeen[other] = 1;
                    lip[other] = static_cast<std::uint8_t>(1 - lip[crack[i]]);
                    crack.push_back(other);
                } else if (lip[other] == lip[crack[i]]) {
                    ++conflicts;
                }
            }
        if (ends < 2 * leastBroken || static_cast<double>(conflicts) > mostConflicts * static_cast<double>(ends))
            for (const ObjectIndex object : crack)
                lip[object] = uncolored;
    }
}

/// Ends of cracks color what is connected to them, the nearest first.
void spread(const Links& connections, std::vector<std::uint8_t>& lip)
{
    std::vector<ObjectIndex> front;
    for (ObjectIndex object = 0; object < lip.size(); ++object)
        if (lip[object] != uncolored)
            front.push_back(object);
    std::vector<ObjectIndex> next;
    while (!front.empty()) {
        next.clear();
        for (const ObjectIndex object : front)
            for (const ObjectIndex other : connections.of(object))
                if (lip[other] == uncolored) {
                    lip[other] = lip[object];
                    next.push_back(other);
                }
        std::swap(front, next);
    }
}

} // namespace

CrackLips::CrackLips(const Aggregate& aggregate, const Pieces& pieces, std::span<const BrokenConnection> broken)
    : m_lip(aggregate.size(), uncolored)
    , m_spacing(aggregate.lattice.spacing)
{
    Ends within;
    for (const BrokenConnection& connection : broken) {
        const ObjectIndex upper = upperEnd(aggregate.lattice, connection);
        if (pieces.ofObject[connection.lower] == pieces.ofObject[upper])
            within.emplace_back(connection.lower, upper);
    }
    if (within.size() >= leastBroken)
        colorCracks(within, m_lip);
    const auto isUncolored = [](std::uint8_t lip) { return lip == uncolored; };
    if (std::ranges::all_of(m_lip, isUncolored)) {
        std::ranges::fill(m_lip, std::uint8_t{0});
        return;
    }
    const std::vector<std::uint16_t> isBroken = brokenDirections(aggregate, broken);
    Ends holding;
    std::vector<std::pair<Ends::value_type, std::uint32_t>> all; // with their directions
    aggregate.forEachConnection([&](std::uint32_t d, ObjectIndex lower, ObjectIndex upper) {
        if (pieces.ofObject[lower] != pieces.ofObject[upper])
            return;
        all.push_back({{lower, upper}, d});
        if ((isBroken[lower] >> d & 1U) == 0)
            holding.emplace_back(lower, upper);
    });
    spread(Links(m_lip.size(), holding), m_lip);
    std::ranges::replace(m_lip, uncolored, std::uint8_t{0}); // pieces without lips
    std::vector<Vec3> points;
    for (const auto& [ends, direction] : all)
        if (m_lip[ends.first] != m_lip[ends.second]) {
            points.push_back((aggregate.lattice.position(ends.first) + aggregate.lattice.position(ends.second)) / 2);
            m_isOpen.push_back(isBroken[ends.first] >> direction & 1U);
        }
    m_points = VectorArray(points);
    m_grid.emplace(m_points, m_spacing);
}

bool CrackLips::isOpen(const Vec3& place) const
{
    std::vector<PointGrid::Found> found;
    m_grid->nearest(place, voters, found);
    double sum = 0;
    for (const PointGrid::Found& point : found)
        sum += (m_isOpen[point.point] != 0 ? 1 : -1) / (point.squared / (m_spacing * m_spacing) + 0.05);
    return sum > 0;
}

bool CrackLips::isBeside(const Vec3& place) const
{
    std::vector<PointGrid::Found> found;
    m_grid->nearest(place, besideVoters, found, besideReach * m_spacing);
    return std::ranges::any_of(found, [&](const PointGrid::Found& point) { return m_isOpen[point.point] != 0; });
}

} // namespace knead
