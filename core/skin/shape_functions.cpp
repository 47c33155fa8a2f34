#include "core/skin/shape_functions.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

namespace knead {

namespace {

// Functions are given up by and by, so that nothing jumps from one point to the next.
constexpr double poorPivot = 1e-6; // of the moment matrix scaled to a unit diagonal
constexpr double goodPivot = 1e-4;
constexpr double goodAmplification = 10; // of errors in node values, sum of |phi|; 1.7 at most surfaces
constexpr double poorAmplification = 16;
constexpr double ridge = 0.03; // keeps second derivatives small that the nodes hardly determine

// Basis functions: 1, x, y, z, xx, yy, zz, xy, yz, zx.
constexpr std::size_t basisSize = 10;
constexpr std::size_t linearSize = 4;
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

WeightedNodes weigh(std::span<const Vec3> offsets, double support, std::span<const double> shares)
{
    WeightedNodes nodes;
    nodes.indices.reserve(offsets.size());
    nodes.groups.reserve(offsets.size() / lanes + 1);
    for (std::uint32_t i = 0; i < offsets.size(); ++i) {
        const double squared = offsets[i].squaredNorm() / (support * support);
        const double share = shares.empty() ? 1 : shares[i];
        if (squared >= 1 || share == 0)
            continue;
        const std::size_t lane = nodes.indices.size() % lanes;
        if (lane == 0)
            nodes.groups.emplace_back();
        WeightedNodes::Group& group = nodes.groups.back();
        const double r = std::sqrt(squared);
        const double rest = (1 - r) * (1 - r);
        group.weight[lane] = share * rest * (1 - r) * (3 * r + 1);
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

using Basis = Eigen::Matrix<double, basisSize, 1>;
using Square = Eigen::Matrix<double, basisSize, basisSize>;

/// M = sum_i w_i p(x_i) p(x_i)^T, scaled to a unit diagonal, as L D L^T. Pivots are taken in the order of the basis: what they are
/// changes as smoothly as M does.
struct Factors {
    Basis scale = Basis::Zero();
    Square lower = Square::Zero(); ///< L below the diagonal
    Basis pivots = Basis::Zero();  ///< D; zero from where M is singular

    /// @param damping added to the diagonal for the quadratic functions
    Factors(const std::array<double, Monomials::count>& moments, double damping)
    {
        Square rest;
        for (Eigen::Index i = 0; i < rest.rows(); ++i)
            for (Eigen::Index j = 0; j < rest.cols(); ++j)
                rest(i, j) = moments[monomials.ofPair[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]];
        if (!(rest.diagonal().minCoeff() > 0))
            return;
        scale = rest.diagonal().cwiseSqrt().cwiseInverse();
        rest = (scale.asDiagonal() * rest * scale.asDiagonal()).eval();
        rest.diagonal().tail<basisSize - linearSize>().array() += damping;
        for (Eigen::Index k = 0; k < rest.rows(); ++k) {
            const double pivot = rest(k, k);
            if (!(pivot > std::numeric_limits<double>::epsilon()))
                return;
            pivots[k] = pivot;
            for (Eigen::Index i = k + 1; i < rest.rows(); ++i)
                lower(i, k) = rest(i, k) / pivot;
            for (Eigen::Index j = k + 1; j < rest.cols(); ++j)
                for (Eigen::Index i = j; i < rest.rows(); ++i)
                    rest(i, j) -= lower(i, k) * pivot * lower(j, k);
        }
    }

    /// (M + damping)^-1 e for the unit vector e of a basis function: of the first one, what the fit says of the value at the origin,
    /// of the next three, of its slopes. @pre no pivot is zero
    Basis solve(Eigen::Index function = 0) const
    {
        Basis x = scale[function] * Basis::Unit(function);
        for (Eigen::Index k = function; k < x.size(); ++k)
            for (Eigen::Index i = k + 1; i < x.size(); ++i)
                x[i] -= lower(i, k) * x[k];
        x = x.cwiseQuotient(pivots).eval();
        for (Eigen::Index k = x.size() - 1; k >= 0; --k)
            for (Eigen::Index i = k + 1; i < x.size(); ++i)
                x[k] -= lower(i, k) * x[i];
        return scale.cwiseProduct(x);
    }
};

double amplification(const Functions& functions)
{
    return std::accumulate(functions.begin(), functions.end(), 0.0,
                           [](double sum, double function) { return sum + std::abs(function); });
}

/// 0 at one end of a range and beyond, 1 at the other, flat at both.
double smoothStep(double x, double zero, double one)
{
    const double t = std::clamp((x - zero) / (one - zero), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

/// How far functions can be trusted that some pivots stand for: from 0 to 1.
double trustIn(const Eigen::Ref<const Eigen::VectorXd>& pivots)
{
    double trust = 1;
    for (const double pivot : pivots)
        trust *= pivot > 0 ? smoothStep(std::log(pivot), std::log(poorPivot), std::log(goodPivot)) : 0;
    return trust;
}

/// Adds what each node contributes to the slopes of a fit.
void addSlopes(ShapeSlopes& all, const WeightedNodes& nodes, const Factors& factors, double support, double share)
{
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const Functions functions = functionsAt(nodes, factors.solve(1 + axis));
        for (std::size_t i = 0; i < functions.size(); ++i)
            all.slopes[nodes.indices[i]][axis] += share / support * functions[i];
    }
}

} // namespace

std::vector<double> shapeFunctions(std::span<const Vec3> offsets, double support, std::span<const double> shares)
{
    std::vector<double> all(offsets.size(), 0);
    const WeightedNodes nodes = weigh(offsets, support, shares);
    const std::array<double, Monomials::count> moments = momentsOf(nodes);
    double rest = 1; // of the trust, for functions less exact but safer
    const auto take = [&](const Functions& functions, double share) {
        for (std::size_t i = 0; i < functions.size(); ++i)
            all[nodes.indices[i]] += share * functions[i];
        rest -= share;
    };

    const Factors exact(moments, 0);
    if (double trust = trustIn(exact.pivots); trust > 0) {
        const Functions functions = functionsAt(nodes, exact.solve());
        trust *= smoothStep(amplification(functions), poorAmplification, goodAmplification);
        take(functions, trust);
    }
    if (rest <= 0)
        return all;
    const Factors damped(moments, ridge);
    if (const double trust = trustIn(damped.pivots); trust > 0)
        take(functionsAt(nodes, damped.solve()), rest * trust);
    if (rest > 0)
        take(functionsAt(nodes, Basis::Unit(0) / moments[0]), rest);
    return all;
}

ShapeSlopes shapeSlopes(std::span<const Vec3> offsets, double support, std::span<const double> shares)
{
    ShapeSlopes all{.values = std::vector<double>(offsets.size(), 0),
                    .slopes = std::vector<Vec3>(offsets.size(), Vec3::Zero())};
    const WeightedNodes nodes = weigh(offsets, support, shares);
    const std::array<double, Monomials::count> moments = momentsOf(nodes);
    const auto take = [&](const Functions& functions, double share) {
        for (std::size_t i = 0; i < functions.size(); ++i)
            all.values[nodes.indices[i]] += share * functions[i];
    };

    const Factors exact(moments, 0);
    if (const double trust = trustIn(exact.pivots); trust > 0) {
        const Functions functions = functionsAt(nodes, exact.solve());
        all.trust = trust * smoothStep(amplification(functions), poorAmplification, goodAmplification);
        take(functions, all.trust);
        addSlopes(all, nodes, exact, support, all.trust);
    }
    if (all.trust < 1) {
        const Factors damped(moments, ridge);
        if (const double trust = (1 - all.trust) * trustIn(damped.pivots); trust > 0) {
            take(functionsAt(nodes, damped.solve()), trust);
            addSlopes(all, nodes, damped, support, trust);
            all.trust += trust;
        }
    }
    if (all.trust < 1)
        take(functionsAt(nodes, Basis::Unit(0) / moments[0]), 1 - all.trust);
    return all;
}

} // namespace knead
