#include "core/geometry/smooth_map.h"

#include <algorithm>
#include <array>

namespace knead {

namespace {

constexpr double differenceShare = 0.1; // of the feature size: steps of a skin beside thin walls are far smaller
constexpr double longestDifference = 1; // maps that have no features

} // namespace

Vec3 SmoothMap::at(const Vec3& point) const
{
    Vec3 place;
    evaluate({&point, 1}, {&place, 1});
    return place;
}

Mat3 SmoothMap::gradient(const Vec3& point) const
{
    const double h = std::min(differenceShare * featureSize(), longestDifference);
    std::array<Vec3, 6> points;
    std::array<Vec3, 6> places;
    for (int axis = 0; axis < 3; ++axis) {
        points[static_cast<std::size_t>(2 * axis)] = point + h * Vec3::Unit(axis);
        points[static_cast<std::size_t>(2 * axis + 1)] = point - h * Vec3::Unit(axis);
    }
    evaluate(points, places);
    Mat3 gradient;
    for (int axis = 0; axis < 3; ++axis)
        gradient.col(axis) =
            (places[static_cast<std::size_t>(2 * axis)] - places[static_cast<std::size_t>(2 * axis + 1)]) / (2 * h);
    return gradient;
}

} // namespace knead
