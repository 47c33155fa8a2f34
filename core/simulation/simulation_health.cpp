// What goes wrong is found, named and undone.
#include "core/geometry/disjoint_sets.h"
#include "core/integration/time_step.h"
#include "core/simulation/simulation_state.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace knead {

namespace {

// The state is kept for going back this often [steps]; copying it costs about a step. Unlike with KeepMoment the run does not
// go on from the copy, which would cost ten more.
constexpr std::uint64_t checkpointInterval = 256;
constexpr std::uint64_t implicitCheckpointInterval = 8; // the same in frames
// The stable step depends on the shape, so it is found again this often [steps].
constexpr std::uint64_t timeStepInterval = 256;
// A speed of objects that no sensible motion reaches: this many times the speed of sound, plus free fall from far up [m/s].
constexpr double runawaySoundSpeeds = 20;
constexpr double runawaySpeed = 30;
// With more contacts on an object at a time than the time step allows for, the step is found again with some to spare.
constexpr double crowdingReserve = 1.5;
// A chosen time step may be this much above the largest stable one: that is bounded from above, not known.
constexpr double stableStepTolerance = 1.25;

} // namespace

void Simulation::State::stop(const std::string& cause, Trouble trouble)
{
    std::ostringstream text;
    text << "The simulation was stopped at " << time << " s: " << cause << " It went back to " << lastGood->time
         << " s.";
    const std::uint64_t reached = step;
    restore(*lastGood);
    step = reached; // steps are what commands are counted by: what comes now comes after this one
    health = {false, text.str(), trouble};
}

/// Two looks in a row must agree, since a sharp tool may turn a spot inside out for a moment.
std::string Simulation::State::squashedBody()
{
    std::string name;
    for (std::size_t b = 0; b < bodies.size(); ++b)
        if (runs[b]->deforms() && runs[b]->connections.countInverted(runs[b]->state) > 0)
            name = bodies[b].name.empty() ? "the body" : "\"" + bodies[b].name + "\"";
    const bool again = wasSquashed;
    wasSquashed = !name.empty();
    return again ? name : "";
}

void Simulation::State::checkHealth()
{
    double limit = runawaySpeed;
    for (const auto& run : runs)
        limit =
            std::max(limit, runawaySpeed + runawaySoundSpeeds * run->materials.largest([](const Material& material) {
                return material.soundSpeed();
            }));
    const double speed = largestTravel / lastStep;
    const auto slower = [&] {
        const bool hasTools =
            std::any_of(tools.begin(), tools.end(), [](const auto& tool) { return tool.has_value(); });
        return hasTools                  ? "Make the tools slower"
               : gravity != Vec3::Zero() ? "Lower gravity"
                                         : "Move bodies and fixtures slower";
    };
    std::ostringstream cause;
    Trouble trouble = Trouble::none;
    if (!std::isfinite(speed)) {
        trouble = Trouble::notANumber;
        cause << "a position is no longer a number. " << slower() << " or make the material softer, then reset.";
    } else if (speed > limit) {
        trouble = Trouble::runaway;
        cause << "objects moved at " << speed << " m/s. " << slower() << " or raise the damping ratio, then reset.";
    } else if (step % (isImplicit() ? implicitCheckpointInterval : checkpointInterval) == 0) {
        if (const std::string name = squashedBody(); !name.empty()) {
            trouble = Trouble::squashed;
            cause << "material of " << name
                  << " was squashed flat or turned inside out. Press less far, raise Poisson's ratio or the yield "
                     "stress, or fill the part with a smaller spacing, then reset.";
        } else if (!wasSquashed)
            lastGood = std::make_shared<const Moment>(moment());
    }
    if (cause.str().empty() && !isImplicit()) {
        const bool crowded = contactReport.crowding > crowding;
        if (crowded)
            crowding = crowdingReserve * contactReport.crowding;
        if (crowded || step % timeStepInterval == 0)
            updateTimeStep();
        if (wantedTimeStep && *wantedTimeStep > stableStepTolerance * stableStep) {
            trouble = Trouble::longStep;
            cause << "the chosen time step of " << *wantedTimeStep << " s is longer than the stable one of "
                  << stableStep << " s. Choose a shorter one, or a softer or more damped material.";
        }
    }
    if (!cause.str().empty())
        stop(cause.str(), trouble);
}

std::size_t Simulation::State::components()
{
    std::uint64_t version = contacts->joints().version();
    for (std::size_t b = 0; b < runs.size(); ++b)
        version = 31 * version + runs[b]->connections.changes().broken.size() * 2 + (runs[b]->deforms() ? 0 : 1);
    if (version == componentsVersion)
        return knownComponents;
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
    componentsVersion = version;
    knownComponents = sets.count();
    return knownComponents;
}

} // namespace knead
