#include "core/skin/neighborhood.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace knead {

namespace {

constexpr std::int32_t reach = 3;            // steps
constexpr std::int32_t side = 2 * reach + 2; // nodes per axis: a cell and three steps on either side
constexpr ObjectIndex nothing = 0xffffffffU;

std::int32_t placeInBlock(const Lattice::Node& node)
{
    return (node[0] * side + node[1]) * side + node[2];
}

/// The objects of a cube of nodes, and how many steps they are from where a walk began.
class Block {
public:
    /// @param low the lowest node of the cube
    Block(const Aggregate& aggregate, const LatticeRows& rows, const Lattice::Node& low)
        : m_aggregate(aggregate)
    {
        m_objects.fill(nothing);
        for (std::int32_t u = 0; u < side; ++u)
            for (std::int32_t v = 0; v < side; ++v) {
                const LatticeRows::Row row = rows.row(low[0] + u, low[1] + v);
                for (ObjectIndex object = rows.lowerBound(row, low[2]); object < row.end; ++object) {
                    const std::int32_t w = aggregate.lattice.nodes[object][2] - low[2];
                    if (w >= side)
                        break;
                    m_objects[static_cast<std::size_t>(placeInBlock({u, v, w}))] = object;
                }
            }
    }

    void start(const Lattice::Node& node) { reachPlace(placeInBlock(node)); }

    /// One step along all connections of the objects reached last.
    void step()
    {
        const std::vector<std::int32_t> front = std::move(m_front);
        m_front.clear();
        for (const std::int32_t place : front)
            for (std::size_t d = 0; d < Lattice::isotropicCount; ++d) {
                const std::int32_t offset = placeInBlock(Lattice::directions[d]);
                if (isConnected(place, d))
                    reachPlace(place + offset);
                if (isConnected(place - offset, d))
                    reachPlace(place - offset);
            }
    }

    /// In the order of their nodes, which is ascending.
    std::vector<ObjectIndex> reached() const
    {
        std::vector<ObjectIndex> objects;
        for (std::size_t place = 0; place < m_objects.size(); ++place)
            if (m_reached[place])
                objects.push_back(m_objects[place]);
        return objects;
    }

private:
    bool isConnected(std::int32_t place, std::size_t d) const
    {
        const ObjectIndex object = m_objects[static_cast<std::size_t>(place)];
        return object != nothing && m_aggregate.weight[d][object] > 0;
    }

    void reachPlace(std::int32_t place)
    {
        bool& reachedBefore = m_reached[static_cast<std::size_t>(place)];
        if (!reachedBefore)
            m_front.push_back(place);
        reachedBefore = true;
    }

    const Aggregate& m_aggregate;
    std::array<ObjectIndex, side * side * side> m_objects;
    std::array<bool, side * side * side> m_reached{};
    std::vector<std::int32_t> m_front;
};

double squaredDistanceToCell(const Vec3& coordinates, const Lattice::Node& cell)
{
    const Vec3 low(cell[0], cell[1], cell[2]);
    return Box(low, low + Vec3::Ones()).squaredExteriorDistance(coordinates);
}

} // namespace

NeighborhoodFinder::NeighborhoodFinder(const Aggregate& aggregate)
    : m_aggregate(aggregate)
    , m_rows(aggregate.lattice)
{
}

/// The edges and face diagonals of a kept cell are all connections. Only an empty cell enclosed by kept ones on all
/// sides looks the same, and there it makes no difference.
bool NeighborhoodFinder::isKept(const Lattice::Node& cell) const
{
    const auto inCell = [](std::int32_t c) { return c == 0 || c == 1; };
    for (std::int32_t corner = 0; corner < 8; ++corner) {
        const Lattice::Node local{corner >> 2, corner >> 1 & 1, corner & 1};
        const ObjectIndex object = m_rows.find({cell[0] + local[0], cell[1] + local[1], cell[2] + local[2]});
        if (object == m_aggregate.size())
            return false;
        for (std::size_t d = 0; d < Lattice::isotropicCount; ++d) {
            const Lattice::Node& step = Lattice::directions[d];
            const bool within = inCell(local[0] + step[0]) && inCell(local[1] + step[1]) && inCell(local[2] + step[2]);
            if (within && m_aggregate.weight[d][object] <= 0)
                return false;
        }
    }
    return true;
}

NeighborhoodFinder::Owner NeighborhoodFinder::owner(const Vec3& coordinates) const
{
    const Lattice::Node home{static_cast<std::int32_t>(std::floor(coordinates.x())),
                             static_cast<std::int32_t>(std::floor(coordinates.y())),
                             static_cast<std::int32_t>(std::floor(coordinates.z()))};
    if (isKept(home))
        return {home, true};
    Owner best;
    double bestDistance = std::numeric_limits<double>::infinity();
    for (std::int32_t u = -1; u <= 1; ++u)
        for (std::int32_t v = -1; v <= 1; ++v)
            for (std::int32_t w = -1; w <= 1; ++w) {
                const Lattice::Node cell{home[0] + u, home[1] + v, home[2] + w};
                const double distance = squaredDistanceToCell(coordinates, cell);
                if (distance < bestDistance && isKept(cell)) {
                    best = {cell, true};
                    bestDistance = distance;
                }
            }
    if (best.isCell)
        return best;
    return {m_aggregate.lattice.nodes[m_rows.nearest(coordinates)], false};
}

std::vector<ObjectIndex> NeighborhoodFinder::gather(const Owner& owner) const
{
    Block block(m_aggregate, m_rows, {owner.node[0] - reach, owner.node[1] - reach, owner.node[2] - reach});
    const std::int32_t last = owner.isCell ? reach + 1 : reach;
    for (std::int32_t u = reach; u <= last; ++u)
        for (std::int32_t v = reach; v <= last; ++v)
            for (std::int32_t w = reach; w <= last; ++w)
                block.start({u, v, w});
    for (std::int32_t steps = 0; steps < reach; ++steps)
        block.step();
    return block.reached();
}

} // namespace knead
