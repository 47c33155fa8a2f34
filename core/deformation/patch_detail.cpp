#include "core/deformation/patch_detail.h"

#include <Eigen/Cholesky>

#include <cmath>

namespace knead {

namespace {

constexpr double nugget = 1e-6; // of a source's own value: nodes that nearly coincide may differ

double wendland(double r)
{
    const double rest = std::max(1 - r, 0.0);
    return rest * rest * rest * rest * (4 * r + 1);
}

} // namespace

/// The mean of a Gaussian process of covariance C = Terms' diag(1 / hold) Terms + Wendland. The error at a node that is left out is
/// (C^-1 d)_i / (C^-1)_ii (Rippa 1999).
DetailedPatch fitThrough(const DisplacementField& field, std::span<const std::uint32_t> nodes,
                         const QuadraticPatch& prior, const PatchHold& hold)
{
    const auto count = static_cast<Eigen::Index>(nodes.size());
    Eigen::Matrix<double, 10, Eigen::Dynamic> terms(10, count);
    Eigen::MatrixXd off(count, 3);
    std::vector<Vec3> at(nodes.size());
    for (Eigen::Index i = 0; i < count; ++i) {
        const std::uint32_t node = nodes[static_cast<std::size_t>(i)];
        const Vec3 t = prior.within(field.nodes[node]);
        at[static_cast<std::size_t>(i)] = t;
        terms.col(i) = QuadraticPatch::termsAt(t);
        off.row(i) = (field.displacements[node] - prior.at(t)).transpose();
    }
    const QuadraticPatch::Terms freedom = perTerm(hold).cwiseInverse();
    Eigen::MatrixXd covariance = terms.transpose() * freedom.asDiagonal() * terms;
    for (Eigen::Index i = 0; i < count; ++i)
        for (Eigen::Index j = 0; j < count; ++j)
            covariance(i, j) +=
                i == j ? 1 + nugget
                       : wendland((at[static_cast<std::size_t>(i)] - at[static_cast<std::size_t>(j)]).norm() /
                                  patchDetailReach);
    const Eigen::LLT<Eigen::MatrixXd> cholesky(covariance);
    const Eigen::MatrixXd inverse = cholesky.solve(Eigen::MatrixXd::Identity(count, count));
    const Eigen::MatrixXd values = cholesky.solve(off);

    DetailedPatch detailed{prior, {}, 0};
    detailed.patch.coefficients += (freedom.asDiagonal() * (terms * values)).transpose();
    double squares = 0;
    double weights = 0;
    for (Eigen::Index i = 0; i < count; ++i) {
        const double middle = fitWeight(at[static_cast<std::size_t>(i)]);
        squares += middle * values.row(i).squaredNorm() / (inverse(i, i) * inverse(i, i));
        weights += middle;
        detailed.sources.push_back(
            {at[static_cast<std::size_t>(i)].cast<float>(), values.row(i).transpose().cast<float>()});
    }
    detailed.expectedError = weights > 0 ? std::sqrt(squares / weights) : 0;
    return detailed;
}

} // namespace knead
