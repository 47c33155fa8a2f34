#include "core/integration/shape_damping.h"

#include "core/integration/piece_momenta.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace knead {

namespace {

/// u of a piece: V + W x (x - center).
struct Motion {
    Vec3 velocity = Vec3::Zero();
    Vec3 spin = Vec3::Zero();
    Vec3 center = Vec3::Zero();
    double held = 0; ///< objects

    Vec3 at(const Vec3& place) const { return velocity + spin.cross(place - center); }
};

std::vector<Motion> motionsOf(const ObjectState& state, const Pieces& pieces)
{
    std::vector<Motion> motions(pieces.count);
    for (std::size_t i = 0; i < state.size(); ++i) {
        if (state.inverseMass[i] != 0)
            continue;
        Motion& motion = motions[pieces.ofObject[i]];
        motion.velocity += state.velocity.at(i);
        motion.held += 1;
    }
    const auto isFree = [](const Motion& motion) { return motion.held == 0; };
    const bool anyIsFree = std::ranges::any_of(motions, isFree);
    const std::vector<PieceMomenta> momenta =
        anyIsFree ? momentaOf(state, state.position, state.velocity, pieces) : std::vector<PieceMomenta>();
    for (std::size_t p = 0; p < motions.size(); ++p)
        if (isFree(motions[p]))
            motions[p] = {.velocity = momenta[p].linear / momenta[p].mass,
                          .spin = momenta[p].spinOf(momenta[p].angular),
                          .center = momenta[p].center};
        else
            motions[p].velocity /= motions[p].held;
    return motions;
}

} // namespace

double dampShape(ObjectState& state, double rate, double dt, const Pieces& pieces)
{
    const std::vector<Motion> motions = motionsOf(state, pieces);
    const double share = 1 - std::exp(-rate * dt);
    double lost = 0;
    for (std::size_t i = 0; i < state.size(); ++i) {
        if (state.inverseMass[i] == 0)
            continue;
        const Vec3 before = state.velocity.at(i);
        const Vec3 after = before + share * (motions[pieces.ofObject[i]].at(state.position.at(i)) - before);
        lost += 0.5 * state.mass[i] * (before.squaredNorm() - after.squaredNorm());
        state.velocity.set(i, after);
    }
    return lost;
}

} // namespace knead
