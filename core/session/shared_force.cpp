#include "core/session/shared_force.h"

#include "core/mechanics/vector_array.h"
#include "core/vicinity/point_grid.h"

#include <Eigen/Dense>

namespace knead {

namespace {

constexpr std::size_t mostNodes = 8;
constexpr double largestWeight = 2;
constexpr double leastShare = 1e-3; // of the squared way to the farthest node: weights of one that is hit stay finite
constexpr double flatShare = 1e-9;  // of the largest spread: nodes in a plane say nothing about what is across it

/// Of some nodes for a place.
/// @param ways from the place to each [m]
Eigen::VectorXd weightsOf(const Eigen::Matrix3Xd& ways)
{
    const Eigen::VectorXd squares = ways.colwise().squaredNorm();
    const double least = leastShare * squares.maxCoeff();
    if (!(least > 0))
        return Eigen::VectorXd::Constant(squares.size(), 1.0 / static_cast<double>(squares.size()));
    Eigen::VectorXd near = (squares.array() + least).inverse();
    near /= near.sum();
    // w = v (1 + c.(way - m)) with m = sum v way: their sum stays 1, and sum w way = 0 where c = -C^-1 m, C the spread about m.
    const Vec3 mean = ways * near;
    const Eigen::Matrix3Xd spread = ways.colwise() - mean;
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(Mat3(spread * near.asDiagonal() * spread.transpose()));
    const double flattest = flatShare * solver.eigenvalues()[2];
    const Vec3 inverse =
        solver.eigenvalues().unaryExpr([&](double value) { return value > flattest ? 1 / value : 0.0; });
    const Vec3 slope = -solver.eigenvectors() * (inverse.asDiagonal() * (solver.eigenvectors().transpose() * mean));
    const Eigen::VectorXd weights = near.array() * (1 + (spread.transpose() * slope).array());
    return weights.cwiseAbs().maxCoeff() <= largestWeight ? weights : near;
}

} // namespace

std::vector<Vec3> sharedForces(std::span<const PlacedForce> forces, std::span<const Vec3> nodes, double spacing)
{
    std::vector<Vec3> shared(nodes.size(), Vec3::Zero());
    if (nodes.empty() || forces.empty())
        return shared;
    const VectorArray places(nodes);
    const PointGrid grid(places, spacing);
    std::vector<PointGrid::Found> found;
    for (const auto& [place, force] : forces) {
        grid.nearest(place, mostNodes, found);
        Eigen::Matrix3Xd ways(3, static_cast<Eigen::Index>(found.size()));
        for (std::size_t i = 0; i < found.size(); ++i)
            ways.col(static_cast<Eigen::Index>(i)) = nodes[found[i].point] - place;
        const Eigen::VectorXd weights = weightsOf(ways);
        for (std::size_t i = 0; i < found.size(); ++i)
            shared[found[i].point] += weights[static_cast<Eigen::Index>(i)] * force;
    }
    return shared;
}

} // namespace knead
