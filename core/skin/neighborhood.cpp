#include "core/skin/neighborhood.h"

#include "core/skin/neighborhood_walks.h"
#include "core/task/parallel.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

namespace knead {

using namespace neighborhood_walks;

namespace {

constexpr std::int32_t side = 2 * reach + corners; // nodes per axis: three steps more on either side

constexpr std::int32_t placeInBlock(const Lattice::Node& node)
{
    return (node[0] * side + node[1]) * side + node[2];
}

/// The steps to the neighbors of a place in a block: forward in all directions, then backward.
constexpr std::array<std::int32_t, 2 * Lattice::isotropicCount> stepsInBlock = [] {
    std::array<std::int32_t, 2 * Lattice::isotropicCount> steps{};
    for (std::size_t d = 0; d < Lattice::isotropicCount; ++d) {
        steps[d] = placeInBlock(Lattice::directions[d]);
        steps[d + Lattice::isotropicCount] = -steps[d];
    }
    return steps;
}();

/// Numbers different sets of walks in the order in which they come.
class SetNumbers {
public:
    explicit SetNumbers(std::vector<std::uint64_t>& sets)
        : m_sets(sets)
    {
        m_numbers.fill(none);
    }

    /// @param set not empty
    std::uint16_t numberOf(std::uint64_t set)
    {
        constexpr std::uint64_t scatter = 0x9e3779b97f4a7c15U;
        std::size_t slot = (set * scatter) >> (64 - slotBits);
        while (m_numbers[slot] != none && m_sets[m_numbers[slot]] != set)
            slot = (slot + 1) % m_numbers.size();
        if (m_numbers[slot] == none) {
            m_numbers[slot] = static_cast<std::uint16_t>(m_sets.size());
            m_sets.push_back(set);
        }
        return m_numbers[slot];
    }

private:
    static constexpr std::uint16_t none = 0xffff;
    static constexpr int slotBits = 11; // twice as many as there are places in a block
    std::vector<std::uint64_t>& m_sets;
    std::array<std::uint16_t, std::size_t{1} << slotBits> m_numbers;
};

/// The objects of a cube of nodes, and which of several walks have come to them.
class Block {
public:
    /// @param low the lowest node of the cube
    explicit Block(const Lattice::Node& low)
        : m_low(low)
    {
        m_front.reserve(usualFront);
        m_next.reserve(usualFront);
    }

    /// Takes in the objects that walks can come to from a box of nodes. To be called once.
    /// @param links per object: a bit for each direction with a forward connection
    void takeAround(const Eigen::AlignedBox3i& starts, const Lattice& lattice, const LatticeRows& rows,
                    std::span<const std::uint16_t> links)
    {
        const std::int32_t lowest = starts.min().z() - reach;
        const std::int32_t highest = starts.max().z() + reach;
        for (std::int32_t u = starts.min().x() - reach; u <= starts.max().x() + reach; ++u)
            for (std::int32_t v = starts.min().y() - reach; v <= starts.max().y() + reach; ++v) {
                const LatticeRows::Row row = rows.row(u, v);
                for (ObjectIndex object = rows.lowerBound(row, lowest); object < row.end; ++object) {
                    const std::int32_t w = lattice.nodes[object][2];
                    if (w > highest)
                        break;
                    const auto place = static_cast<std::size_t>(placeInBlock(Lattice::difference({u, v, w}, m_low)));
                    m_objects[place] = object;
                    m_links[place] = links[object];
                }
            }
    }

    /// @param walks a bit for each walk that begins here
    void start(const Lattice::Node& node, std::uint64_t walks)
    {
        reachPlace(placeInBlock(Lattice::difference(node, m_low)), walks);
    }

    /// All walks take one step along all connections of the objects they reached last.
    void step()
    {
        takeStep([this](std::int32_t place, std::uint64_t walks) { reachPlace(place, walks); });
    }

    /// The same where none comes after it: who came when need not be known.
    void lastStep()
    {
        takeStep(
            [this](std::int32_t place, std::uint64_t walks) { m_reached[static_cast<std::size_t>(place)] |= walks; });
    }

    /// In the order of their nodes, which is ascending.
    void tell(Neighborhood& around) const
    {
        const auto count = m_reached.size() - static_cast<std::size_t>(std::ranges::count(m_reached, std::uint64_t{0}));
        around.objects.reserve(count);
        around.walksOf.reserve(count);
        SetNumbers numbers(around.walks);
        for (std::size_t place = 0; place < m_objects.size(); ++place)
            if (m_reached[place] != 0) {
                around.objects.push_back(m_objects[place]);
                around.walksOf.push_back(numbers.numberOf(m_reached[place]));
            }
    }

private:
    struct Arrival {
        std::int32_t place;
        std::uint64_t walks;
    };

    template <typename Reach>
    void takeStep(Reach reach)
    {
        std::swap(m_front, m_next);
        m_next.clear();
        for (Arrival& destination : m_front)
            destination.walks = std::exchange(m_last[static_cast<std::size_t>(destination.place)], std::uint64_t{0});
        for (const auto& [place, walks] : m_front)
            for (std::uint32_t links = linksOf(place); links != 0; links &= links - 1)
                reach(place + stepsInBlock[static_cast<std::size_t>(std::countr_zero(links))], walks);
    }

    /// A bit for each step that can be taken from a place.
    std::uint32_t linksOf(std::int32_t place) const
    {
        std::uint32_t links = m_links[static_cast<std::size_t>(place)];
        for (std::size_t d = 0; d < Lattice::isotropicCount; ++d) {
            const std::uint32_t before = m_links[static_cast<std::size_t>(place - stepsInBlock[d])];
            links |= (before >> d & 1U) << (d + Lattice::isotropicCount);
        }
        return links;
    }

    void reachPlace(std::int32_t place, std::uint64_t walks)
    {
        std::uint64_t& reached = m_reached[static_cast<std::size_t>(place)];
        std::uint64_t& last = m_last[static_cast<std::size_t>(place)];
        const std::uint64_t isNew = walks & ~reached;
        if (isNew == 0)
            return;
        if (last == 0)
            m_next.push_back({place, 0});
        last |= isNew;
        reached |= isNew;
    }

    static constexpr std::size_t usualFront = 256;
    Lattice::Node m_low;
    std::array<ObjectIndex, side * side * side> m_objects; // where any walk has come
    std::array<std::uint16_t, side * side * side> m_links{};
    std::array<std::uint64_t, side * side * side> m_reached{}; // by which walks
    std::array<std::uint64_t, side * side * side> m_last{};    // by which of them in the last step
    std::vector<Arrival> m_front;
    std::vector<Arrival> m_next; // where any came in the last step
};

/// Per corner of a cell: a bit for each direction in which its neighbor is in the cell, too.
constexpr std::array<std::uint16_t, Lattice::cellCorners.size()> linksInCell = [] {
    std::array<std::uint16_t, Lattice::cellCorners.size()> links{};
    for (std::size_t corner = 0; corner < Lattice::cellCorners.size(); ++corner)
        for (std::size_t d = 0; d < Lattice::isotropicCount; ++d)
            if (std::ranges::find(Lattice::cellCorners,
                                  Lattice::sum(Lattice::cellCorners[corner], Lattice::directions[d])) !=
                Lattice::cellCorners.end())
                links[corner] |= static_cast<std::uint16_t>(1U << d);
    return links;
}();

} // namespace

NeighborhoodFinder::NeighborhoodFinder(const Aggregate& aggregate)
    : m_lattice(aggregate.lattice)
    , m_rows(aggregate.lattice)
    , m_links(aggregate.size(), 0)
{
    for (std::size_t d = 0; d < Lattice::isotropicCount; ++d)
        for (ObjectIndex object = 0; object < m_links.size(); ++object)
            if (aggregate.weight[d][object] > 0)
                m_links[object] |= static_cast<std::uint16_t>(1U << d);
}

/// The edges and face diagonals of a kept cell are all connections. Only an empty cell enclosed by kept ones on all
/// sides looks the same, and there it makes no difference.
bool NeighborhoodFinder::isKept(const Lattice::Node& cell) const
{
    for (std::size_t corner = 0; corner < Lattice::cellCorners.size(); ++corner) {
        const ObjectIndex object = m_rows.find(Lattice::sum(cell, Lattice::cellCorners[corner]));
        if (object == m_lattice.size() || (m_links[object] & linksInCell[corner]) != linksInCell[corner])
            return false;
    }
    return true;
}

std::vector<Lattice::Node> NeighborhoodFinder::keptAround(const Lattice::Node& cell, std::size_t most) const
{
    std::vector<Lattice::Node> kept;
    for (std::int32_t u = -1; u <= 1; ++u)
        for (std::int32_t v = -1; v <= 1; ++v)
            for (std::int32_t w = -1; w <= 1 && kept.size() < most; ++w)
                if (const Lattice::Node other = Lattice::sum(cell, {u, v, w}); isKept(other))
                    kept.push_back(other);
    return kept;
}

SkinOwner NeighborhoodFinder::owner(const Vec3& coordinates) const
{
    const Lattice::Node home{static_cast<std::int32_t>(std::floor(coordinates.x())),
                             static_cast<std::int32_t>(std::floor(coordinates.y())),
                             static_cast<std::int32_t>(std::floor(coordinates.z()))};
    if (isKept(home))
        return {home, SkinOwner::Kind::cell};
    if (!keptAround(home, 1).empty())
        return {home, SkinOwner::Kind::around};
    return {m_lattice.nodes[m_rows.nearest(coordinates)], SkinOwner::Kind::object};
}

OwnedPoints NeighborhoodFinder::ownersOf(std::span<const Vec3> points) const
{
    OwnedPoints owned{.owners = std::vector<SkinOwner>(points.size()),
                      .order = std::vector<std::uint32_t>(points.size())};
    forEachBlock(points.size(), 512, [&](std::size_t begin, std::size_t end) {
        for (std::size_t point = begin; point < end; ++point)
            owned.owners[point] = owner(m_lattice.coordinates(points[point]));
    });
    std::iota(owned.order.begin(), owned.order.end(), 0U);
    std::ranges::stable_sort(owned.order, {}, [&](std::uint32_t point) { return owned.owners[point]; });
    return owned;
}

Neighborhood NeighborhoodFinder::gather(const SkinOwner& owner) const
{
    Neighborhood around;
    around.owner = owner;
    if (owner.kind == SkinOwner::Kind::cell)
        around.cells = {owner.node};
    else if (owner.kind == SkinOwner::Kind::around)
        around.cells = keptAround(owner.node, 27);

    std::vector<Lattice::Node> starts;
    if (around.cells.empty())
        starts.push_back(owner.node);
    for (const Lattice::Node& cell : around.cells)
        for (const Lattice::Node& corner : Lattice::cellCorners)
            starts.push_back(Lattice::sum(cell, corner));
    Eigen::AlignedBox3i box;
    for (const Lattice::Node& start : starts)
        box.extend(Eigen::Vector3i(start[0], start[1], start[2]));

    constexpr std::int32_t margin = reach + 1;
    Block block(Lattice::difference(owner.node, {margin, margin, margin}));
    block.takeAround(box, m_lattice, m_rows, m_links);
    for (const Lattice::Node& start : starts)
        block.start(start, std::uint64_t{1} << walkFrom(Lattice::difference(start, owner.node)));
    for (std::int32_t steps = 1; steps < reach; ++steps)
        block.step();
    block.lastStep();
    block.tell(around);
    std::vector<Lattice::Node> nodes(around.objects.size());
    std::ranges::transform(around.objects, nodes.begin(), [&](ObjectIndex object) { return m_lattice.nodes[object]; });
    around.outward = outwardOrder(nodes, around.middle());
    return around;
}

} // namespace knead
