// Steps of the implicit scheme, how long they are, and when they are taken.
#include "core/integration/solver_settings.h"
#include "core/message/number_text.h"
#include "core/simulation/simulation_state.h"
#include "core/simulation/smallest_spacing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace knead {

namespace {

// In which tools are looked ahead [s].
constexpr double frame = 1.0 / 60;
constexpr const ImplicitStepSettings& implicitSteps = solverSettings.implicitSteps;

// What a present-day core does of explicit steps times connections in a second. A constant and not a measurement,
// so that the same scene is carried out by the same scheme on any machine and with any load.
constexpr double connectionStepsPerSecond = 2.2e8;
// How much more a connection costs with the volumetric term, and with plastic flow.
constexpr double volumetricCost = 1.9;
constexpr double plasticCost = 0.5;

Message inWords(double number)
{
    if (number >= 1e9)
        return Message("Number", "%1 billion").with(inDigits(number / 1e9, 2));
    if (number >= 1e6)
        return Message("Number", "%1 million").with(inDigits(number / 1e6, 2));
    if (number >= 1e3)
        return Message("Number", "%1 thousand").with(inDigits(number / 1e3, 2));
    return Message::verbatim(inDigits(number, 3));
}

Message nameOf(Integrator integrator)
{
    switch (integrator) {
    case Integrator::implicitEuler:
        return Message("Run", "Implicit Euler");
    case Integrator::forwardEuler:
        return Message("Run", "Forward Euler");
    default:
        return Message("Run", "Semi-implicit Euler");
    }
}

/// Why a scheme is in use. @param isChosen by a person
Message reasonOf(Integrator integrator, bool isChosen, double stepsPerSecond, bool keepsUp)
{
    const Message name = nameOf(integrator);
    const Message steps = inWords(stepsPerSecond);
    if (isChosen && keepsUp)
        return Message("Run",
                       "%1: chosen; explicit integration needs %2 steps per second, which keeps up with real time.")
            .with(name, steps);
    if (isChosen)
        return Message("Run", "%1: chosen; explicit integration needs %2 steps per second, more than real time allows.")
            .with(name, steps);
    if (keepsUp)
        return Message("Run", "%1: explicit integration needs %2 steps per second, which keeps up with real time.")
            .with(name, steps);
    return Message("Run", "%1: explicit integration needs %2 steps per second, more than real time allows.")
        .with(name, steps);
}

/// Whether the material holds the tool up on a way.
bool isStalled(const ToolRun& tool, const Vec3& way)
{
    return way.dot(tool.force) <= 0 &&
           tool.force.norm() > (1 - implicitSteps.stalledShare) * tool.manipulator.forceLimit;
}

/// Around all objects, with a spacing around them.
Box materialBox(const std::vector<std::unique_ptr<BodyRun>>& runs)
{
    Box box;
    double margin = 0;
    for (const auto& run : runs) {
        const VectorArray& places = run->state.position;
        for (std::size_t object = 0; object < places.size(); ++object)
            box.extend(places.at(object));
        margin = std::max(margin, run->connections.aggregate().lattice.spacing);
    }
    return box.isEmpty() ? box : Box(box.min().array() - margin, box.max().array() + margin);
}

/// How many tools have force limits.
std::size_t limitedTools(const std::vector<std::optional<ToolRun>>& tools)
{
    return static_cast<std::size_t>(std::count_if(tools.begin(), tools.end(), [](const auto& tool) {
        return tool && std::isfinite(tool->manipulator.forceLimit);
    }));
}

/// Where a tool is, and how it moved in the last step.
struct ToolPlace {
    Pose pose;
    Vec3 velocity = Vec3::Zero();
};

std::vector<ToolPlace> placesOf(const std::vector<std::optional<ToolRun>>& tools)
{
    std::vector<ToolPlace> places;
    for (const auto& tool : tools)
        places.push_back(tool ? ToolPlace{tool->manipulator.pose, tool->velocity} : ToolPlace{});
    return places;
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
    const double explicitStep = chosen.timeStep.value_or(solverSettings.explicitSteps.timeStepShare * steps.stable);
    const double stepsPerSecond = 1 / explicitStep;
    needed *= stepsPerSecond;
    const bool keepsUp = needed <= connectionStepsPerSecond;
    Integrator next = scheme.wanted;
    if (scheme.wanted == Integrator::automatic)
        next = keepsUp ? Integrator::semiImplicitEuler : Integrator::implicitEuler;
    scheme.reason = reasonOf(next, scheme.wanted != Integrator::automatic, stepsPerSecond, keepsUp);
    if (next != scheme.inUse || steps.count == 0) {
        // From here on velocities and places belong to the same time, as at the start.
        steps.last = 0;
        travel.lastKick = 0;
        accounts.unknown = 0;
    }
    scheme.inUse = next;
    const double stored = contacts->setScheme(surfaces(), isImplicit());
    contactReport.energy += stored;
    accounts.energy.numerical -= stored;
    steps.length = isImplicit() ? frameStep() : explicitStep;
}

void Simulation::State::setIntegrator(Integrator wanted)
{
    scheme.wanted = wanted;
    // The stable step is that of the scheme in use.
    scheme.inUse = wanted == Integrator::forwardEuler ? wanted : Integrator::semiImplicitEuler;
    steps.last = 0;
    travel.lastKick = 0;
    accounts.unknown = 0;
    updateTimeStep();
    chooseIntegrator();
}

/// [N/m]; infinite without a force limit
double Simulation::State::handStiffness(const Manipulator& manipulator) const
{
    return manipulator.forceLimit / (implicitSteps.handGive * smallestSpacing(bodies));
}

/// Where the hand of a tool wants it after a time from now.
Pose Simulation::State::wantedPose(const ToolRun& tool, double duration) const
{
    return yieldTo(Vec3::Zero(), tool.manipulator, advance(tool.manipulator, steps.time, duration), duration);
}

/// Speed at which tools are likely to move in the next frame: one that is held up as in the last [m/s]. Those that pass by far from
/// all material may go as fast as they like.
double Simulation::State::fastestSurface() const
{
    double fastest = 0;
    const Box material = materialBox(runs);
    const double ahead = std::max(frame, frameStep());
    for (const auto& tool : tools) {
        if (!tool)
            continue;
        const Manipulator& manipulator = tool->manipulator;
        const Pose next = wantedPose(*tool, ahead);
        const double turn = next.rotation.angularDistance(manipulator.pose.rotation);
        const Vec3 way = next.position - manipulator.pose.position;
        const double reach = 0.5 * manipulator.size.norm();
        Box swept(manipulator.pose.position);
        swept.extend(next.position);
        if (Box(swept.min().array() - reach, swept.max().array() + reach).intersection(material).isEmpty())
            continue;
        const double speed = isStalled(*tool, way) ? tool->velocity.norm() : way.norm() / ahead;
        fastest = std::max(fastest, speed + turn * 0.5 * manipulator.size.norm() / ahead);
    }
    return fastest;
}

/// Tools go to where they are likely to be at the end of the step. @return the hands of those with force limits
std::vector<ToolHand> Simulation::State::beginHands()
{
    std::vector<ToolHand> hands;
    std::uint32_t surface = 0;
    travel.ofSurfaces = 0;
    for (auto& tool : tools) {
        if (!tool)
            continue;
        Manipulator& manipulator = tool->manipulator;
        const Pose next = wantedPose(*tool, steps.length);
        const Vec3 way = next.position - manipulator.pose.position;
        if (std::isfinite(manipulator.forceLimit))
            hands.push_back({.surface = surface,
                             .from = manipulator.pose.position,
                             .goal = next.position,
                             .push = -std::min(1.0, manipulator.forceLimit / tool->force.norm()) * tool->force,
                             .velocity = tool->velocity,
                             .limit = manipulator.forceLimit,
                             .stiffness = handStiffness(manipulator)});
        if (!isStalled(*tool, way))
            tool->velocity = way / steps.length;
        turnTool(*tool, next.rotation);
        manipulator.pose.position += steps.length * tool->velocity;
        const double speed = tool->velocity.norm() + tool->angularVelocity.norm() * 0.5 * manipulator.size.norm();
        travel.ofSurfaces = std::max(travel.ofSurfaces, speed * steps.length);
        ++surface;
    }
    travel.ofSurfaces += travel.strayed;
    turnGrips();
    return hands;
}

/// Tools are where the step has brought them.
void Simulation::State::endHands(const std::vector<ToolHand>& hands)
{
    std::uint32_t surface = 0;
    auto hand = hands.begin();
    for (auto& tool : tools) {
        if (!tool)
            continue;
        if (hand != hands.end() && hand->surface == surface) {
            tool->manipulator.pose.position = implicit->surfaces()[surface].pose.position;
            tool->velocity = implicit->surfaces()[surface].velocity;
            ++hand;
        }
        ++surface;
    }
}

/// Implicit steps are no longer than this [s].
double Simulation::State::frameStep() const
{
    const double longest = numbersOf(scheme.pace).longestStep;
    return std::min(longest, chosen.timeStep.value_or(longest));
}

/// The longest step in which nothing goes too far at present speeds: a half, a quarter ... of a frame.
double Simulation::State::longestImplicitStep() const
{
    double spacing = std::numeric_limits<double>::infinity();
    double fastest = fastestSurface();
    for (BodyId b = 0; b < runs.size(); ++b) {
        spacing = std::min(spacing, bodies[b].aggregate->lattice.spacing);
        fastest = std::max(fastest, largestSpeed(runs[b]->state));
    }
    const double longest = frameStep();
    double h = longest;
    for (int halving = 0; halving < implicitSteps.mostHalvings && fastest * h > implicitSteps.travelShare * spacing;
         ++halving)
        h /= 2;
    const bool isLonger = steps.last > 0 && h > steps.last;
    if (isLonger) {
        h = std::min(2 * steps.last, longest);
        if (fastest * h > implicitSteps.calmShare * implicitSteps.travelShare * spacing)
            h = steps.last;
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
    implicit = std::make_unique<ImplicitEuler>(std::move(views), limitedTools(tools));
    if (!loads.empty())
        implicit->setLoads([this] { return addLoads(steps.time + steps.length); });
}

/// A step that was taken though its equations were not solved is counted; the first one is said.
void Simulation::State::countSolved(bool isSolved)
{
    watch.unsolvedInRow = isSolved ? 0 : watch.unsolvedInRow + 1;
    if (isSolved)
        return;
    if (++watch.unsolved > 1)
        return;
    out.notice =
        Message("Run",
                "The equations of the step at %1 s could not be solved: forces and places are rough from there on. "
                "Make tools slower, or choose a shorter time step.")
            .with(inDigits(steps.time, 3));
}

void Simulation::State::stepImplicitly()
{
    if (!implicit || implicit->mostHands() < limitedTools(tools))
        makeImplicit();
    const bool flows = std::any_of(runs.begin(), runs.end(),
                                   [](const auto& run) { return run->deforms() && run->connections.yields(); });
    implicit->setTolerance(flows ? numbersOf(scheme.pace).whereItFlows : numbersOf(scheme.pace).tolerance);
    for (BodyId b = 0; b < runs.size(); ++b)
        piecesOf(b); // which `implicit` looks at
    const std::vector<ToolPlace> before = placesOf(tools);
    const double spacing = smallestSpacing(bodies);
    steps.length = longestImplicitStep();
    ImplicitEuler::Report report;
    std::vector<ToolHand> hands;
    scheme.iterations = 0;
    const double contactEnergy = contactReport.energy;
    for (int halvings = 0;; ++halvings) {
        hands = beginHands();
        updateVicinity();
        std::vector<RigidSurface> likely = surfaces();
        report = implicit->step(*contacts, likely, hands, around.gravity, steps.length, contactEnergy);
        scheme.iterations += report.iterations;
        travel.strayed = 0;
        for (std::size_t s = 0; s < likely.size(); ++s)
            travel.strayed =
                std::max(travel.strayed, (implicit->surfaces()[s].pose.position - likely[s].pose.position).norm());
        const bool isLost = !report.isWhole && halvings < solverSettings.newton.mostWholeHalvings;
        const bool wentTooFar = !report.converged || isLost ||
                                report.largestSpeed * steps.length > implicitSteps.farthestShare * spacing ||
                                travel.strayed > implicitSteps.travelShare * spacing;
        if (!wentTooFar || halvings == implicitSteps.mostHalvings)
            break;
        steps.length /= 2;
        for (std::size_t t = 0; t < tools.size(); ++t)
            if (tools[t])
                std::tie(tools[t]->manipulator.pose, tools[t]->velocity) = std::tie(before[t].pose, before[t].velocity);
        implicit->undo();
    }
    endHands(hands);
    contactReport = report.contacts;
    for (int round = 0; round < implicitSteps.mostBreakingRounds && report.converged; ++round) {
        const double fractured = accounts.energy.fracture;
        if (breakConnections() == 0)
            break;
        for (BodyId b = 0; b < runs.size(); ++b)
            piecesOf(b);
        report = implicit->goOn(*contacts, around.gravity, steps.length, accounts.energy.fracture - fractured);
        endHands(hands);
        contactReport = report.contacts;
        scheme.iterations += report.iterations;
    }
    countSolved(report.converged);
    bookContacts();
    accounts.energy.viscous -= report.dampingWork;
    accounts.energy.numerical += report.numerical;
    tellFrictionApart();
    const Contacts::Report settled = implicit->settle(*contacts, steps.length);
    contactReport.energy = settled.energy;
    bookLoadsAfter();
    accounts.energy.plastic += settled.plastic;
    accounts.energy.fracture += settled.fracture;
    bookPlaced(settled);
    accounts.energy.plastic += report.plastic;
    for (auto& run : runs)
        run->connections.acceptFlow();
    loadFixtures();
    for (BodyId b = 0; b < runs.size(); ++b)
        accounts.energy.viscous += brakeShape(b, steps.length);
    grips.endTurns(steps.length);
    travel.largest = report.largestSpeed * steps.length;
    steps.last = travel.lastKick = steps.length;
    accounts.unknown = 0;
    steps.time += steps.length;
    ++steps.count;
}

} // namespace knead
