#include "core/vicinity/point_grid.h"

#include "core/task/parallel.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace knead {

namespace {

constexpr std::size_t placesPerBlock = 256;
constexpr int farthestRing = 8; // cells

std::uint64_t keyOf(const std::array<std::int64_t, 3>& cell)
{
    constexpr std::int64_t middle = 1 << 20; // 21 bits an axis
    std::uint64_t key = 0;
    for (const std::int64_t c : cell)
        key = key << 21U | (static_cast<std::uint64_t>(c + middle) & 0x1fffffU);
    return key;
}

} // namespace

PointGrid::PointGrid(const VectorArray& points, double cell)
    : m_points(points)
    , m_cell(cell)
{
    for (ObjectIndex i = 0; i < points.size(); ++i)
        m_cells[keyOf(cellOf(points.at(i)))].push_back(i);
}

PointGrid::Cell PointGrid::cellOf(const Vec3& place) const
{
    Cell cell{};
    for (std::size_t c = 0; c < 3; ++c)
        cell[c] = static_cast<std::int64_t>(std::floor(place[static_cast<Eigen::Index>(c)] / m_cell));
    return cell;
}

void PointGrid::addRing(const Cell& center, int ring, const Vec3& place, std::vector<Found>& found) const
{
    for (int u = -ring; u <= ring; ++u)
        for (int v = -ring; v <= ring; ++v)
            for (int w = -ring; w <= ring; ++w) {
                if (std::max({std::abs(u), std::abs(v), std::abs(w)}) != ring)
                    continue;
                const auto cell = m_cells.find(keyOf({center[0] + u, center[1] + v, center[2] + w}));
                if (cell != m_cells.end())
                    for (const ObjectIndex point : cell->second)
                        found.push_back({(m_points.at(point) - place).squaredNorm(), point});
            }
}

void PointGrid::nearest(const Vec3& place, std::size_t most, std::vector<Found>& found, double within) const
{
    most = std::min(most, m_points.size());
    const Cell center = cellOf(place);
    found.clear();
    bool isSure = false;
    for (int ring = 0; ring <= farthestRing && !isSure; ++ring) {
        if ((ring - 1) * m_cell > within)
            break;
        addRing(center, ring, place, found);
        const double sure = ring * m_cell; // what was not looked at is farther than this
        const auto isWithin = [&](const Found& one) { return one.squared <= sure * sure; };
        isSure = static_cast<std::size_t>(std::ranges::count_if(found, isWithin)) >= most;
    }
    if (!isSure && within > farthestRing * m_cell) { // far from all of them
        found.clear();
        for (ObjectIndex i = 0; i < m_points.size(); ++i)
            found.push_back({(m_points.at(i) - place).squaredNorm(), i});
    }
    std::erase_if(found, [&](const Found& one) { return one.squared >= within * within; });
    std::ranges::sort(found);
    found.resize(std::min(most, found.size()));
}

std::vector<ObjectIndex> nearestPoints(const VectorArray& points, const VectorArray& places, double spacing)
{
    const PointGrid grid(points, spacing);
    std::vector<ObjectIndex> nearest(places.size());
    forEachBlock(places.size(), placesPerBlock, [&](std::size_t begin, std::size_t end) {
        std::vector<PointGrid::Found> found;
        for (std::size_t i = begin; i < end; ++i) {
            grid.nearest(places.at(i), 1, found);
            nearest[i] = found.front().point;
        }
    });
    return nearest;
}

} // namespace knead
