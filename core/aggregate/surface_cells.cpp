#include "core/aggregate/surface_cells.h"

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

std::int32_t cellOf(double coordinate)
{
    return static_cast<std::int32_t>(std::floor(coordinate));
}

/// Least and greatest w of the triangle's plane over a square of the u-v plane, as far as the triangle reaches.
std::array<double, 2> heights(const std::array<Vec3, 3>& corners, const Vec3& normal, const Eigen::AlignedBox2d& square)
{
    double low = std::min({corners[0].z(), corners[1].z(), corners[2].z()});
    double high = std::max({corners[0].z(), corners[1].z(), corners[2].z()});
    if (std::abs(normal.z()) > 1e-9 * normal.norm()) {
        const Eigen::Vector2d slope = -normal.head<2>() / normal.z();
        const double middle = corners[0].z() + slope.dot(square.center() - corners[0].head<2>());
        const double spread = 0.5 * slope.cwiseAbs().dot(square.sizes());
        low = std::max(low, middle - spread);
        high = std::min(high, middle + spread);
    }
    return {low, high};
}

/// Whether a triangle that is upright, a line seen along w, passes the square by.
bool passesBy(const std::array<Vec3, 3>& corners, const Vec3& normal, const Eigen::AlignedBox2d& square)
{
    const Eigen::Vector2d across = normal.head<2>();
    const double distance = std::abs(across.dot(square.center() - corners[0].head<2>()));
    const double reach = 0.5 * across.cwiseAbs().dot(square.sizes()) + std::abs(normal.z()) * 1e9;
    return distance > reach;
}

/// Whether a side of the triangle, seen along w, has the whole square beyond it.
bool isBeside(const std::array<Vec3, 3>& corners, double orientation, const Eigen::AlignedBox2d& square)
{
    for (std::size_t i = 0; i < 3; ++i) {
        const Eigen::Vector2d from = corners[i].head<2>();
        const Eigen::Vector2d along = corners[(i + 1) % 3].head<2>() - from;
        const Eigen::Vector2d inwards = orientation * Eigen::Vector2d(-along.y(), along.x());
        const double middle = inwards.dot(square.center() - from);
        if (middle + 0.5 * inwards.cwiseAbs().dot(square.sizes()) < 0)
            return true;
    }
    return false;
}

} // namespace

void forEachTouchedCell(const std::array<Vec3, 3>& corners, double margin,
                        const std::function<void(const Lattice::Node& cell)>& visit)
{
    const Vec3 low = corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]) - Vec3::Constant(margin);
    const Vec3 high = corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]) + Vec3::Constant(margin);
    const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    const double orientation = normal.z() > 0 ? 1 : normal.z() < 0 ? -1 : 0;
    for (std::int32_t u = cellOf(low.x()); u <= cellOf(high.x()); ++u)
        for (std::int32_t v = cellOf(low.y()); v <= cellOf(high.y()); ++v) {
            const Eigen::AlignedBox2d square(Eigen::Vector2d(u - margin, v - margin),
                                             Eigen::Vector2d(u + 1 + margin, v + 1 + margin));
            if (isBeside(corners, orientation, square) || passesBy(corners, normal, square))
                continue;
            const auto [from, to] = heights(corners, normal, square);
            for (std::int32_t w = cellOf(from - margin); w <= cellOf(to + margin); ++w)
                visit({u, v, w});
        }
}

} // namespace knead
