// When nothing has moved for a while, steps are not computed until something may.
#include "core/simulation/simulation_state.h"
#include "core/simulation/smallest_spacing.h"
#include "core/task/block_sums.h"

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

constexpr double watchTime = 0.5;   // [s]
constexpr double restTravel = 5e-4; // what has gone less far meanwhile is at rest [spacings]
constexpr double restTurn = 1e-5;   // the same of tools' turns [rad]
constexpr double restFlow = 1e-6;   // energy that flow may take meanwhile, by what there is to go round

double farthest(const VectorArray& from, const VectorArray& to)
{
    constexpr std::size_t blockSize = 4096;
    const std::vector<double> squares =
        ofEachBlock<double>(from.size(), blockSize, [&](std::size_t begin, std::size_t end) {
            double most = 0;
            for (std::size_t i = begin; i < end; ++i)
                most = std::max(most, (to.at(i) - from.at(i)).squaredNorm());
            return most;
        });
    return squares.empty() ? 0 : std::sqrt(*std::max_element(squares.begin(), squares.end()));
}

} // namespace

/// Where the hands of all tools want them next.
std::vector<Pose> Simulation::State::wantedPoses() const
{
    std::vector<Pose> wanted;
    for (const auto& tool : tools)
        wanted.push_back(tool ? wantedPose(*tool, steps.length) : Pose{});
    return wanted;
}

/// Whether something moves the bodies otherwise than when the watch began.
bool Simulation::State::isDriven() const
{
    const double near = restTravel * smallestSpacing(bodies);
    const bool gripsMove = std::any_of(grips.fixtures.begin(), grips.fixtures.end(), [](const auto& fixture) {
        return fixture && (!fixture->velocity.isZero(0) || fixture->turn.turns());
    });
    if (gripsMove || !annealings.empty() || loads.isRising(steps.time) || contacts->isWaiting())
        return true;
    const std::vector<Pose> wanted = wantedPoses();
    return !std::equal(wanted.begin(), wanted.end(), rest.wanted.begin(), rest.wanted.end(),
                       [&](const Pose& now, const Pose& before) {
                           return (now.position - before.position).norm() <= near &&
                                  now.rotation.angularDistance(before.rotation) <= restTurn;
                       });
}

/// After an implicit step: whether all has come to rest.
void Simulation::State::watchRest()
{
    if (rest.isWatching && isDriven())
        rest.disturb();
    if (!rest.isWatching) {
        rest.isWatching = true;
        rest.begin = steps.time;
        rest.places.resize(runs.size());
        for (std::size_t b = 0; b < runs.size(); ++b)
            rest.places[b] = runs[b]->state.position;
        rest.wanted = wantedPoses();
        rest.flowed = accounts.energy.plastic;
    }
    if (steps.time < rest.begin + watchTime)
        return;
    rest.isWatching = false;
    if (accounts.energy.plastic - rest.flowed > restFlow * accounts.energy.turnover)
        return;
    for (std::size_t b = 0; b < runs.size(); ++b)
        if (farthest(rest.places[b], runs[b]->state.position) > restTravel * bodies[b].aggregate->lattice.spacing)
            return;
    for (auto& run : runs) {
        if (run->rigid)
            run->rigid->moveWith(run->state, Vec3::Zero(), Vec3::Zero(), 0);
        run->state.velocity.setZero();
    }
    rest.rests = true;
    ++rest.count;
}

/// A step in which nothing moves. @return false where something does after all, and nothing was done
bool Simulation::State::stepAtRest()
{
    if (!rest.rests)
        return false;
    if (isDriven()) {
        rest.disturb();
        return false;
    }
    anneal(); // what has flowed goes on healing
    for (auto& tool : tools) {
        if (!tool)
            continue;
        tool->forceSum += tool->force;
        tool->torqueSum += tool->torque;
        ++tool->stepsInSum;
    }
    scheme.iterations = 0;
    steps.length = steps.last = travel.lastKick = frameStep();
    steps.time += steps.length;
    ++steps.count;
    return true;
}

} // namespace knead
