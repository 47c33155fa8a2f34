#include "core/skin/point_weights.h"

#include "core/skin/shape_functions.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>

namespace knead {

namespace {

constexpr double wanted = 6.4;      // objects in the support, counted by their weight
constexpr double usual = 3;         // [a] the support below a flat face
constexpr double widest = 4.2;      // [a] as far as the neighborhoods of a cell go
constexpr double nodesWithin = 1.7; // [a] the support reaches so far beyond the nearest object
constexpr double lastStep = 1e-7;   // of the support: the square of it is what the last step leaves
constexpr int mostSteps = 60;

/// So many objects are counted at a time.
using Lanes = Eigen::Array<double, 4, 1>;

struct Content {
    double count;
    double slope; ///< over the support
};

/// Objects in a support, counted by their weight as shape functions have it.
Content contentOf(const std::vector<Lanes>& distances, double support)
{
    Lanes count = Lanes::Zero();
    Lanes slope = Lanes::Zero();
    for (const Lanes& distance : distances) {
        const Lanes r = (distance * (1 / support)).min(1);
        const Lanes square = (1 - r) * (1 - r);
        count += square * (1 - r) * (3 * r + 1);
        slope += r * r * square;
    }
    return {count.sum(), 12 / support * slope.sum()};
}

/// The radius of a sphere around a point that holds enough objects for what is asked of them, and hardly more, by Newton's method.
/// It changes as smoothly as the point moves: with one fixed radius, a layer of objects would come in and go out again along a
/// flat face.
double supportFor(const std::vector<Vec3>& offsets)
{
    std::vector<Lanes> distances((offsets.size() + Lanes::SizeAtCompileTime - 1) / Lanes::SizeAtCompileTime,
                                 Lanes::Constant(std::numeric_limits<double>::infinity()));
    double low = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < offsets.size(); ++i) {
        const double distance = offsets[i].norm();
        distances[i / Lanes::SizeAtCompileTime][static_cast<Eigen::Index>(i % Lanes::SizeAtCompileTime)] = distance;
        low = std::min(low, distance);
    }
    const double most = std::max(widest, low + nodesWithin);
    double high = most;
    double support = std::min(most, std::max(usual, low + nodesWithin));
    for (int i = 0; i < mostSteps; ++i) {
        const auto [count, slope] = contentOf(distances, support);
        if (support == most && count <= wanted)
            return most;
        (count > wanted ? high : low) = support;
        const double next = support - (count - wanted) / slope;
        if (std::abs(next - support) <= lastStep * support)
            return next;
        support = next >= most ? most : next > low && next < high ? next : (low + high) / 2;
    }
    return support;
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
