#include "core/integration/piece_momenta.h"

#include <Eigen/Dense>

namespace knead {

namespace {

// Of the largest principal inertia: below it objects lie on a line, and what is left is rounding.
constexpr double leastInertiaShare = 1e-6;

} // namespace

bool PieceMomenta::canTurn() const
{
    if (objects < 3)
        return false;
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(inertia, Eigen::EigenvaluesOnly);
    return solver.eigenvalues()[0] > leastInertiaShare * solver.eigenvalues()[2];
}

Vec3 PieceMomenta::spinOf(const Vec3& angularMomentum) const
{
    if (objects < 2)
        return Vec3::Zero();
    if (canTurn())
        return inertia.ldlt().solve(angularMomentum);
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(inertia);
    Vec3 spin = Vec3::Zero();
    for (int axis = 0; axis < 3; ++axis)
        if (const double own = solver.eigenvalues()[axis]; own > leastInertiaShare * solver.eigenvalues()[2])
            spin += solver.eigenvectors().col(axis).dot(angularMomentum) / own * solver.eigenvectors().col(axis);
    return spin;
}

std::vector<PieceMomenta> momentaOf(const ObjectState& state, const VectorArray& position, const VectorArray& velocity,
                                    const Pieces& pieces)
{
    std::vector<PieceMomenta> momenta(pieces.count);
    const LaneVector<double>& weighed = state.weighedMass();
    for (std::size_t i = 0; i < state.size(); ++i) {
        PieceMomenta& piece = momenta[pieces.ofObject[i]];
        ++piece.objects;
        piece.mass += state.mass[i];
        piece.weighed += weighed[i];
        piece.center += state.mass[i] * position.at(i);
        piece.linear += state.mass[i] * velocity.at(i);
    }
    for (PieceMomenta& piece : momenta)
        piece.center /= piece.mass;
    for (std::size_t i = 0; i < state.size(); ++i) {
        PieceMomenta& piece = momenta[pieces.ofObject[i]];
        const Vec3 arm = position.at(i) - piece.center;
        piece.angular += state.mass[i] * arm.cross(velocity.at(i));
        piece.inertia += state.mass[i] * (arm.squaredNorm() * Mat3::Identity() - arm * arm.transpose());
    }
    return momenta;
}

} // namespace knead
