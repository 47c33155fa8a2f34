#include "core/simulation/simulation.h"

#include "core/integration/semi_implicit_euler.h"
#include "core/integration/time_step.h"
#include "core/simulation/simulation_state.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace knead {

namespace {

// The state is kept for going back this often [steps]; copying it costs about a step.
constexpr std::uint64_t checkpointInterval = 256;
// With a volumetric term the stable step depends on the shape, so it is found again this often [steps].
constexpr std::uint64_t timeStepInterval = 256;
// Shape damping is slow by nature; applying it this seldom makes its cost disappear [steps].
constexpr std::uint64_t shapeDampingInterval = 16;
// A speed of objects that no sensible motion reaches: this many times the speed of sound, plus free fall from far up [m/s].
constexpr double runawaySoundSpeeds = 20;
constexpr double runawaySpeed = 30;

} // namespace

BodyRun::BodyRun(const Body& body)
    : state(objectsAtRest(*body.aggregate))
    , connections(body.aggregate, body.material)
{
}

std::vector<std::string> bodyProblems(const Body& body)
{
    if (!body.aggregate || body.aggregate->size() == 0)
        return {"It holds no objects. Fill it with a smaller spacing."};
    std::vector<std::string> problems = materialProblems(body.material);
    if (!body.velocity.allFinite() || !body.angularVelocity.allFinite())
        problems.emplace_back("Its velocity at the start must be finite numbers.");
    return problems;
}

Simulation::State::State(Scene scene)
    : bodies(std::move(scene.bodies))
    , gravity(scene.gravity)
    , floorHeight(scene.floorHeight)
    , floorFriction(scene.floorFriction)
{
    for (const Body& body : bodies)
        if (const auto problems = bodyProblems(body); !problems.empty())
            throw std::runtime_error("Body \"" + body.name + "\": " + problems.front());
    if (!gravity.allFinite())
        throw std::runtime_error("Gravity must be finite numbers.");
    for (const Manipulator& manipulator : scene.manipulators) {
        if (const auto problems = manipulatorProblems(manipulator); !problems.empty())
            throw std::runtime_error(problems.front());
        tools.emplace_back(manipulator);
    }
    for (const Body& body : bodies)
        runs.push_back(std::make_unique<BodyRun>(body));
    for (Fixture& fixture : scene.fixtures) {
        if (fixture.body >= bodies.size())
            throw std::runtime_error("Fixture \"" + fixture.name + "\" names a body that does not exist.");
        fixtures.emplace_back(std::move(fixture));
    }
    setMasses();
    placeAtStart();
}

void Simulation::State::setMasses()
{
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        BodyRun& run = *runs[b];
        const std::vector<double>& volume = bodies[b].aggregate->volume;
        run.heldMass.resize(volume.size());
        for (std::size_t i = 0; i < volume.size(); ++i) {
            run.state.mass[i] = bodies[b].material.density * volume[i];
            run.heldMass[i] = 1 / run.state.mass[i];
        }
    }
    holdFixtures();
}

void Simulation::State::holdFixtures()
{
    for (auto& run : runs) {
        run->state.inverseMass = run->heldMass;
        run->anchored = false;
    }
    for (const auto& fixture : fixtures) {
        if (!fixture)
            continue;
        BodyRun& run = *runs[fixture->body];
        for (const ObjectIndex object : fixture->objects) {
            if (object >= run.state.size())
                continue;
            run.state.inverseMass[object] = 0;
            run.state.velocity.set(object, Vec3::Zero());
            run.anchored = true;
        }
    }
}

void Simulation::State::updateTimeStep()
{
    double smallest = std::numeric_limits<double>::infinity();
    for (auto& run : runs)
        smallest = std::min(
            smallest, stableTimeStep(run->connections.largestFrequency(run->state), run->connections.dampingTime()));
    timeStep = timeStepShare * (runs.empty() ? 1e-3 : smallest);
}

void Simulation::State::placeAtStart()
{
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const ObjectState rest = objectsAtRest(*bodies[b].aggregate);
        ObjectState& state = runs[b]->state;
        state.position = rest.position;
        Vec3 center = Vec3::Zero();
        double mass = 0;
        for (std::size_t i = 0; i < state.size(); ++i) {
            center += state.mass[i] * state.position.at(i);
            mass += state.mass[i];
        }
        center /= mass;
        for (std::size_t i = 0; i < state.size(); ++i)
            state.velocity.set(i, bodies[b].velocity + bodies[b].angularVelocity.cross(state.position.at(i) - center));
    }
    for (auto& tool : tools)
        if (tool)
            tool = ToolRun(tool->start);
    holdFixtures();
    std::vector<Contacts::BodyView> views;
    for (std::size_t b = 0; b < bodies.size(); ++b)
        views.push_back({&runs[b]->state, bodies[b].aggregate.get(), &runs[b]->connections, &bodies[b].material});
    contacts = std::make_unique<Contacts>(std::move(views));
    contactReport = {};
    recording.clear();
    step = 0;
    time = 0;
    largestTravel = 0;
    surfaceTravel = 0;
    health = {};
    energy = {};
    updateTimeStep();
    const EnergyLedger stored = storedEnergy();
    startEnergy = stored.kinetic + stored.elastic + stored.gravity;
    lastGood = checkpoint();
}

std::vector<RigidSurface> Simulation::State::surfaces() const
{
    std::vector<RigidSurface> all;
    for (const auto& tool : tools)
        if (tool)
            all.push_back({.shape = RigidSurface::Shape::box,
                           .size = tool->manipulator.size,
                           .pose = tool->manipulator.pose,
                           .velocity = tool->velocity,
                           .angularVelocity = tool->angularVelocity,
                           .friction = tool->manipulator.friction});
    if (floorHeight)
        all.push_back({.shape = RigidSurface::Shape::floor,
                       .pose = {Vec3(0, 0, *floorHeight), Quaternion::Identity()},
                       .friction = floorFriction});
    return all;
}

void Simulation::State::moveManipulators()
{
    surfaceTravel = 0;
    for (auto& tool : tools) {
        if (!tool)
            continue;
        Manipulator& manipulator = tool->manipulator;
        const Pose next = yieldTo(tool->force, manipulator, advance(manipulator, time, timeStep), timeStep);
        tool->velocity = (next.position - manipulator.pose.position) / timeStep;
        const Eigen::AngleAxisd turn(next.rotation * manipulator.pose.rotation.conjugate());
        tool->angularVelocity = turn.axis() * (turn.angle() / timeStep);
        manipulator.pose = next;
        const double speed = tool->velocity.norm() + tool->angularVelocity.norm() * 0.5 * manipulator.size.norm();
        surfaceTravel = std::max(surfaceTravel, speed * timeStep);
    }
}

void Simulation::State::updateVicinity()
{
    contacts->updateVicinity(surfaces(), largestTravel, surfaceTravel);
}

void Simulation::State::computeForces()
{
    for (auto& run : runs)
        run->connections.computeForces(run->state);
    contactReport = contacts->computeForces(surfaces(), timeStep);
    energy.dissipated -= contactReport.brakingPower * timeStep;
    std::size_t surface = 0;
    for (auto& tool : tools) {
        if (!tool)
            continue;
        const SurfaceLoad& load = contactReport.loads[surface++];
        energy.toolWork += load.power * timeStep;
        tool->force = load.force;
        tool->forceSum += load.force;
        tool->torqueSum += load.torque;
        ++tool->stepsInSum;
        tool->peakForce = std::max(tool->peakForce, load.force.norm());
    }
}

void Simulation::State::integrate()
{
    double largestSpeed = 0;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const StepReport report = semiImplicitEuler(runs[b]->state, gravity, timeStep);
        if (!(report.largestSpeed <= largestSpeed))
            largestSpeed = report.largestSpeed;
        energy.dissipated -= report.dampingWork;
        if (const double rate = bodies[b].material.shapeDamping; rate > 0 && step % shapeDampingInterval == 0)
            energy.dissipated += dampShape(runs[b]->state, rate, timeStep * shapeDampingInterval, runs[b]->anchored);
    }
    largestTravel = largestSpeed * timeStep;
    time += timeStep;
    ++step;
}

void Simulation::State::stop(const std::string& cause)
{
    std::ostringstream text;
    text << "The simulation was stopped at " << time << " s: " << cause << " It went back to " << lastGood.time
         << " s.";
    goBack(lastGood);
    health = {false, text.str()};
}

void Simulation::State::checkHealth()
{
    double limit = runawaySpeed;
    for (const Body& body : bodies)
        limit = std::max(limit, runawaySpeed + runawaySoundSpeeds * body.material.soundSpeed());
    const double speed = largestTravel / timeStep;
    if (!std::isfinite(speed)) {
        stop("a position is no longer a number. Make the tools slower or the material softer, then reset.");
    } else if (speed > limit) {
        std::ostringstream cause;
        cause << "objects moved at " << speed << " m/s. Make the tools slower, raise the damping ratio, then reset.";
        stop(cause.str());
    } else if (step % checkpointInterval == 0) {
        lastGood = checkpoint();
    }
    const bool shapeMatters =
        std::any_of(bodies.begin(), bodies.end(), [](const Body& body) { return body.material.poissonRatio > 0.25; });
    if (shapeMatters && step % timeStepInterval == 0)
        updateTimeStep();
}

Checkpoint Simulation::State::checkpoint() const
{
    Checkpoint moment{.step = step, .time = time, .energy = energy, .positions = {}, .velocities = {}, .toolPoses = {}};
    for (const auto& run : runs) {
        moment.positions.push_back(run->state.position);
        moment.velocities.push_back(run->state.velocity);
    }
    for (const auto& tool : tools)
        moment.toolPoses.push_back(tool ? tool->manipulator.pose : Pose{});
    return moment;
}

void Simulation::State::goBack(const Checkpoint& moment)
{
    step = moment.step;
    time = moment.time;
    energy = moment.energy;
    for (std::size_t b = 0; b < runs.size(); ++b) {
        runs[b]->state.position = moment.positions[b];
        runs[b]->state.velocity = moment.velocities[b];
    }
    for (std::size_t t = 0; t < std::min(tools.size(), moment.toolPoses.size()); ++t)
        if (tools[t])
            tools[t]->manipulator.pose = moment.toolPoses[t];
    largestTravel = 0;
    contacts->invalidate();
    contactReport = {};
}

Simulation::Simulation(Scene scene)
    : m_state(std::make_unique<State>(std::move(scene)))
{
}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

void Simulation::step()
{
    State& state = *m_state;
    state.applyCommands();
    if (!state.health.ok)
        return;
    state.moveManipulators();
    state.updateVicinity();
    state.computeForces();
    state.integrate();
    state.checkHealth();
}

void Simulation::post(Command command)
{
    m_state->pending.push_back(std::move(command));
}
void Simulation::applyCommands()
{
    m_state->applyCommands();
}
void Simulation::reset()
{
    m_state->placeAtStart();
}

double Simulation::timeStep() const
{
    return m_state->timeStep;
}
double Simulation::time() const
{
    return m_state->time;
}
std::uint64_t Simulation::stepCount() const
{
    return m_state->step;
}
const std::vector<Body>& Simulation::bodies() const
{
    return m_state->bodies;
}
const Health& Simulation::health() const
{
    return m_state->health;
}
const std::vector<RecordedCommand>& Simulation::recording() const
{
    return m_state->recording;
}

} // namespace knead
