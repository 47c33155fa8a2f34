#include "core/kernels/fit_kernels.h"
#include "core/skin/neighborhood.h"
#include "core/skin/neighborhood_walks.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>
#include <span>

namespace knead {

using namespace neighborhood_walks;

namespace {

constexpr double window = 1.5; // kept cells farther from a point than the nearest, by this factor, have no part in it

/// From 0 to 1, flat at both ends and beyond.
double smoothStep(double x)
{
    const double t = std::clamp(x, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

double squaredDistanceToCell(const Vec3& coordinates, const Lattice::Node& cell)
{
    const Vec3 low(cell[0], cell[1], cell[2]);
    return Box(low, low + Vec3::Ones()).squaredExteriorDistance(coordinates);
}

constexpr std::size_t mostCells = 27; // an owner has

/// Parts that cells have in a point, which sum to 1.
std::array<double, mostCells> partsOf(const std::vector<Lattice::Node>& cells, const Vec3& coordinates)
{
    std::array<double, mostCells> all{};
    const std::span<double> parts(all.data(), cells.size());
    std::ranges::transform(cells, parts.begin(), [&](const Lattice::Node& cell) {
        return std::sqrt(squaredDistanceToCell(coordinates, cell));
    });
    const double least = *std::ranges::min_element(parts);
    if (least == 0 || cells.size() == 1) { // those that contain the point all say the same of it
        const auto first = std::ranges::find(parts, least);
        std::ranges::fill(parts, 0);
        *first = 1;
        return all;
    }
    double sum = 0;
    for (double& part : parts)
        sum += part = smoothStep((window - part / least) / (window - 1));
    for (double& part : parts)
        part /= sum;
    return all;
}

/// Adds a number to those whose sets hold a walk.
void addWhere(std::span<const std::uint64_t> sets, std::size_t walk, double number, std::span<double> sums)
{
    const auto bits = std::bit_cast<std::uint64_t>(number);
    for (std::size_t set = 0; set < sums.size(); ++set)
        sums[set] += std::bit_cast<double>(bits & (0 - (sets[set] >> walk & 1U))); // without a branch
}

constexpr std::int32_t mostHalves =
    2 * reach + corners - 1; // between the middle of an owner and an object, along an axis
constexpr std::size_t farthest = 3 * mostHalves * mostHalves; // twice the distance, squared
constexpr std::size_t quarters = 4 * mostHalves;              // of a step: farther from the middle no object is

} // namespace

Neighborhood::Outward outwardOrder(const std::vector<Lattice::Node>& nodes, const Vec3& middle)
{
    Lattice::Node twiceMiddle{}; // whole numbers, as twice the distance from it is, squared: objects are counted by it
    for (std::size_t axis = 0; axis < 3; ++axis)
        twiceMiddle[axis] = static_cast<std::int32_t>(std::lround(2 * middle[static_cast<Eigen::Index>(axis)]));
    std::array<std::uint16_t, farthest + 2> before{};
    std::vector<std::uint16_t> keys(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        std::int32_t key = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::int32_t twice = 2 * nodes[i][axis] - twiceMiddle[axis];
            key += twice * twice;
        }
        keys[i] = static_cast<std::uint16_t>(key);
        ++before[static_cast<std::size_t>(key) + 1];
    }
    std::partial_sum(before.begin(), before.end(), before.begin());
    Neighborhood::Outward outward;
    for (std::size_t k = 0; k <= quarters; ++k) // twice k / 4, squared
        outward.within.push_back(before[std::min(farthest + 1, (k * k + 3) / 4)]);
    outward.order.resize(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i)
        outward.order[before[keys[i]]++] = static_cast<std::uint16_t>(i);
    constexpr float farAway = 1e30F;
    const std::size_t filledUp = kernels::inFitLanes(nodes.size());
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::vector<float>& steps = outward.steps[axis];
        steps.assign(filledUp, farAway);
        for (std::size_t i = 0; i < nodes.size(); ++i)
            steps[i] =
                static_cast<float>(nodes[outward.order[i]][axis] - middle[static_cast<Eigen::Index>(axis)]); // exact
    }
    return outward;
}

Vec3 Neighborhood::middle() const
{
    const Vec3 node(owner.node[0], owner.node[1], owner.node[2]);
    return owner.kind == SkinOwner::Kind::object ? node : Vec3(node.array() + 0.5);
}

std::size_t Neighborhood::mostWithin(double radius, double away) const
{
    const double quarter = std::ceil(4 * (radius + away));
    return quarter < static_cast<double>(outward.within.size()) ? outward.within[static_cast<std::size_t>(quarter)]
                                                                : outward.order.size();
}

std::vector<double> Neighborhood::sharesOfSets(const Vec3& coordinates) const
{
    if (cells.empty())
        return std::vector<double>(walks.size(), 1);
    std::array<double, corners * corners * corners> ofWalk{};
    const std::array<double, mostCells> parts = partsOf(cells, coordinates);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (parts[i] == 0)
            continue;
        std::array<Vec3, 2> along;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto component = static_cast<Eigen::Index>(axis);
            along[1][component] = smoothStep(coordinates[component] - cells[i][axis]);
            along[0][component] = 1 - along[1][component];
        }
        for (const Lattice::Node& corner : Lattice::cellCorners)
            ofWalk[walkFrom(Lattice::sum(Lattice::difference(cells[i], owner.node), corner))] +=
                parts[i] * along[static_cast<std::size_t>(corner[0])].x() *
                along[static_cast<std::size_t>(corner[1])].y() * along[static_cast<std::size_t>(corner[2])].z();
    }
    std::vector<double> ofSet(walks.size(), 0);
    std::uint64_t all = 0;
    for (std::size_t walk = 0; walk < ofWalk.size(); ++walk)
        if (ofWalk[walk] > 0) {
            all |= std::uint64_t{1} << walk;
            addWhere(walks, walk, ofWalk[walk], ofSet);
        }
    for (std::size_t set = 0; set < ofSet.size(); ++set)
        if ((walks[set] & all) == all)
            ofSet[set] = 1; // without rounding
    return ofSet;
}

} // namespace knead
