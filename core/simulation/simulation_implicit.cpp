// Steps of the implicit scheme, how long they are, and when they are taken.
#include "core/integration/time_step.h"
#include "core/simulation/simulation_state.h"
#include "core/simulation/smallest_spacing.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

namespace knead {

namespace {

// A step shows as a frame [s].
constexpr double longestStep = 1.0 / 60;
// Steps are halved so often at most, which is a quarter of a millisecond.
constexpr int mostHalvings = 6;
// In a step nothing may go further than this [spacings], so that what is met within it is still on the right side.
constexpr double travelShare = 0.5;
// A step that moved something further than this is taken again at half the length [spacings].
constexpr double farthestShare = 1.25;
// Before a step is made longer again, speeds must be so much below what it allows: the factor of the system would be found anew
// with every change.
constexpr double calmShare = 0.9;
// A tool may exceed its force limit by this share in a step. A step that ends above is taken again with less of the tool's way,
// so many times at most, until it ends below, and not far below where it was stopped.
constexpr double forceLimitShare = 0.05;
constexpr double leastForceShare = 0.5;
constexpr int mostWays = 10;

// A crack runs on within a step so many times at most. Each time a system is solved for what is left; what it does not come to runs
// on in the next step.
constexpr int mostBreakingRounds = 24;

// What a present-day core does of explicit steps times connections in a second. A constant and not a measurement,
// so that the same scene is carried out by the same scheme on any machine and with any load.
constexpr double connectionStepsPerSecond = 2.2e8;
// How much more a connection costs with the volumetric term, and with plastic flow.
constexpr double volumetricCost = 1.9;
constexpr double plasticCost = 0.5;

std::string inWords(double number)
{
    std::ostringstream text;
    text << std::setprecision(number < 1e3 ? 3 : 2);
    if (number >= 1e9)
        text << number / 1e9 << " billion";
    else if (number >= 1e6)
        text << number / 1e6 << " million";
    else if (number >= 1e3)
        text << number / 1e3 << " thousand";
    else
        text << number;
    return text.str();
}

const char* nameOf(Integrator integrator)
{
    switch (integrator) {
    case Integrator::implicitEuler:
        return "Implicit Euler";
    case Integrator::forwardEuler:
        return "Forward Euler";
    default:
        return "Semi-implicit Euler";
    }
}

} // namespace

/// What an explicit scheme would need of connections times steps per second of simulated time decides.
void Simulation::State::chooseIntegrator()
{
    double needed = 0;
    for (const auto& run : runs) {
        if (!run->deforms())
            continue;
        const double plastic = run->connections.yields() ? plasticCost : 0;
        needed += static_cast<double>(run->connections.count()) *
                  ((run->connections.hasBulk() ? volumetricCost : 1) + plastic);
    }
    const double explicitStep = wantedTimeStep.value_or(timeStepShare * stableStep);
    const double stepsPerSecond = 1 / explicitStep;
    needed *= stepsPerSecond;
    const bool keepsUp = needed <= connectionStepsPerSecond;
    Integrator chosen = wantedIntegrator;
    if (wantedIntegrator == Integrator::automatic)
        chosen = keepsUp ? Integrator::semiImplicitEuler : Integrator::implicitEuler;
    std::ostringstream reason;
    reason << nameOf(chosen) << ": ";
    if (wantedIntegrator != Integrator::automatic)
        reason << "chosen; ";
    reason << "explicit integration needs " << inWords(stepsPerSecond) << " steps per second, "
           << (keepsUp ? "which keeps up with real time." : "more than real time allows.");
    integratorReason = reason.str();
    if (chosen != integrator || step == 0) {
        // From here on velocities and places belong to the same time, as at the start.
        lastStep = 0;
        lastKick = 0;
        unknownEnergy = 0;
    }
    integrator = chosen;
    const double stored = contacts->setScheme(surfaces(), isImplicit());
    contactReport.energy += stored;
    energy.numerical -= stored;
    timeStep = isImplicit() ? std::min(longestStep, wantedTimeStep.value_or(longestStep)) : explicitStep;
}

void Simulation::State::setIntegrator(Integrator chosen)
{
    wantedIntegrator = chosen;
    // The stable step is that of the scheme in use.
    integrator = chosen == Integrator::forwardEuler ? chosen : Integrator::semiImplicitEuler;
    lastStep = 0;
    lastKick = 0;
    unknownEnergy = 0;
    updateTimeStep();
    chooseIntegrator();
}

/// Share of its way in a step that the force of a tool is likely to allow: away from what it presses it goes as it likes.
double Simulation::State::likelyShare(const ToolRun& tool, double duration) const
{
    const Manipulator& manipulator = tool.manipulator;
    const Vec3 way = advance(manipulator, time, duration).position - manipulator.pose.position;
    const double force = tool.force.norm();
    if (!std::isfinite(manipulator.forceLimit) || !(force > 0) ||
        way.dot(tool.force) > 0) // the material pushes it that way
        return 1;
    const double left = (1 - forceLimitShare) * manipulator.forceLimit - force;
    const double needed = tool.resistance * way.norm();
    return needed > left ? std::max(0.0, left / needed) : 1;
}

/// Speed at which tools are likely to move in the next frame [m/s].
double Simulation::State::fastestSurface() const
{
    double fastest = 0;
    for (const auto& tool : tools) {
        if (!tool)
            continue;
        const Manipulator& manipulator = tool->manipulator;
        const Pose next = advance(manipulator, time, longestStep);
        const double turn = next.rotation.angularDistance(manipulator.pose.rotation);
        const double way = (next.position - manipulator.pose.position).norm() + turn * 0.5 * manipulator.size.norm();
        fastest = std::max(fastest, likelyShare(*tool, longestStep) * way / longestStep);
    }
    return fastest;
}

/// The longest step in which nothing goes too far at present speeds: a half, a quarter ... of a frame.
double Simulation::State::longestImplicitStep() const
{
    double spacing = std::numeric_limits<double>::infinity();
    double fastest = fastestSurface();
    for (BodyId b = 0; b < runs.size(); ++b) {
        spacing = std::min(spacing, bodies[b].aggregate->lattice.spacing);
        const ObjectState& state = runs[b]->state;
        double squared = 0;
        for (std::size_t i = 0; i < state.size(); ++i)
            squared = std::max(squared, state.velocity.at(i).squaredNorm());
        fastest = std::max(fastest, std::sqrt(squared));
    }
    const double longest = std::min(longestStep, wantedTimeStep.value_or(longestStep));
    double h = longest;
    for (int halving = 0; halving < mostHalvings && fastest * h > travelShare * spacing; ++halving)
        h /= 2;
    const bool isLonger = lastStep > 0 && h > lastStep;
    if (isLonger) {
        h = std::min(2 * lastStep, longest);
        if (fastest * h > calmShare * travelShare * spacing)
            h = lastStep;
    }
    return h;
}

void Simulation::State::makeImplicit()
{
    std::vector<ImplicitEuler::BodyView> views;
    for (BodyId b = 0; b < runs.size(); ++b) {
        BodyRun& run = *runs[b];
        views.push_back({.state = &run.state,
                         .connections = &run.connections,
                         .rigid = run.rigid ? &*run.rigid : nullptr,
                         .deforms = run.deforms(),
                         .pieces = &piecesOf(b)});
    }
    implicit = std::make_unique<ImplicitEuler>(std::move(views));
    if (!loads.empty())
        implicit->setLoads([this] { return addLoads(time + timeStep); });
}

/// How far a tool with a force limit may go in a step: between a share of its way at which its force was below the limit and
/// one at which it was above.
struct Simulation::State::WaySearch {
    double share = 1; ///< tried last
    double below = 0;
    double forceBelow = 0;
    double above = 1;
    double forceAbove = 0;
    int tries = 0;
};

/// Tools that are at their limit begin with as much of their way as their force is likely to allow.
std::vector<Simulation::State::WaySearch> Simulation::State::beginWays() const
{
    std::vector<WaySearch> ways(tools.size());
    for (std::size_t t = 0; t < tools.size(); ++t)
        if (tools[t])
            ways[t] = {.share = likelyShare(*tools[t], timeStep), .forceBelow = tools[t]->force.norm()};
    return ways;
}

/// Takes note of the forces in the step that was tried. @return whether a tool has to go another way than it did
bool Simulation::State::searchWays(const std::vector<Pose>& before, std::vector<WaySearch>& ways)
{
    bool again = false;
    std::size_t surface = 0;
    for (std::size_t t = 0; t < tools.size(); ++t) {
        if (!tools[t])
            continue;
        ToolRun& tool = *tools[t];
        const double force = contactReport.loads[surface++].force.norm();
        const double limit = tool.manipulator.forceLimit;
        WaySearch& way = ways[t];
        const double length = (tool.manipulator.pose.position - before[t].position).norm();
        if (!std::isfinite(limit) || way.share == 0 || length == 0)
            continue;
        const bool isOver = force > (1 + forceLimitShare) * limit;
        if (force > tool.force.norm())
            tool.resistance = (force - tool.force.norm()) / length;
        if (isOver) {
            way.above = way.share;
            way.forceAbove = force;
        } else {
            way.below = way.share;
            way.forceBelow = force;
        }
        const bool isNear = !isOver && (force > leastForceShare * limit || way.forceAbove == 0);
        if (isNear || (way.tries == mostWays && !isOver))
            continue;
        // In turns by the chord, which is right once the tool touches, and in halves, which find where it does.
        const double chord = (limit - way.forceBelow) / (way.forceAbove - way.forceBelow);
        way.share = way.below + (way.tries % 2 == 0 ? std::clamp(chord, 0.0, 1.0) : 0.5) * (way.above - way.below);
        if (way.tries >= mostWays)
            way.share = way.below;
        ++way.tries;
        again = true;
    }
    return again;
}

/// A step that was taken though its equations were not solved is counted; the first one is said.
void Simulation::State::countSolved(bool isSolved)
{
    unsolvedInRow = isSolved ? 0 : unsolvedInRow + 1;
    if (isSolved)
        return;
    if (++unsolvedSteps > 1)
        return;
    std::ostringstream text;
    text << std::setprecision(3) << "The equations of the step at " << time
         << " s could not be solved: forces and places are rough from there on. Make tools slower, or choose a shorter "
            "time step.";
    notice = text.str();
}

void Simulation::State::stepImplicitly()
{
    if (!implicit)
        makeImplicit();
    for (BodyId b = 0; b < runs.size(); ++b)
        piecesOf(b); // which `implicit` looks at
    std::vector<Pose> before;
    for (const auto& tool : tools)
        before.push_back(tool ? tool->manipulator.pose : Pose{});
    const double spacing = smallestSpacing(bodies);
    timeStep = longestImplicitStep();
    ImplicitEuler::Report report;
    std::vector<WaySearch> ways = beginWays();
    solverIterations = 0;
    const double contactEnergy = contactReport.energy;
    for (int halvings = 0;;) {
        for (std::size_t t = 0; t < tools.size(); ++t)
            if (tools[t])
                tools[t]->manipulator.pose = before[t];
        std::vector<double> shares;
        for (const WaySearch& way : ways)
            shares.push_back(way.share);
        moveManipulators(shares);
        updateVicinity();
        report = implicit->step(*contacts, surfaces(), gravity, timeStep, contactEnergy);
        contactReport = report.contacts;
        solverIterations += report.iterations;
        const bool wentTooFar = !report.converged || report.largestSpeed * timeStep > farthestShare * spacing;
        if (wentTooFar && halvings < mostHalvings) {
            timeStep /= 2;
            ++halvings;
            ways = beginWays();
        } else if (!searchWays(before, ways)) {
            break;
        }
        implicit->undo();
    }
    for (int round = 0; round < mostBreakingRounds && report.converged; ++round) {
        const double fractured = energy.fracture;
        if (breakConnections() == 0)
            break;
        for (BodyId b = 0; b < runs.size(); ++b)
            piecesOf(b);
        report = implicit->goOn(*contacts, surfaces(), gravity, timeStep, energy.fracture - fractured);
        contactReport = report.contacts;
        solverIterations += report.iterations;
    }
    countSolved(report.converged);
    bookContacts();
    energy.viscous -= report.dampingWork;
    energy.numerical += report.numerical;
    tellFrictionApart();
    const Contacts::Report settled = implicit->settle(*contacts, surfaces(), timeStep);
    contactReport.energy = settled.energy;
    bookLoadsAfter();
    energy.plastic += settled.plastic;
    energy.fracture += settled.fracture;
    bookPlaced(settled);
    energy.plastic += report.plastic;
    for (auto& run : runs)
        run->connections.acceptFlow();
    loadFixtures();
    for (BodyId b = 0; b < runs.size(); ++b)
        energy.viscous += brakeShape(b, timeStep);
    endTurns();
    largestTravel = report.largestSpeed * timeStep;
    lastStep = lastKick = timeStep;
    unknownEnergy = 0;
    time += timeStep;
    ++step;
}

} // namespace knead
