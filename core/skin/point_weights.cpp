#include "core/skin/point_weights.h"

#include "core/skin/shape_functions.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>

namespace knead {

namespace {

constexpr double wantedForPlaces = 6.4; // objects in the support, counted by their weight
constexpr double wantedForSlopes = 4.5; // the same of a fit for slopes: of 3.5 to 8 the best of stress at holes
constexpr double usual = 3;             // [a] the support below a flat face
constexpr double widest = 4.2;          // [a] as far as the neighborhoods of a cell go
constexpr double nodesWithin = 1.7;     // [a] the support reaches so far beyond the nearest object
constexpr double lastStep = 1e-7;       // of the support: the square of it is what the last step leaves
constexpr int mostSteps = 60;

/// So many objects are counted at a time.
using Lanes = Eigen::Array<double, 4, 1>;

struct Group {
    Lanes distance = Lanes::Constant(std::numeric_limits<double>::infinity());
    Lanes share = Lanes::Zero();
};

/// The objects that a support may hold.
struct Candidates {
    std::vector<Group> groups;
    double nearest = 0; ///< distance of the nearest object
    double most = 0;    ///< the largest support, so that it holds some

    Candidates(const std::vector<Vec3>& offsets, const std::vector<double>& shares)
    {
        std::vector<double> squares(offsets.size());
        std::transform(offsets.begin(), offsets.end(), squares.begin(),
                       [](const Vec3& offset) { return offset.squaredNorm(); });
        nearest = std::sqrt(*std::ranges::min_element(squares));
        most = std::max(widest, nearest + nodesWithin);
        groups.reserve(offsets.size() / Lanes::SizeAtCompileTime + 1);
        Eigen::Index lane = Lanes::SizeAtCompileTime;
        for (std::size_t i = 0; i < offsets.size(); ++i) {
            if (squares[i] >= most * most || shares[i] == 0)
                continue;
            if (lane == Lanes::SizeAtCompileTime) {
                groups.emplace_back();
                lane = 0;
            }
            groups.back().distance[lane] = squares[i];
            groups.back().share[lane++] = shares[i];
        }
        for (Group& group : groups)
            group.distance = group.distance.sqrt();
    }
};

struct Content {
    double count;
    double slope; ///< over the support
};

/// Objects in a support, counted by their weight as shape functions have it.
Content contentOf(const std::vector<Group>& groups, double support)
{
    Lanes count = Lanes::Zero();
    Lanes slope = Lanes::Zero();
    for (const auto& [distance, share] : groups) {
        const Lanes r = (distance * (1 / support)).min(1);
        const Lanes square = share * (1 - r) * (1 - r);
        count += square * (1 - r) * (3 * r + 1);
        slope += r * r * square;
    }
    return {count.sum(), 12 / support * slope.sum()};
}

/// The radius of a sphere around a point that holds enough objects for what is asked of them, and hardly more, by Newton's method.
/// It changes as smoothly as the point moves: with one fixed radius, a layer of objects would come in and go out again along a
/// flat face.
double supportFor(const Candidates& candidates, double wanted)
{
    const auto& [groups, nearest, most] = candidates;
    double low = nearest;
    double high = most;
    double support = std::min(most, std::max(usual, nearest + nodesWithin));
    for (int i = 0; i < mostSteps; ++i) {
        const auto [count, slope] = contentOf(groups, support);
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

/// What shape functions are made of.
struct Fit {
    std::vector<Vec3> offsets;
    std::vector<double> shares;
    double support;
};

Fit fitFor(const Lattice& lattice, const Neighborhood& around, const Vec3& coordinates, double wanted)
{
    Fit fit;
    fit.offsets.resize(around.objects.size());
    for (std::size_t i = 0; i < fit.offsets.size(); ++i) {
        const Lattice::Node& node = lattice.nodes[around.objects[i]];
        fit.offsets[i] = Vec3(node[0], node[1], node[2]) - coordinates;
    }
    fit.shares = around.shares(coordinates);
    fit.support = supportFor(Candidates(fit.offsets, fit.shares), wanted);
    return fit;
}

} // namespace

std::vector<double> pointWeights(const Lattice& lattice, const Neighborhood& around, const Vec3& coordinates)
{
    const Fit fit = fitFor(lattice, around, coordinates, wantedForPlaces);
    return shapeFunctions(fit.offsets, fit.support, fit.shares);
}

ShapeSlopes pointSlopes(const Lattice& lattice, const Neighborhood& around, const Vec3& coordinates)
{
    const Fit fit = fitFor(lattice, around, coordinates, wantedForSlopes);
    return shapeSlopes(fit.offsets, fit.support, fit.shares);
}

} // namespace knead
