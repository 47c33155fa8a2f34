// What goes wrong is found, named and undone.
#include "core/geometry/disjoint_sets.h"
#include "core/integration/solver_settings.h"
#include "core/message/number_text.h"
#include "core/simulation/simulation_state.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace knead {

namespace {

// The state is kept for going back this often [steps]; copying it costs about a step. Unlike with KeepMoment the run does not
// go on from the copy, which would cost ten more.
constexpr std::uint64_t checkpointInterval = 256;
constexpr std::uint64_t implicitCheckpointInterval = 8; // the same in frames
// A chosen time step may be this much above the largest stable one: that is bounded from above, not known.
constexpr double stableStepTolerance = 1.25;

} // namespace

void Simulation::State::stop(const Message& cause, Trouble trouble)
{
    const Message message = Message("Run", "The simulation was stopped at %1 s: %2 It went back to %3 s.")
                                .with(inDigits(steps.time), cause, inDigits(lastGood->steps.time));
    const std::uint64_t reached = steps.count;
    restore(*lastGood);
    steps.count = reached; // steps are what commands are counted by: what comes now comes after this one
    watch.health = {false, message, trouble};
}

/// Two looks in a row must agree, since a sharp tool may turn a spot inside out for a moment.
Message Simulation::State::squashedBody()
{
    Message name;
    for (std::size_t b = 0; b < bodies.size(); ++b)
        if (runs[b]->deforms() && runs[b]->connections.countInverted(runs[b]->state) > 0)
            name =
                bodies[b].name.empty() ? Message("Run", "the body") : Message::verbatim("\"" + bodies[b].name + "\"");
    const bool again = watch.wasSquashed;
    watch.wasSquashed = !name.empty();
    return again ? name : Message();
}

/// Once in a while: what costs about a step to see. @return what was found wrong, with a cause
std::pair<Trouble, Message> Simulation::State::lookClosely()
{
    out.penetration = std::max(out.penetration, deepestOverlap());
    if (const Message name = squashedBody(); !name.empty())
        return {
            Trouble::squashed,
            Message("Run",
                    "material of %1 was squashed flat or turned inside out. Press less far, raise Poisson's ratio or "
                    "the yield stress, or fill the part with a smaller spacing, then reset.")
                .with(name)};
    if (Message cause = energyCause(); !cause.empty())
        return {Trouble::energy, std::move(cause)};
    if (!watch.wasSquashed && !travel.wasOverdrawn)
        lastGood = std::make_shared<const Moment>(moment());
    return {Trouble::none, {}};
}

std::pair<Trouble, Message> Simulation::State::findTrouble()
{
    if (!std::isfinite(travel.largest / steps.last))
        return {Trouble::notANumber,
                Message("Run", "a position is no longer a number. %1 or make the material softer, then reset.")
                    .with(remedy())};
    if (Message cause = runawayCause(); !cause.empty())
        return {Trouble::runaway, std::move(cause)};
    if (Message cause = unsolvedCause(); !cause.empty())
        return {Trouble::unsolved, std::move(cause)};
    if (steps.count % (isImplicit() ? implicitCheckpointInterval : checkpointInterval) == 0)
        return lookClosely();
    return {Trouble::none, {}};
}

/// The longest step that is stable with as many contacts on an object as there are. More of them count at once; fewer, when
/// there were no more since the last look.
void Simulation::State::findTimeStep()
{
    travel.recentCrowding = std::max(travel.recentCrowding, contactReport.crowding);
    const bool isCrowded = contactReport.crowding > steps.crowding;
    const bool isDue = steps.count % solverSettings.explicitSteps.timeStepInterval == 0;
    if (isCrowded)
        steps.crowding = solverSettings.explicitSteps.crowdingReserve * contactReport.crowding;
    else if (isDue)
        steps.crowding = std::min(steps.crowding,
                                  std::max(1.0, solverSettings.explicitSteps.crowdingReserve * travel.recentCrowding));
    if (isDue)
        travel.recentCrowding = 0;
    if (isCrowded || isDue)
        contacts->setFrequency(boundTimeStep());
}

void Simulation::State::checkHealth()
{
    travel.fastestDriven = std::max(travel.fastestDriven, travel.ofSurfaces / steps.last);
    for (const auto& fixture : grips.fixtures)
        if (fixture)
            travel.fastestDriven = std::max(travel.fastestDriven, fixture->velocity.norm());
    auto [trouble, cause] = findTrouble();
    if (cause.empty() && !isImplicit()) {
        findTimeStep();
        if (chosen.timeStep && *chosen.timeStep > stableStepTolerance * steps.stable) {
            trouble = Trouble::longStep;
            cause = Message("Run",
                            "the chosen time step of %1 s is longer than the stable one of %2 s. Choose a shorter one, "
                            "or a softer or more damped material.")
                        .with(inDigits(*chosen.timeStep), inDigits(steps.stable));
        }
    }
    if (!cause.empty())
        stop(cause, trouble);
}

const Pieces& Simulation::State::piecesOf(BodyId body)
{
    return runs[body]->pieces.find(runs[body]->connections, body, contacts->joints());
}

std::size_t Simulation::State::components()
{
    std::uint64_t version = contacts->joints().version();
    for (std::size_t b = 0; b < runs.size(); ++b)
        version = 31 * version + runs[b]->connections.changes().broken.size() * 2 + (runs[b]->deforms() ? 0 : 1);
    if (version == cracks.version)
        return cracks.components;
    std::vector<std::size_t> first{0};
    for (const auto& run : runs)
        first.push_back(first.back() + run->state.size());
    DisjointSets sets(first.back());
    for (std::size_t b = 0; b < runs.size(); ++b) {
        if (runs[b]->deforms())
            runs[b]->connections.forEachConnection(
                [&](ObjectIndex lower, ObjectIndex upper) { sets.join(first[b] + lower, first[b] + upper); });
        else
            for (ObjectIndex i = 0; i < runs[b]->state.size(); ++i)
                sets.join(first[b] + i, first[b]);
    }
    for (const Joint& joint : contacts->joints().all())
        sets.join(first[joint.first.body] + joint.first.object, first[joint.second.body] + joint.second.object);
    cracks.version = version;
    cracks.components = sets.count();
    return cracks.components;
}

} // namespace knead
