#include "core/deformation/patch_detail.h"

#include <Eigen/Core>

#include <cmath>

namespace knead {

namespace {

constexpr double nugget = 1e-6; // of a source's own value: nodes that nearly coincide may differ

// Matrices of some thirty rows, by the million: products are written so that a compiler makes one loop of each, and what an
// Eigen::LLT of any size would take to begin is left out.

using Columns = Eigen::Matrix<double, Eigen::Dynamic, 3>;
using TermColumns = Eigen::Matrix<double, Eigen::Dynamic, 10>;
using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// C = Terms diag(1 / hold) Terms' + Wendland of nodes at rows of `at`: its lower half.
Eigen::MatrixXd covarianceOf(const Columns& at, const TermColumns& terms, const QuadraticPatch::Terms& freedom)
{
    constexpr double perReach = 1 / static_cast<double>(patchDetailReach);
    const Eigen::Index count = at.rows();
    Eigen::MatrixXd covariance(count, count);
    Eigen::ArrayXd r(count);
    for (Eigen::Index j = 0; j < count; ++j) {
        const Eigen::Index rest = count - j;
        auto from = r.tail(rest);
        from = (at.col(0).tail(rest).array() - at(j, 0)).square() + (at.col(1).tail(rest).array() - at(j, 1)).square() +
               (at.col(2).tail(rest).array() - at(j, 2)).square();
        from = (perReach * from.sqrt()).min(1.0);
        const QuadraticPatch::Terms weights = freedom.cwiseProduct(terms.row(j).transpose());
        covariance.col(j).tail(rest) =
            ((1 - from).square().square() * (4 * from + 1)).matrix() + terms.bottomRows(rest).lazyProduct(weights);
        covariance(j, j) += nugget;
    }
    return covariance;
}

/// L of C = L L', in place of the lower half of C.
void factorize(Eigen::MatrixXd& c)
{
    Eigen::VectorXd weights(c.rows());
    for (Eigen::Index j = 0; j < c.cols(); ++j) {
        const Eigen::Index rest = c.rows() - j;
        weights.head(j) = c.row(j).head(j).transpose();
        auto column = c.col(j).tail(rest);
        column -= c.block(j, 0, rest, j).lazyProduct(weights.head(j));
        column /= std::sqrt(column[0]);
    }
}

/// C^-1 values, by L.
void solve(const Eigen::MatrixXd& lower, Columns& values)
{
    const Eigen::Index count = lower.rows();
    for (Eigen::Index k = 0; k < count; ++k) {
        values.row(k) /= lower(k, k);
        const Eigen::Index rest = count - k - 1;
        for (Eigen::Index axis = 0; axis < 3; ++axis)
            values.col(axis).tail(rest) -= values(k, axis) * lower.col(k).tail(rest);
    }
    for (Eigen::Index k = count - 1; k >= 0; --k) {
        const Eigen::Index rest = count - k - 1;
        for (Eigen::Index axis = 0; axis < 3; ++axis)
            values(k, axis) =
                (values(k, axis) - lower.col(k).tail(rest).dot(values.col(axis).tail(rest))) / lower(k, k);
    }
}

/// (C^-1)_ii, by L: the squared lengths of the columns of L^-1, of which nothing else is needed.
Eigen::RowVectorXd inverseDiagonal(const Eigen::MatrixXd& lower)
{
    const Eigen::Index count = lower.rows();
    Rows inverse = Rows::Zero(count, count);
    Eigen::RowVectorXd weights(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const double scale = 1 / lower(i, i);
        weights.head(i) = -scale * lower.row(i).head(i);
        inverse.row(i).head(i) = weights.head(i).lazyProduct(inverse.topLeftCorner(i, i));
        inverse(i, i) = scale;
    }
    return inverse.colwise().squaredNorm();
}

} // namespace

/// The mean of a Gaussian process of covariance C. The error at a node that is left out is (C^-1 d)_i / (C^-1)_ii (Rippa 1999).
DetailedPatch fitThrough(const DisplacementField& field, std::span<const std::uint32_t> nodes,
                         const QuadraticPatch& prior, const PatchHold& hold)
{
    const auto count = static_cast<Eigen::Index>(nodes.size());
    Columns at(count, 3);
    TermColumns terms(count, 10);
    Columns values(count, 3); // displacements beyond the prior, then C^-1 of these
    for (Eigen::Index i = 0; i < count; ++i) {
        const std::uint32_t node = nodes[static_cast<std::size_t>(i)];
        const Vec3 t = prior.within(field.nodes[node]);
        at.row(i) = t.transpose();
        terms.row(i) = QuadraticPatch::termsAt(t).transpose();
        values.row(i) = (field.displacements[node] - prior.at(t)).transpose();
    }
    const QuadraticPatch::Terms freedom = perTerm(hold).cwiseInverse();
    Eigen::MatrixXd lower = covarianceOf(at, terms, freedom);
    factorize(lower);
    solve(lower, values);
    const Eigen::RowVectorXd inverse = inverseDiagonal(lower);

    DetailedPatch detailed{prior, {}, 0};
    detailed.sources.reserve(nodes.size());
    detailed.patch.coefficients += (freedom.asDiagonal() * (terms.transpose() * values)).transpose();
    double squares = 0;
    double weights = 0;
    for (Eigen::Index i = 0; i < count; ++i) {
        const Vec3 t = at.row(i).transpose();
        const double middle = fitWeight(t);
        squares += middle * values.row(i).squaredNorm() / (inverse[i] * inverse[i]);
        weights += middle;
        detailed.sources.push_back({t.cast<float>(), values.row(i).transpose().cast<float>()});
    }
    detailed.expectedError = weights > 0 ? std::sqrt(squares / weights) : 0;
    return detailed;
}

} // namespace knead
