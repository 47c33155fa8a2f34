#include "core/geometry/point_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace knead {

PointTree::PointTree(std::vector<Vec3> points)
    : m_points(std::move(points))
    , m_order(m_points.size())
    , m_sides(m_points.size())
{
    std::iota(m_order.begin(), m_order.end(), 0U);
    sort(0, m_order.size());
}

void PointTree::sort(std::size_t begin, std::size_t end)
{
    if (end - begin < 2)
        return;
    Box box;
    for (std::size_t i = begin; i < end; ++i)
        box.extend(m_points[m_order[i]]);
    Eigen::Index side = 0;
    box.sizes().maxCoeff(&side);
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [this](std::size_t i) { return m_order.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end), [&](std::uint32_t one, std::uint32_t other) {
        return std::pair(m_points[one][side], one) < std::pair(m_points[other][side], other);
    });
    m_sides[middle] = static_cast<std::uint8_t>(side);
    sort(begin, middle);
    sort(middle + 1, end);
}

void PointTree::search(std::size_t begin, std::size_t end, const Vec3& place, std::vector<Found>& best,
                       std::size_t count) const
{
    if (begin >= end)
        return;
    const std::size_t middle = begin + (end - begin) / 2;
    const Vec3& point = m_points[m_order[middle]];
    const double beyond = place[m_sides[middle]] - point[m_sides[middle]];
    const bool isHigh = beyond > 0;
    search(isHigh ? middle + 1 : begin, isHigh ? end : middle, place, best, count);
    const auto before = [](const Found& one, const Found& other) {
        return std::pair(one.distance, one.point) < std::pair(other.distance, other.point);
    };
    const Found found{(point - place).norm(), m_order[middle]};
    if (best.size() < count || before(found, best.back())) {
        best.insert(std::upper_bound(best.begin(), best.end(), found, before), found);
        if (best.size() > count)
            best.pop_back();
    }
    if (best.size() < count || std::abs(beyond) <= best.back().distance)
        search(isHigh ? begin : middle + 1, isHigh ? middle : end, place, best, count);
}

std::vector<PointTree::Found> PointTree::nearest(const Vec3& place, std::size_t count) const
{
    std::vector<Found> best;
    best.reserve(count + 1);
    search(0, m_order.size(), place, best, count);
    return best;
}

} // namespace knead
