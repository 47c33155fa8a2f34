#include "core/mechanics/point_spread.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace knead {

namespace {

constexpr double rounding = 1e-9; // of a spacing: so near to a plane of nodes is in it

Vec3 localOf(const Lattice& lattice, const Vec3& place)
{
    Vec3 local = lattice.coordinates(place);
    for (Eigen::Index axis = 0; axis < 3; ++axis)
        if (const double plane = std::round(local[axis]); std::abs(local[axis] - plane) < rounding)
            local[axis] = plane;
    return local;
}

/// How far a point lies outside of a cell, in spacings, squared.
double outside(const Vec3& local, const Lattice::Node& cell)
{
    double squared = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double within = local[static_cast<Eigen::Index>(axis)] - cell[axis];
        const double beyond = std::max({0.0, -within, within - 1});
        squared += beyond * beyond;
    }
    return squared;
}

std::optional<PointSpread> spreadIn(const Lattice& lattice, const Lattice::Node& cell, const Vec3& local)
{
    PointSpread spread;
    for (int corner = 0; corner < 8; ++corner) {
        Lattice::Node node = cell;
        double weight = 1;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const int up = corner >> axis & 1;
            const double within = local[static_cast<Eigen::Index>(axis)] - cell[axis];
            node[axis] += up;
            weight *= up != 0 ? within : 1 - within;
        }
        const ObjectIndex object = lattice.find(node);
        if (object == lattice.size())
            return std::nullopt;
        if (weight == 0)
            continue;
        spread.objects[spread.count] = object;
        spread.weights[spread.count++] = weight;
    }
    return spread;
}

} // namespace

ObjectIndex PointSpread::main() const
{
    const auto largest = std::max_element(weights.begin(), weights.begin() + count);
    return objects[static_cast<std::size_t>(largest - weights.begin())];
}

PointSpread spreadOf(ObjectIndex object)
{
    return {.objects = {object}, .weights = {1}, .count = 1};
}

std::optional<PointSpread> spreadOf(const Lattice& lattice, const Vec3& place)
{
    const Vec3 local = localOf(lattice, place);
    std::optional<PointSpread> nearest;
    double least = std::numeric_limits<double>::infinity();
    for (std::int32_t u = -1; u <= 1; ++u)
        for (std::int32_t v = -1; v <= 1; ++v)
            for (std::int32_t w = -1; w <= 1; ++w) {
                const Lattice::Node cell{static_cast<std::int32_t>(std::floor(local.x())) + u,
                                         static_cast<std::int32_t>(std::floor(local.y())) + v,
                                         static_cast<std::int32_t>(std::floor(local.z())) + w};
                const double distance = outside(local, cell);
                if (distance >= least)
                    continue;
                if (auto spread = spreadIn(lattice, cell, local)) {
                    nearest = spread;
                    least = distance;
                }
            }
    return nearest;
}

} // namespace knead
