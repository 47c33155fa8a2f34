#include "core/skin/shape_functions.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>

namespace knead {

namespace {

constexpr double smallestPivot = 1e-6;      // of the moment matrix scaled to a unit diagonal
constexpr double largestAmplification = 12; // of errors in node values, sum of |phi|; 1.7 at most surfaces
constexpr double widening = 1.35;           // of the support at sharp corners, where too few nodes are near

// Basis functions: 1, x, y, z, xx, yy, zz, xy, yz, zx.
constexpr std::size_t basisSize = 10;
using Powers = std::array<std::uint8_t, 3>;
constexpr std::array<Powers, basisSize> basisPowers{
    {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {1, 1, 0}, {0, 1, 1}, {1, 0, 1}}};

/// All products of two basis functions: the monomials up to degree 4, each one a coordinate times an earlier one. There are 35 of
/// them for the 100 entries of the moment matrix.
struct Monomials {
    static constexpr std::size_t count = 35;
    std::array<Powers, count> powers{};
    std::array<std::uint8_t, count> factor{}; ///< index of the earlier one
    std::array<std::uint8_t, count> axis{};   ///< of the coordinate
    std::array<std::array<std::uint8_t, basisSize>, basisSize> ofPair{};

    constexpr Monomials()
    {
        std::size_t next = 0;
        for (int degree = 0; degree <= 4; ++degree)
            for (int x = degree; x >= 0; --x)
                for (int y = degree - x; y >= 0; --y)
                    powers[next++] = {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y),
                                      static_cast<std::uint8_t>(degree - x - y)};
        for (std::size_t k = 1; k < count; ++k) {
            Powers lower = powers[k];
            axis[k] = lower[0] > 0 ? 0 : lower[1] > 0 ? 1 : 2;
            --lower[axis[k]];
            factor[k] = find(lower);
        }
        for (std::size_t i = 0; i < basisSize; ++i)
            for (std::size_t j = 0; j < basisSize; ++j) {
                Powers sum = basisPowers[i];
                for (std::size_t c = 0; c < 3; ++c)
                    sum[c] = static_cast<std::uint8_t>(sum[c] + basisPowers[j][c]);
                ofPair[i][j] = find(sum);
            }
    }

private:
    constexpr std::uint8_t find(const Powers& wanted) const
    {
        std::uint8_t k = 0;
        while (powers[k][0] != wanted[0] || powers[k][1] != wanted[1] || powers[k][2] != wanted[2])
            ++k;
        return k;
    }
};
constexpr Monomials monomials;

/// So many nodes are worked on at a time.
constexpr std::size_t lanes = 4;
using Lanes = Eigen::Array<double, lanes, 1>;

/// Nodes closer than the support, in units of it, with their weights; those that fill up the last lanes weigh nothing.
struct WeightedNodes {
    struct Group {
        std::array<Lanes, 3> place{Lanes::Zero(), Lanes::Zero(), Lanes::Zero()};
        Lanes weight = Lanes::Zero();
    };
    std::vector<Group> groups;
    std::vector<std::uint32_t> indices; ///< of the nodes
};

WeightedNodes weigh(std::span<const Vec3> offsets, double support)
{
    WeightedNodes nodes;
    nodes.indices.reserve(offsets.size());
    nodes.groups.reserve(offsets.size() / lanes + 1);
    for (std::uint32_t i = 0; i < offsets.size(); ++i) {
        const double squared = offsets[i].squaredNorm() / (support * support);
        if (squared >= 1)
            continue;
        const std::size_t lane = nodes.indices.size() % lanes;
        if (lane == 0)
            nodes.groups.emplace_back();
        WeightedNodes::Group& group = nodes.groups.back();
        const double r = std::sqrt(squared);
        const double rest = (1 - r) * (1 - r);
        group.weight[lane] = rest * rest * (4 * r + 1); // Wendland's C2 function
        for (Eigen::Index c = 0; c < 3; ++c)
            group.place[c][lane] = offsets[i][c] / support;
        nodes.indices.push_back(i);
    }
    return nodes;
}

/// Sums of the weighted monomials over all nodes.
std::array<double, Monomials::count> momentsOf(const WeightedNodes& nodes)
{
    std::array<Lanes, Monomials::count> sums;
    sums.fill(Lanes::Zero());
    for (const WeightedNodes::Group& group : nodes.groups) {
        std::array<Lanes, Monomials::count> values;
        values[0] = group.weight;
        sums[0] += values[0];
#pragma GCC unroll 35
        for (std::size_t k = 1; k < Monomials::count; ++k) {
            values[k] = values[monomials.factor[k]] * group.place[monomials.axis[k]];
            sums[k] += values[k];
        }
    }
    std::array<double, Monomials::count> moments;
    std::transform(sums.begin(), sums.end(), moments.begin(), [](const Lanes& sum) { return sum.sum(); });
    return moments;
}

/// Values of the functions at those nodes, in their order.
using Functions = std::vector<double>;

Functions functionsAt(const WeightedNodes& nodes, const Eigen::Matrix<double, basisSize, 1>& c)
{
    Functions functions;
    functions.reserve(lanes * nodes.groups.size());
    for (const auto& [place, weight] : nodes.groups) {
        const auto& [x, y, z] = place;
        const Lanes value = weight * (c[0] + x * (c[1] + c[4] * x + c[7] * y) + y * (c[2] + c[5] * y + c[8] * z) +
                                      z * (c[3] + c[6] * z + c[9] * x));
        functions.insert(functions.end(), value.begin(), value.end());
    }
    functions.resize(nodes.indices.size());
    return functions;
}

/// phi_i = w_i p(x_i)^T M^-1 p(0) with M = sum_i w_i p(x_i) p(x_i)^T, of the first `size` basis functions; nothing when M is
/// close to singular.
template <int size>
std::optional<Functions> solve(const WeightedNodes& nodes)
{
    using Basis = Eigen::Matrix<double, size, 1>;
    using Square = Eigen::Matrix<double, size, size>;
    const std::array<double, Monomials::count> sums = momentsOf(nodes);
    Square moments;
    for (int i = 0; i < size; ++i)
        for (int j = 0; j < size; ++j)
            moments(i, j) = sums[monomials.ofPair[i][j]];
    const Basis diagonal = moments.diagonal();
    if (!(diagonal.minCoeff() > 0))
        return std::nullopt;
    const Basis scale = diagonal.cwiseSqrt().cwiseInverse();
    const Eigen::LDLT<Square> factors(scale.asDiagonal() * moments * scale.asDiagonal());
    if (factors.vectorD().minCoeff() < smallestPivot)
        return std::nullopt;
    Eigen::Matrix<double, basisSize, 1> solution = Eigen::Matrix<double, basisSize, 1>::Zero();
    solution.template head<size>() = scale.cwiseProduct(factors.solve(scale[0] * Basis::Unit(0)));
    return functionsAt(nodes, solution);
}

double amplification(const Functions& functions)
{
    return std::accumulate(functions.begin(), functions.end(), 0.0,
                           [](double sum, double function) { return sum + std::abs(function); });
}

/// One value for every offset, zero for nodes that are too far.
std::vector<double> spread(const Functions& functions, const WeightedNodes& nodes, std::size_t count)
{
    std::vector<double> all(count, 0);
    for (std::size_t i = 0; i < functions.size(); ++i)
        all[nodes.indices[i]] = functions[i];
    return all;
}

std::optional<Functions> solveQuadratic(const WeightedNodes& nodes)
{
    auto functions = solve<10>(nodes);
    if (functions && amplification(*functions) > largestAmplification)
        return std::nullopt;
    return functions;
}

} // namespace

std::vector<double> shapeFunctions(std::span<const Vec3> offsets, double support)
{
    const WeightedNodes near = weigh(offsets, support);
    if (const auto functions = solveQuadratic(near))
        return spread(*functions, near, offsets.size());
    const WeightedNodes wide = weigh(offsets, widening * support);
    if (const auto functions = solveQuadratic(wide))
        return spread(*functions, wide, offsets.size());
    if (const auto functions = solve<4>(near))
        return spread(*functions, near, offsets.size());
    return spread(*solve<1>(near), near, offsets.size());
}

} // namespace knead
