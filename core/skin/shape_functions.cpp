#include "core/skin/shape_functions.h"

#include <Eigen/Cholesky>

#include <cmath>
#include <optional>

namespace knead {

namespace {

constexpr double smallestPivot = 1e-6;      // of the moment matrix scaled to a unit diagonal
constexpr double largestAmplification = 12; // of errors in node values, sum of |phi|; 1.7 at most surfaces
constexpr double widening = 1.35;           // of the support at sharp corners, where too few nodes are near

double wendland(double r)
{
    if (r >= 1)
        return 0;
    const double rest = (1 - r) * (1 - r);
    return rest * rest * (4 * r + 1);
}

template <int size>
using Basis = Eigen::Matrix<double, size, 1>;

template <int size>
Basis<size> basisAt(const Vec3& x)
{
    Basis<size> basis;
    basis[0] = 1;
    if constexpr (size >= 4)
        basis.template segment<3>(1) = x;
    if constexpr (size >= 10)
        basis.template segment<6>(4) << x.x() * x.x(), x.y() * x.y(), x.z() * x.z(), x.x() * x.y(), x.y() * x.z(),
            x.z() * x.x();
    return basis;
}

/// Nodes in units of the support, with their weights.
struct WeightedNodes {
    std::vector<Vec3> places;
    std::vector<double> weights;
};

WeightedNodes weigh(std::span<const Vec3> offsets, double support)
{
    WeightedNodes nodes{{offsets.begin(), offsets.end()}, std::vector<double>(offsets.size())};
    for (std::size_t i = 0; i < offsets.size(); ++i) {
        nodes.places[i] /= support;
        nodes.weights[i] = wendland(nodes.places[i].norm());
    }
    return nodes;
}

/// phi_i = w_i p(x_i)^T M^-1 p(0) with M = sum_i w_i p(x_i) p(x_i)^T; nothing when M is close to singular.
template <int size>
std::optional<std::vector<double>> solve(const WeightedNodes& nodes)
{
    const auto& [places, weights] = nodes;
    Eigen::Matrix<double, size, size> moments = Eigen::Matrix<double, size, size>::Zero();
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (weights[i] == 0)
            continue;
        const Basis<size> basis = basisAt<size>(places[i]);
        moments.noalias() += (weights[i] * basis) * basis.transpose();
    }
    const Basis<size> diagonal = moments.diagonal();
    if (diagonal.minCoeff() <= 0)
        return std::nullopt;
    const Basis<size> scale = diagonal.cwiseSqrt().cwiseInverse();
    const Eigen::LDLT<Eigen::Matrix<double, size, size>> factors(scale.asDiagonal() * moments * scale.asDiagonal());
    if (factors.vectorD().minCoeff() < smallestPivot)
        return std::nullopt;
    const Basis<size> solution = scale.cwiseProduct(factors.solve(scale[0] * Basis<size>::Unit(0)));
    std::vector<double> functions(places.size(), 0);
    for (std::size_t i = 0; i < places.size(); ++i)
        if (weights[i] > 0)
            functions[i] = weights[i] * basisAt<size>(places[i]).dot(solution);
    return functions;
}

double amplification(const std::vector<double>& functions)
{
    double sum = 0;
    for (const double function : functions)
        sum += std::abs(function);
    return sum;
}

std::optional<std::vector<double>> solveQuadratic(const WeightedNodes& nodes)
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
    if (auto functions = solveQuadratic(near))
        return *std::move(functions);
    if (auto functions = solveQuadratic(weigh(offsets, widening * support)))
        return *std::move(functions);
    if (auto functions = solve<4>(near))
        return *std::move(functions);
    return *solve<1>(near);
}

} // namespace knead
