#include "core/deformation/patch_fit.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

constexpr std::size_t patchTerms = 10;
constexpr double leastFreedom = 0.05; // of a node against the fit: less is rounding, and its error would be anything

using Square = Eigen::Matrix<double, patchTerms, patchTerms>;
using Right = Eigen::Matrix<double, patchTerms, 3>;

/// Nodes as a fit sees them.
struct SeenNode {
    QuadraticPatch::Terms terms;
    Vec3 off;          ///< displacement beyond the prior
    double weight = 0; ///< g
    double middle = 0; ///< fitWeight(t)
};

/// The normal equations.
struct NormalEquations {
    Square square = Square::Zero();
    Right right = Right::Zero();
    double weight = 0;

    void add(const SeenNode& node)
    {
        const QuadraticPatch::Terms weighted = node.weight * node.terms;
        for (Eigen::Index column = 0; column < square.cols(); ++column)
            square.col(column) += weighted[column] * node.terms;
        for (Eigen::Index axis = 0; axis < 3; ++axis)
            right.col(axis) += node.off[axis] * weighted;
        weight += node.weight;
    }
};

} // namespace

/// Of a node that is left out, linear algebra says by how much the fit without it is off: r / (1 - h), where h is the share
/// that the node has in its own value (PRESS, Allen 1974).
PatchFit fitPatch(const DisplacementField& field, std::span<const std::uint32_t> nodes, const QuadraticPatch& prior,
                  double reach, const PatchHold& hold)
{
    NormalEquations equations;
    std::vector<SeenNode> seen(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const Vec3 t = prior.within(field.nodes[nodes[i]]);
        seen[i] = {QuadraticPatch::termsAt(t), field.displacements[nodes[i]] - prior.at(t), fitWeight(t / reach),
                   fitWeight(t)};
        equations.add(seen[i]);
    }
    PatchFit fit{prior, std::vector<float>(nodes.size())};
    if (!(equations.weight > 0))
        return fit;
    equations.square.diagonal() += equations.weight * perTerm(hold);
    const Eigen::LLT<Square> cholesky(equations.square);
    const QuadraticPatch::Coefficients change = cholesky.solve(equations.right).transpose();
    fit.patch.coefficients += change;
    const Square inverse = cholesky.matrixL().solve(Square::Identity()); // quicker than to solve for each node
    double squares = 0;
    double weights = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const double share = seen[i].weight * (inverse * seen[i].terms).squaredNorm();
        const double error = (seen[i].off - change * seen[i].terms).norm() / std::max(leastFreedom, 1 - share);
        fit.errors[i] = static_cast<float>(error);
        squares += seen[i].middle * error * error;
        weights += seen[i].middle;
    }
    fit.expectedError = weights > 0 ? std::sqrt(squares / weights) : 0;
    return fit;
}

} // namespace knead
