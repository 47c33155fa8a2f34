#include "core/skin/shape_functions.h"

#include "core/kernels/kernels.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>

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
constexpr std::array<std::array<std::uint8_t, 3>, basisSize> basisPowers{
    {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {1, 1, 0}, {0, 1, 1}, {1, 0, 1}}};

/// The monomials that entries of the moment matrix are sums of: 35 for 100.
constexpr auto monomialOf = [] {
    std::array<std::array<std::uint8_t, basisSize>, basisSize> found{};
    for (std::size_t i = 0; i < basisSize; ++i)
        for (std::size_t j = 0; j < basisSize; ++j)
            found[i][j] =
                kernels::fitMonomials.find(basisPowers[i][0] + basisPowers[j][0], basisPowers[i][1] + basisPowers[j][1],
                                           basisPowers[i][2] + basisPowers[j][2]);
    return found;
}();

using Moments = double[kernels::FitMonomials::count];

using Basis = Eigen::Matrix<double, basisSize, 1>;
using Square = Eigen::Matrix<double, basisSize, basisSize>;

/// M = sum_i w_i p(x_i) p(x_i)^T, scaled to a unit diagonal, as L D L^T. Pivots are taken in the order of the basis: what they are
/// changes as smoothly as M does.
struct Factors {
    Basis scale = Basis::Zero();
    Square lower = Square::Zero(); ///< L below the diagonal
    Basis pivots = Basis::Zero();  ///< D; zero from where M is singular

    /// @param damping added to the diagonal for the quadratic functions
    Factors(const Moments& moments, double damping)
    {
        Square rest;
        for (Eigen::Index i = 0; i < rest.rows(); ++i)
            for (Eigen::Index j = 0; j < rest.cols(); ++j)
                rest(i, j) = moments[monomialOf[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]];
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
        trust *= pivot >= goodPivot ? 1
                 : pivot > 0        ? smoothStep(std::log(pivot), std::log(poorPivot), std::log(goodPivot))
                                    : 0;
    return trust;
}

/// Nodes with the weights that a support gives them, and polynomials that are fitted to them.
class Fit {
public:
    Fit(const kernels::FitNodes& nodes, double support)
        : m_kernels(kernels::best())
        , m_nodes(nodes)
        , m_support(support)
        , m_weight(nodes.count)
        , m_values(nodes.count)
    {
        m_kernels.moments(nodes, support, m_weight.data(), moments);
        assert(moments[0] > 0);
    }

    /// Values of a polynomial times the weights, per node.
    std::span<const double> functions(const Basis& coefficients)
    {
        double c[basisSize];
        Eigen::Map<Basis>{c} = coefficients;
        m_amplification = m_kernels.functions(m_nodes, m_support, m_weight.data(), c, m_values.data());
        return m_values;
    }
    /// Constants: weights that sum to 1.
    std::span<const double> constants() { return functions(Basis::Unit(0) / moments[0]); }

    double amplification() const { return m_amplification; } ///< sum of the absolute values of the last ones

    Moments moments;

private:
    const kernels::Kernels& m_kernels;
    const kernels::FitNodes& m_nodes;
    double m_support;
    std::vector<double> m_weight;
    std::vector<double> m_values;
    double m_amplification = 0;
};

void add(std::span<double> all, std::span<const double> functions, double share)
{
    for (std::size_t i = 0; i < all.size(); ++i)
        all[i] += share * functions[i];
}

/// Adds what each node contributes to the slopes of a fit.
void addSlopes(ShapeSlopes& all, Fit& fit, const Factors& factors, double support, double share)
{
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const std::span<const double> functions = fit.functions(factors.solve(1 + axis));
        for (std::size_t i = 0; i < functions.size(); ++i)
            all.slopes[i][axis] += share / support * functions[i];
    }
}

} // namespace

void shapeFunctions(const kernels::FitNodes& nodes, double support, std::span<double> functions)
{
    Fit fit(nodes, support);
    std::ranges::fill(functions, 0);
    double rest = 1; // of the trust, for functions less exact but safer
    const auto take = [&](std::span<const double> values, double share) {
        add(functions, values, share);
        rest -= share;
    };

    const Factors exact(fit.moments, 0);
    if (const double trust = trustIn(exact.pivots); trust > 0) {
        const std::span<const double> values = fit.functions(exact.solve());
        take(values, trust * smoothStep(fit.amplification(), poorAmplification, goodAmplification));
    }
    if (rest <= 0)
        return;
    const Factors damped(fit.moments, ridge);
    if (const double trust = trustIn(damped.pivots); trust > 0)
        take(fit.functions(damped.solve()), rest * trust);
    if (rest > 0)
        take(fit.constants(), rest);
}

std::vector<double> shapeFunctions(std::span<const Vec3> offsets, double support)
{
    const std::size_t count = kernels::inFitLanes(offsets.size());
    std::array<std::vector<double>, 3> place;
    for (std::size_t c = 0; c < 3; ++c) {
        place[c].resize(count, 0);
        for (std::size_t i = 0; i < offsets.size(); ++i)
            place[c][i] = offsets[i][static_cast<Eigen::Index>(c)];
    }
    std::vector<double> distance(count, 0);
    std::vector<double> share(count, 0);
    for (std::size_t i = 0; i < offsets.size(); ++i) {
        distance[i] = offsets[i].norm();
        share[i] = 1;
    }
    std::vector<double> functions(count);
    shapeFunctions({{place[0].data(), place[1].data(), place[2].data()}, distance.data(), share.data(), count}, support,
                   functions);
    functions.resize(offsets.size());
    return functions;
}

ShapeSlopes shapeSlopes(const kernels::FitNodes& nodes, double support)
{
    ShapeSlopes all{.values = std::vector<double>(nodes.count, 0),
                    .slopes = std::vector<Vec3>(nodes.count, Vec3::Zero())};
    Fit fit(nodes, support);
    const Factors exact(fit.moments, 0);
    if (const double trust = trustIn(exact.pivots); trust > 0) {
        const std::span<const double> values = fit.functions(exact.solve());
        all.trust = trust * smoothStep(fit.amplification(), poorAmplification, goodAmplification);
        add(all.values, values, all.trust);
        addSlopes(all, fit, exact, support, all.trust);
    }
    if (all.trust < 1) {
        const Factors damped(fit.moments, ridge);
        if (const double trust = (1 - all.trust) * trustIn(damped.pivots); trust > 0) {
            add(all.values, fit.functions(damped.solve()), trust);
            addSlopes(all, fit, damped, support, trust);
            all.trust += trust;
        }
    }
    if (all.trust < 1)
        add(all.values, fit.constants(), 1 - all.trust);
    return all;
}

} // namespace knead
