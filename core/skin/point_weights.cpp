#include "core/skin/point_weights.h"

#include "core/skin/shape_functions.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace knead {

namespace {

constexpr double support = 2.6;     // [a]
constexpr double nodesWithin = 1.7; // [a] the support reaches so far beyond the nearest object

/// Points far from all objects need a wider support to find any.
double supportFor(const std::vector<Vec3>& offsets)
{
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vec3& offset : offsets)
        nearest = std::min(nearest, offset.squaredNorm());
    return std::max(support, std::sqrt(nearest) + nodesWithin);
}

} // namespace

std::vector<double> pointWeights(const Lattice& lattice, std::span<const ObjectIndex> objects, const Vec3& coordinates)
{
    std::vector<Vec3> offsets(objects.size());
    for (std::size_t i = 0; i < objects.size(); ++i) {
        const Lattice::Node& node = lattice.nodes[objects[i]];
        offsets[i] = Vec3(node[0], node[1], node[2]) - coordinates;
    }
    return shapeFunctions(offsets, supportFor(offsets));
}

} // namespace knead
