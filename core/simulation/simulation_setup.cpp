// How a simulation begins: masses, fixtures, the time step, the state at the start.
#include "core/integration/solver_settings.h"
#include "core/integration/time_step.h"
#include "core/simulation/scene_limits.h"
#include "core/simulation/simulation_state.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace knead {

namespace {

constexpr double fastestBody = 1e3; // [m/s]
constexpr double fastestSpin = 1e5; // [rad/s]

constexpr FixtureId noFixture = std::numeric_limits<FixtureId>::max();

// Of scenes in which nothing deforms [s].
constexpr double rigidTimeStep = 1e-4;

void require(bool holds, const Message& sentence)
{
    if (!holds)
        throw Problem(sentence);
}

bool usableTimeStep(const std::optional<double>& length)
{
    return !length || (*length >= 1e-9 && *length <= 1);
}

} // namespace

BodyRun::BodyRun(const Body& body)
    : materials(body.material, body.aggregate->size())
    , state(objectsAtRest(*body.aggregate))
    , connections(body.aggregate, materials)
    , kind(body.kind)
{
    for (const MaterialRegion& region : body.regions)
        materials.set(region.objects, region.material);
    connections.setStructuralFriction(body.structuralFriction);
    connections.updateMaterials();
}

std::vector<Vec3> BodyRun::displacements() const
{
    std::vector<Vec3> displacements(state.size());
    for (ObjectIndex i = 0; i < displacements.size(); ++i)
        displacements[i] = state.position.at(i) - connections.aggregate().lattice.position(i);
    return displacements;
}

std::vector<Message> bodyProblems(const Body& body)
{
    if (!body.aggregate || body.aggregate->size() == 0)
        return {Message("Scene", "It holds no objects. Fill it with a smaller spacing.")};
    std::vector<Message> problems = materialProblems(body.material);
    for (const MaterialRegion& region : body.regions) {
        for (const Message& problem : materialProblems(region.material))
            problems.push_back(Message("Scene", "Region \"%1\": %2").with(region.name, problem));
        if (std::any_of(region.objects.begin(), region.objects.end(),
                        [&](ObjectIndex object) { return object >= body.aggregate->size(); }))
            problems.push_back(
                Message("Scene", "Region \"%1\" names an object that does not exist.").with(region.name));
    }
    if (!(body.velocity.norm() <= fastestBody) || !(body.angularVelocity.norm() <= fastestSpin))
        problems.push_back(Message("Scene", "It must not start faster than 1000 m/s or 100000 rad/s."));
    if (!(body.structuralFriction >= 0 && body.structuralFriction <= 2))
        problems.push_back(Message("Scene", "Its structural friction must lie between 0 and 2."));
    return problems;
}

std::vector<std::uint8_t> marksOf(const std::vector<ObjectIndex>& objects, std::size_t count)
{
    if (objects.empty())
        return {};
    std::vector<std::uint8_t> marks(count, 0);
    for (const ObjectIndex object : objects)
        if (object < count)
            marks[object] = 1;
    return marks;
}

Simulation::State::State(Scene scene)
    : bodies(std::move(scene.bodies))
    , around{scene.gravity, scene.floorHeight, scene.floorFriction, scene.floorAdhesion}
    , chosen{scene.touching, scene.vicinity, scene.timeStep}
    , scheme{.wanted = scene.integrator, .inUse = scene.integrator, .reason = {}}
    , massScaling{.timeStep = scene.massScalingTimeStep}
{
    for (const Body& body : bodies)
        if (const auto problems = bodyProblems(body); !problems.empty())
            throw Problem(Message("Scene", "Body \"%1\": %2").with(body.name, problems.front()));
    require(around.gravity.norm() <= strongestGravity,
            Message("Scene", "Gravity must not be stronger than 10000 m/s^2."));
    require(!around.floorHeight || std::abs(*around.floorHeight) <= farthestFloor,
            Message("Scene", "The height of the floor must lie between -10 and 10 km."));
    require(around.floorAdhesion >= 0 && around.floorAdhesion <= 1e9,
            Message("Scene", "The adhesion of the floor must lie between 0 and 1e9 Pa."));
    require(around.floorFriction >= 0 && around.floorFriction <= 2,
            Message("Scene", "The friction of the floor must lie between 0 and 2."));
    require(usableTimeStep(chosen.timeStep), Message("Scene", "The time step must lie between 1e-9 and 1 s."));
    require(usableTimeStep(massScaling.timeStep),
            Message("Scene", "The time step of mass scaling must lie between 1e-9 and 1 s."));
    for (const Manipulator& manipulator : scene.manipulators) {
        if (const auto problems = manipulatorProblems(manipulator); !problems.empty())
            throw Problem(problems.front());
        tools.emplace_back(manipulator);
    }
    refilling.isOn = scene.refilling;
    for (const Body& body : bodies) {
        runs.push_back(std::make_unique<BodyRun>(body));
        refilling.first.push_back(body.aggregate);
    }
    for (Fixture& fixture : scene.fixtures) {
        require(fixture.body < bodies.size(),
                Message("Fixture", "Fixture \"%1\" names a body that does not exist.").with(fixture.name));
        require(fixture.velocity.norm() <= fastestFixture,
                Message("Fixture", "Fixture \"%1\" must not move faster than 100 m/s.").with(fixture.name));
        require(gripProblem(fixture).empty(), gripProblem(fixture));
        grips.fixtures.emplace_back(std::move(fixture));
    }
    for (Load& load : scene.loads) {
        require(load.body < bodies.size(),
                Message("Load", "Load \"%1\" names a body that does not exist.").with(load.name));
        const Aggregate& aggregate = *bodies[load.body].aggregate;
        require(loadProblem(load, aggregate.size()).empty(), loadProblem(load, aggregate.size()));
        loads.add({.load = std::move(load)}, aggregate);
    }
    for (const auto& run : runs)
        requireDamping(run->materials, scheme.inUse);
    setMasses();
    placeAtStart();
    noteToolsInside();
}

/// Forward Euler is not stable without.
void Simulation::State::requireDamping(const MaterialMap& materials, Integrator integrator) const
{
    const double least = -materials.largest([](const Material& material) { return -material.dampingRatio; });
    require(
        integrator != Integrator::forwardEuler || least > 0,
        Message("Scene",
                "Forward Euler is not stable without damping: raise the damping ratio, or use semi-implicit Euler."));
}

void Simulation::State::setMasses()
{
    massScaling.added = 0;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        setMass(b);
        if (massScaling.timeStep && runs[b]->deforms())
            scaleMasses(*runs[b]);
    }
    holdFixtures();
}

/// Of the material alone.
void Simulation::State::setMass(std::size_t body)
{
    BodyRun& run = *runs[body];
    const std::vector<double>& volume = bodies[body].aggregate->volume;
    for (ObjectIndex i = 0; i < volume.size(); ++i)
        run.state.mass[i] = run.materials.of(i).density * volume[i];
    run.state.trueMass.clear();
}

/// Objects whose own bound on the frequency is above the one that the wanted step allows get more inertia, but no weight.
void Simulation::State::scaleMasses(BodyRun& run)
{
    const double frequency = frequencyForTimeStep(*massScaling.timeStep / solverSettings.explicitSteps.timeStepShare,
                                                  run.connections.dampingTime());
    std::vector<double> added(run.state.size());
    for (ObjectIndex i = 0; i < added.size(); ++i)
        added[i] = run.connections.contactStiffness(i);
    const std::vector<double> stiffness = run.connections.stiffnessBounds(run.state, added);
    const LaneVector<double> material = run.state.mass;
    for (std::size_t i = 0; i < stiffness.size(); ++i) {
        const double needed = stiffness[i] / (frequency * frequency);
        if (needed <= run.state.mass[i])
            continue;
        massScaling.added += needed - run.state.mass[i];
        run.state.mass[i] = needed;
    }
    if (run.state.mass != material)
        run.state.trueMass = material;
}

void Simulation::State::holdFixtures()
{
    for (auto& run : runs) {
        run->anchored = run->kind == BodyKind::glue;
        for (std::size_t i = 0; i < run->state.size(); ++i)
            run->state.inverseMass[i] = run->anchored ? 0 : 1 / run->state.mass[i];
    }
    grips.findCenters(bodies);
    for (const auto& run : runs)
        run->gripOf.assign(run->state.size(), noFixture);
    for (FixtureId id = 0; id < grips.fixtures.size(); ++id) {
        const auto& fixture = grips.fixtures[id];
        if (!fixture)
            continue;
        BodyRun& run = *runs[fixture->body];
        for (const ObjectIndex object : fixture->objects) {
            if (object >= run.state.size())
                continue;
            run.state.inverseMass[object] = 0;
            run.gripOf[object] = id;
            run.state.velocity.set(object, fixture->velocity);
            run.anchored = true;
        }
    }
    for (auto& run : runs) {
        if (run->deforms())
            continue;
        if (run->anchored) { // held anywhere, a rigid body is held everywhere
            run->rigid.reset();
            std::fill(run->state.inverseMass.begin(), run->state.inverseMass.end(), 0.0);
            for (std::size_t i = 0; i < run->state.size(); ++i)
                run->state.velocity.set(i, Vec3::Zero());
        } else if (!run->rigid) {
            run->rigid = rigidMotionOf(run->state);
        }
    }
}

/// Finds the longest stable step, and takes it in explicit schemes. @return the frequency that bounds it [rad/s]
double Simulation::State::boundTimeStep()
{
    steps.stable = std::numeric_limits<double>::infinity();
    double largest = 0;
    for (BodyId b = 0; b < runs.size(); ++b) {
        if (!runs[b]->deforms())
            continue;
        StructuralConnections& connections = runs[b]->connections;
        const double frequency =
            connections.largestFrequency(runs[b]->state, contacts->addedStiffness(b, steps.crowding));
        largest = std::max(largest, frequency);
        steps.stable = std::min(steps.stable, scheme.inUse == Integrator::forwardEuler
                                                  ? stableForwardEulerStep(frequency, connections.leastDampingTime(),
                                                                           connections.dampingTime())
                                                  : stableTimeStep(frequency, connections.dampingTime()));
    }
    if (largest == 0)
        steps.stable = rigidTimeStep / solverSettings.explicitSteps.timeStepShare;
    if (!isImplicit())
        steps.length = chosen.timeStep.value_or(solverSettings.explicitSteps.timeStepShare * steps.stable);
    return largest > 0 ? largest : 1 / rigidTimeStep;
}

/// The same where contacts may be others as well: at the start, and after a change of masses, materials, kinds or connections.
void Simulation::State::updateTimeStep()
{
    contacts->updateParameters(boundTimeStep());
}

std::vector<Contacts::BodyView> Simulation::State::contactBodies()
{
    std::vector<Contacts::BodyView> views;
    for (auto& run : runs)
        views.push_back({&run->state, &run->connections, &run->materials, run->kind});
    return views;
}

void Simulation::State::placeAtStart()
{
    for (BodyId b = 0; b < bodies.size(); ++b) {
        takeFirstFilling(b);
        BodyRun& run = *runs[b];
        run.state.position = objectsAtRest(*bodies[b].aggregate).position;
        run.connections.restore({});
        run.pieces.forget();
        run.kind = bodies[b].kind;
        run.rigid.reset();
        Vec3 center = Vec3::Zero();
        double mass = 0;
        for (std::size_t i = 0; i < run.state.size(); ++i) {
            center += run.state.mass[i] * run.state.position.at(i);
            mass += run.state.mass[i];
        }
        center /= mass;
        for (std::size_t i = 0; i < run.state.size(); ++i)
            run.state.velocity.set(i, bodies[b].velocity +
                                          bodies[b].angularVelocity.cross(run.state.position.at(i) - center));
        run.state.force.setZero();
        run.state.damping.setZero();
    }
    for (auto& tool : tools)
        if (tool)
            tool = ToolRun(tool->start);
    grips.progress.assign(grips.fixtures.size(), {});
    loads.begin();
    holdFixtures();
    contacts = std::make_unique<Contacts>(contactBodies(), chosen.vicinity);
    if (chosen.touching == Touching::glued)
        contacts->glueTouching();
    contactReport = {};
    annealings.clear();
    steps = {};
    travel = {};
    accounts = {};
    watch = {};
    cracks = {};
    refilling.count = 0;
    out.penetration = 0;
    rest.disturb();
    scheme.iterations = 0;
    implicit.reset();
    updateTimeStep();
    chooseIntegrator();
    accounts.atStart = storedEnergy().imbalance;
    lastGood = std::make_shared<const Moment>(moment());
}

} // namespace knead
