// What a run is measured by: speeds, energy, equations, tools inside material. Causes and remedies in sentences.
#include "core/message/number_text.h"
#include "core/simulation/simulation_state.h"
#include "core/simulation/surface_overlap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace knead {

namespace {

// Whatever the scene is like, this is no runaway: free fall from 45 m [m/s].
constexpr double plainSpeed = 30;
// A tip or a light piece goes so many times as fast as what drives its body.
constexpr double drivenFactor = 10;
// Material lets go of strain at the speed of sound times that strain. What yields or breaks stores no more than a strain of
// 0.1, many times what metals do; what does neither may come back from a stretch to three times its length.
constexpr double boundedStrain = 0.1;
constexpr double elasticStrain = 2;
// Nothing outruns so many times the speed of sound in its material, however it is driven: no step follows that.
constexpr double mostSoundSpeeds = 20;

// So much of the energy that goes round may come from nowhere; a sound scheme stays below a hundredth.
constexpr double createdShare = 0.5;
// Below the energy of this strain everywhere, nothing is worth stopping for.
constexpr double negligibleStrain = 1e-3;
// Of the potential energy, which is a difference of large numbers far from the origin.
constexpr double roundingShare = 1e-9;

// Implicit steps in a row that were not solved, each as short as steps may get.
constexpr std::uint32_t mostUnsolvedSteps = 64;

// A tool this far in the material at the start is said [spacings]; in trouble it is the likely cause.
constexpr double insideDepth = 0.5;
// Mass scaling that added this share of the mass may be what went wrong.
constexpr double heavyShare = 0.05;

Message nameOf(const Body& body)
{
    return body.name.empty() ? Message("Run", "the body") : Message::verbatim("\"" + body.name + "\"");
}

/// Three digits are plenty in a sentence.
std::string rounded(double number)
{
    return inDigits(number, 3);
}

/// Speed of the fastest point of a body that moved like a rigid one with its momentum, and about its center [m/s].
double rigidSpeed(const ObjectState& state)
{
    double mass = 0;
    Vec3 momentum = Vec3::Zero();
    Vec3 center = Vec3::Zero();
    for (std::size_t i = 0; i < state.size(); ++i) {
        mass += state.mass[i];
        momentum += state.mass[i] * state.velocity.at(i);
        center += state.mass[i] * state.position.at(i);
    }
    center /= mass;
    Vec3 angularMomentum = Vec3::Zero();
    double inertia = 0; // polar
    double radius = 0;
    for (std::size_t i = 0; i < state.size(); ++i) {
        const Vec3 arm = state.position.at(i) - center;
        angularMomentum += state.mass[i] * arm.cross(state.velocity.at(i));
        inertia += state.mass[i] * arm.squaredNorm();
        radius = std::max(radius, arm.norm());
    }
    return momentum.norm() / mass + (inertia > 0 ? 2 * angularMomentum.norm() / inertia * radius : 0);
}

double soundSpeedOf(const BodyRun& run)
{
    return run.materials.largest([](const Material& material) { return material.soundSpeed(); });
}

/// What a body's material makes of what is stored in it [m/s].
/// @param placedEnergy stored by what was put into material [J]
double releasedSpeed(const BodyRun& run, double placedEnergy)
{
    if (placedEnergy > 0) // contacts may have stored anything
        return mostSoundSpeeds * soundSpeedOf(run);
    return run.materials.largest([](const Material& material) {
        if (material.isRubberlike()) // comes back from wherever it does not break
            return material.soundSpeed() * std::max(elasticStrain, material.tensileStrength / material.youngsModulus);
        return material.soundSpeed() * (material.yields() || material.breaks() ? boundedStrain : elasticStrain);
    });
}

/// What moves the body, and what its material can let go of, makes nothing in it faster than this [m/s].
double fastestSensible(const BodyRun& run, double placedEnergy, double fastestDriven)
{
    const double released = releasedSpeed(run, placedEnergy);
    const double driven = std::max(fastestDriven, rigidSpeed(run.state));
    return plainSpeed + std::min(mostSoundSpeeds * soundSpeedOf(run), drivenFactor * driven + released);
}

/// Of a surface in a body [m].
double depthOf(const Simulation::State& state, const RigidSurface& surface, BodyId body)
{
    return std::max(state.contacts->deepest(body, surface),
                    overlapOf(surface, state.runs[body]->state.position, *state.bodies[body].aggregate));
}

/// Of a tool in a body.
struct Overlap {
    double depth = 0; ///< [m]; 0: none
    ToolId tool = 0;
    BodyId body = 0;
};

/// The tool that is deepest in material now.
Overlap deepestTool(const Simulation::State& state)
{
    const std::vector<RigidSurface> all = state.surfaces();
    Overlap deepest;
    std::size_t surface = 0;
    for (ToolId t = 0; t < state.tools.size(); ++t) {
        if (!state.tools[t])
            continue;
        for (BodyId b = 0; b < state.runs.size(); ++b) {
            if (state.runs[b]->kind == BodyKind::glue) // it touches no tools
                continue;
            const double depth = depthOf(state, all[surface], b);
            if (depth > deepest.depth)
                deepest = {.depth = depth, .tool = t, .body = b};
        }
        ++surface;
    }
    return deepest;
}

} // namespace

/// Empty when no object is too fast.
Message Simulation::State::runawayCause() const
{
    const double speed = travel.largest / steps.last;
    double least = std::numeric_limits<double>::infinity();
    for (const auto& run : runs) // a bound that needs no look at the objects
        least = std::min(
            least, plainSpeed + std::min(mostSoundSpeeds * soundSpeedOf(*run), releasedSpeed(*run, accounts.placed)));
    if (speed <= least)
        return {};
    for (BodyId b = 0; b < runs.size(); ++b) {
        const double fastest = runs[b]->rigid ? runs[b]->rigid->largestSpeed() : largestSpeed(runs[b]->state);
        if (fastest <= least)
            continue;
        const double limit = fastestSensible(*runs[b], accounts.placed, travel.fastestDriven);
        if (fastest <= limit)
            continue;
        return Message("Run",
                       "objects of %1 moved at %2 m/s, and nothing in the scene makes them faster than %3 m/s. %4 or "
                       "raise the damping ratio, then reset.")
            .with(nameOf(bodies[b]), rounded(fastest), rounded(limit), remedy());
    }
    return {};
}

/// Looks at the ledger; empty when no energy worth mention came from nowhere. Two looks in a row must agree, since a blow may
/// be worse than what comes after it.
Message Simulation::State::energyCause()
{
    const EnergyLedger now = storedEnergy();
    accounts.energy.turnover = now.turnover;
    double negligible = roundingShare * std::abs(now.gravity);
    for (BodyId b = 0; b < runs.size(); ++b)
        if (runs[b]->deforms())
            negligible += 0.5 * negligibleStrain * negligibleStrain * bodies[b].aggregate->filledVolume *
                          runs[b]->materials.largest([](const Material& material) { return material.youngsModulus; });
    const bool isOverdrawn = now.created() > negligible && now.created() > createdShare * accounts.energy.turnover;
    if (!std::exchange(travel.wasOverdrawn, isOverdrawn) || !isOverdrawn)
        return {};
    return Message("Run",
                   "%1 J came from nowhere, of %2 J in the scene: the steps no longer follow the material. %3 or raise "
                   "the damping ratio, then reset.")
        .with(rounded(now.created()), rounded(accounts.energy.turnover), remedy());
}

/// Empty as long as most steps could be solved.
Message Simulation::State::unsolvedCause() const
{
    if (watch.unsolvedInRow < mostUnsolvedSteps)
        return {};
    return Message("Run",
                   "the equations of %1 steps in a row could not be solved, though the last was only %2 s long. %3 or "
                   "raise the damping ratio, then reset.")
        .with(watch.unsolvedInRow, rounded(steps.last), remedy());
}

/// What is most likely wrong, as something to do.
Message Simulation::State::remedy() const
{
    const Overlap overlap = deepestTool(*this);
    if (overlap.depth > 2 * insideDepth * bodies[overlap.body].aggregate->lattice.spacing)
        return Message("Run",
                       "The tool \"%1\" is %2 mm deep in %3: let it begin outside and press less far, make it slower")
            .with(tools[overlap.tool]->manipulator.name, rounded(1e3 * overlap.depth), nameOf(bodies[overlap.body]));
    double mass = 0;
    for (const auto& run : runs)
        for (const double each : run->state.mass)
            mass += each;
    if (massScaling.added > heavyShare * mass)
        return Message("Run", "Choose a shorter time step for mass scaling, which added %1 % to the mass")
            .with(rounded(100 * massScaling.added / (mass - massScaling.added)));
    const bool hasTools = std::any_of(tools.begin(), tools.end(), [](const auto& tool) { return tool.has_value(); });
    return hasTools                         ? Message("Run", "Make the tools slower")
           : around.gravity != Vec3::Zero() ? Message("Run", "Lower gravity")
                                            : Message("Run", "Move bodies and fixtures slower");
}

/// Of tools and the floor now [spacings].
double Simulation::State::deepestOverlap() const
{
    double deepest = 0;
    for (const RigidSurface& surface : surfaces())
        for (BodyId b = 0; b < runs.size(); ++b)
            if (runs[b]->kind != BodyKind::glue)
                deepest = std::max(deepest, depthOf(*this, surface, b) / bodies[b].aggregate->lattice.spacing);
    return deepest;
}

/// Tools that were just put somewhere, and the floor.
void Simulation::State::noteToolsInside()
{
    watch.isPlacedInside = watch.isPlacedInside || deepestOverlap() > 0;
    const Overlap overlap = deepestTool(*this);
    if (overlap.depth == 0 || overlap.depth <= insideDepth * bodies[overlap.body].aggregate->lattice.spacing)
        return;
    out.notice =
        Message("Run", "The tool \"%1\" begins %2 mm inside %3, which is pushed away with great force, in very short "
                       "steps. Let it begin outside.")
            .with(tools[overlap.tool]->manipulator.name, rounded(1e3 * overlap.depth), nameOf(bodies[overlap.body]));
}

/// Tools that were put into material begin without force, and push it out from here on.
void Simulation::State::bookToolsInside()
{
    if (std::exchange(watch.isPlacedInside, false))
        contacts->keepInside(surfaces());
}

/// What contacts store with what was put into material was put in by hand: neither won nor lost in the ledger.
void Simulation::State::bookPlaced(const Contacts::Report& report)
{
    accounts.atStart += report.placed;
    accounts.placed += report.placed;
}

} // namespace knead
