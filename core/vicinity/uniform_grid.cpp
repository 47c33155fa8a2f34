#include "core/vicinity/uniform_grid.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace knead {

namespace {

auto order(std::int32_t x, std::int32_t y, std::int32_t z) { return std::tuple(z, y, x); }

// Cells further out share the border cell: their contents are tested exactly anyway, and no coordinate overflows.
constexpr double farthestCell = 1e9;

} // namespace

UniformGrid::Cell UniformGrid::cellOf(const Vec3& place) const
{
    return (place / m_cellSize).array().floor().cwiseMax(-farthestCell).cwiseMin(farthestCell).matrix().cast<std::int32_t>();
}

void UniformGrid::build(std::span<const VicinitySphere> spheres, double margin)
{
    m_spheres.assign(spheres.begin(), spheres.end());
    m_margin = margin;
    double largest = 0;
    for (const VicinitySphere& sphere : m_spheres)
        largest = std::max(largest, sphere.radius);
    m_cellSize = std::max(2 * largest + margin, 1e-12);
    m_entries.clear();
    m_entries.reserve(m_spheres.size());
    for (std::uint32_t i = 0; i < m_spheres.size(); ++i)
        m_entries.push_back({cellOf(m_spheres[i].center), i});
    std::sort(m_entries.begin(), m_entries.end(), [](const Entry& a, const Entry& b) {
        return std::tuple(order(a.cell.x(), a.cell.y(), a.cell.z()), a.sphere) <
               std::tuple(order(b.cell.x(), b.cell.y(), b.cell.z()), b.sphere);
    });
}

std::span<const UniformGrid::Entry> UniformGrid::row(std::int32_t x0, std::int32_t x1, std::int32_t y, std::int32_t z) const
{
    const auto before = [](const Entry& entry, const auto& key) {
        return order(entry.cell.x(), entry.cell.y(), entry.cell.z()) < key;
    };
    const auto first = std::lower_bound(m_entries.begin(), m_entries.end(), order(x0, y, z), before);
    const auto last = std::lower_bound(first, m_entries.end(), order(x1 + 1, y, z), before);
    return {first, last};
}

std::vector<UniformGrid::Pair> UniformGrid::pairs() const
{
    std::vector<Pair> found;
    for (const Entry& entry : m_entries) {
        const VicinitySphere& sphere = m_spheres[entry.sphere];
        for (std::int32_t dz = -1; dz <= 1; ++dz)
            for (std::int32_t dy = -1; dy <= 1; ++dy)
                for (const Entry& other : row(entry.cell.x() - 1, entry.cell.x() + 1, entry.cell.y() + dy, entry.cell.z() + dz)) {
                    const VicinitySphere& candidate = m_spheres[other.sphere];
                    if (other.sphere <= entry.sphere || candidate.group == sphere.group)
                        continue;
                    const double reach = sphere.radius + candidate.radius + m_margin;
                    if ((candidate.center - sphere.center).squaredNorm() < reach * reach)
                        found.push_back({entry.sphere, other.sphere});
                }
    }
    std::sort(found.begin(), found.end());
    return found;
}

std::vector<std::uint32_t> UniformGrid::inBox(const Box& box) const
{
    std::vector<std::uint32_t> found;
    const auto keepInside = [&](std::span<const Entry> entries) {
        for (const Entry& entry : entries)
            if (box.contains(m_spheres[entry.sphere].center))
                found.push_back(entry.sphere);
    };
    const Cell low = cellOf(box.min());
    const Cell high = cellOf(box.max());
    const double rows = (double(high.y()) - low.y() + 1) * (double(high.z()) - low.z() + 1);
    if (rows > static_cast<double>(m_entries.size())) {
        keepInside(m_entries);
    } else {
        for (std::int32_t z = low.z(); z <= high.z(); ++z)
            for (std::int32_t y = low.y(); y <= high.y(); ++y)
                keepInside(row(low.x(), high.x(), y, z));
    }
    std::sort(found.begin(), found.end());
    return found;
}

} // namespace knead
