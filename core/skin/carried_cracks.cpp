#include "core/skin/carried_cracks.h"

#include "core/aggregate/pieces.h"
#include "core/geometry/disjoint_sets.h"
#include "core/vicinity/point_grid.h"

#include <algorithm>
#include <map>
#include <optional>
#include <unordered_map>

namespace knead {

namespace {

// The way between two objects is looked at in so many places, both ends included.
constexpr int placesOnWay = 7;
// Pieces of fewer objects are crumbs.
constexpr std::size_t leastObjects = 8;
// Where it leads across something that was cut, it is cut not nearer to its ends than this.
constexpr double nearestToEnd = 0.05;

/// What is connected with what around the cracks of a filling.
class CrackedNeighbors {
public:
    explicit CrackedNeighbors(const CrackedFilling& filling)
        : m_links(filling.aggregate.size())
        , m_isOnlyCut(std::ranges::all_of(filling.broken, &BrokenConnection::isCut))
    {
        std::unordered_map<std::uint64_t, double> cutAt;
        const auto keyOf = [](std::size_t d, ObjectIndex lower) {
            return std::uint64_t{lower} * Lattice::directionCount + d;
        };
        for (const BrokenConnection& connection : filling.broken)
            cutAt.emplace(keyOf(connection.direction, connection.lower), connection.cutAt);
        filling.aggregate.forEachConnection([&](std::uint32_t d, ObjectIndex lower, ObjectIndex upper) {
            const auto found = cutAt.find(keyOf(d, lower));
            const bool isBroken = found != cutAt.end();
            const double at = isBroken ? found->second : 0;
            m_links[lower].push_back({upper, isBroken, at});
            m_links[upper].push_back({lower, isBroken, at > 0 ? 1 - at : 0});
        });
        for (const auto& [first, second] : filling.healed) {
            m_links[first].push_back({second, false, 0});
            m_links[second].push_back({first, false, 0});
        }
        markNear(filling.broken);
        findPieces();
    }

    /// Whether a crack can be so near that new objects beside it have to be asked about.
    bool isNear(ObjectIndex object) const { return m_isNear[object] != 0; }
    bool arePieces(ObjectIndex a, ObjectIndex b) const { return m_pieceOf[a] != m_pieceOf[b]; }

    /// Where the way between two objects is cut, by its length; 0 where it is torn. None where they hang together.
    std::optional<double> brokenBetween(ObjectIndex from, ObjectIndex to) const
    {
        std::optional<double> broken;
        for (const Link& link : m_links[from])
            if (link.to == to) {
                if (!link.isBroken)
                    return {};
                broken = link.cutAt;
            }
        if (broken)
            return broken;
        for (const Link& first : m_links[from])
            for (const Link& second : m_links[first.to])
                if (second.to == to) {
                    if (!first.isBroken && !second.isBroken)
                        return {};
                    if (!broken)
                        broken = first.isBroken ? 0.5 * first.cutAt : 0.5 * (1 + second.cutAt);
                    if ((first.isBroken ? first : second).cutAt == 0)
                        broken = 0;
                }
        if (!broken && arePieces(from, to))
            broken = m_isOnlyCut ? 0.5 : 0;
        return broken;
    }

private:
    struct Link {
        ObjectIndex to;
        bool isBroken;
        double cutAt;
    };

    void findPieces()
    {
        DisjointSets sets(m_links.size());
        for (ObjectIndex from = 0; from < m_links.size(); ++from)
            for (const Link& link : m_links[from])
                if (!link.isBroken)
                    sets.join(from, link.to);
        m_pieceOf.resize(m_links.size());
        for (ObjectIndex object = 0; object < m_links.size(); ++object)
            m_pieceOf[object] = static_cast<ObjectIndex>(sets.find(object));
    }

    void markNear(std::span<const BrokenConnection> broken)
    {
        m_isNear.assign(m_links.size(), 0);
        std::vector<ObjectIndex> front;
        for (const BrokenConnection& connection : broken)
            front.push_back(connection.lower);
        for (int ring = 0; ring < 3; ++ring) {
            std::vector<ObjectIndex> next;
            for (const ObjectIndex object : front) {
                if (m_isNear[object] != 0)
                    continue;
                m_isNear[object] = 1;
                for (const Link& link : m_links[object])
                    next.push_back(link.to);
            }
            front = std::move(next);
        }
    }

    std::vector<std::vector<Link>> m_links;
    bool m_isOnlyCut;
    std::vector<std::uint8_t> m_isNear;
    std::vector<ObjectIndex> m_pieceOf; ///< any object of the piece, the same for all
};

/// Finds cracks on straight ways.
class Ways {
public:
    Ways(const CrackedNeighbors& neighbors, const VectorArray& places, double spacing)
        : m_neighbors(neighbors)
        , m_places(places)
        , m_grid(places, spacing)
    {
    }

    /// Where a way is cut, by its length; 0 where it is torn. None where no crack is.
    std::optional<double> brokenOn(const Vec3& from, const Vec3& to)
    {
        std::optional<ObjectIndex> last;
        for (int n = 0; n < placesOnWay; ++n) {
            const double share = static_cast<double>(n) / (placesOnWay - 1);
            m_grid.nearest(from + share * (to - from), 1, m_found);
            const ObjectIndex here = m_found.front().point;
            if (last && *last != here)
                if (const auto at = m_neighbors.brokenBetween(*last, here))
                    return *at > 0 ? shareAt(*last, here, *at, from, to) : 0;
            last = here;
        }
        return {};
    }

private:
    /// Of a way, where it crosses the plane across the way between two objects.
    double shareAt(ObjectIndex first, ObjectIndex second, double at, const Vec3& from, const Vec3& to) const
    {
        const Vec3 across = m_places.at(second) - m_places.at(first);
        const Vec3 point = m_places.at(first) + at * across;
        const double whole = (to - from).dot(across);
        const double share = whole > 0 ? (point - from).dot(across) / whole : 0.5;
        return std::clamp(share, nearestToEnd, 1 - nearestToEnd);
    }

    const CrackedNeighbors& m_neighbors;
    const VectorArray& m_places;
    PointGrid m_grid;
    std::vector<PointGrid::Found> m_found;
};

/// Crumbs of a few objects, as they are left over between pieces that meet, stay with the piece that most of their broken connections
/// lead to.
void keepCrumbs(const Aggregate& aggregate, std::vector<BrokenConnection>& broken)
{
    const Pieces pieces = findPieces(aggregate, broken);
    std::vector<std::size_t> size(pieces.count, 0);
    for (const std::uint32_t piece : pieces.ofObject)
        ++size[piece];
    std::map<std::uint32_t, std::map<std::uint32_t, int>>
        neighbors; // of crumbs: how many connections lead to which piece
    for (const BrokenConnection& connection : broken) {
        const std::uint32_t lower = pieces.ofObject[connection.lower];
        const std::uint32_t upper = pieces.ofObject[upperEnd(aggregate.lattice, connection)];
        for (const auto& [crumb, other] : {std::pair(lower, upper), std::pair(upper, lower)})
            if (size[crumb] < leastObjects && size[other] >= leastObjects)
                ++neighbors[crumb][other];
    }
    std::erase_if(broken, [&](const BrokenConnection& connection) {
        const std::uint32_t lower = pieces.ofObject[connection.lower];
        const std::uint32_t upper = pieces.ofObject[upperEnd(aggregate.lattice, connection)];
        for (const auto& [crumb, other] : {std::pair(lower, upper), std::pair(upper, lower)})
            if (const auto found = neighbors.find(crumb); found != neighbors.end() && crumb != other) {
                const auto most =
                    std::ranges::max_element(found->second, {}, [](const auto& each) { return each.second; });
                if (most->first == other)
                    return true;
            }
        return false;
    });
}

} // namespace

VectorArray nodesOf(const Aggregate& aggregate)
{
    return VectorArray(aggregate.lattice.positions());
}

std::vector<BrokenConnection> carriedCracks(const CrackedFilling& cracked, const Aggregate& other,
                                            const VectorArray& places)
{
    if (cracked.broken.empty())
        return {};
    const CrackedNeighbors neighbors(cracked);
    const double spacing = cracked.aggregate.lattice.spacing;
    Ways ways(neighbors, cracked.places, spacing);
    const std::vector<ObjectIndex> nearest = nearestPoints(cracked.places, places, spacing);
    std::vector<BrokenConnection> carried;
    other.forEachConnection([&](std::uint32_t d, ObjectIndex lower, ObjectIndex upper) {
        const ObjectIndex from = nearest[lower];
        const ObjectIndex to = nearest[upper];
        if (!neighbors.isNear(from) && !neighbors.isNear(to) && !neighbors.arePieces(from, to))
            return;
        if (const auto at = ways.brokenOn(places.at(lower), places.at(upper)))
            carried.push_back({{d, lower}, *at});
    });
    keepCrumbs(other, carried);
    return carried;
}

} // namespace knead
