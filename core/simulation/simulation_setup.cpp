// How a simulation begins: masses, fixtures, the time step, the state at the start.
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

bool usableTimeStep(const std::optional<double>& step)
{
    return !step || (*step >= 1e-9 && *step <= 1);
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
    , gravity(scene.gravity)
    , floorHeight(scene.floorHeight)
    , floorFriction(scene.floorFriction)
    , floorAdhesion(scene.floorAdhesion)
    , touching(scene.touching)
    , wantedIntegrator(scene.integrator)
    , integrator(scene.integrator)
    , vicinity(scene.vicinity)
    , wantedTimeStep(scene.timeStep)
    , massScalingTimeStep(scene.massScalingTimeStep)
{
    for (const Body& body : bodies)
        if (const auto problems = bodyProblems(body); !problems.empty())
            throw Problem(Message("Scene", "Body \"%1\": %2").with(body.name, problems.front()));
    require(gravity.norm() <= strongestGravity, Message("Scene", "Gravity must not be stronger than 10000 m/s^2."));
    require(!floorHeight || std::abs(*floorHeight) <= farthestFloor,
            Message("Scene", "The height of the floor must lie between -10 and 10 km."));
    require(floorAdhesion >= 0 && floorAdhesion <= 1e9,
            Message("Scene", "The adhesion of the floor must lie between 0 and 1e9 Pa."));
    require(floorFriction >= 0 && floorFriction <= 2,
            Message("Scene", "The friction of the floor must lie between 0 and 2."));
    require(usableTimeStep(wantedTimeStep), Message("Scene", "The time step must lie between 1e-9 and 1 s."));
    require(usableTimeStep(massScalingTimeStep),
            Message("Scene", "The time step of mass scaling must lie between 1e-9 and 1 s."));
    for (const Manipulator& manipulator : scene.manipulators) {
        if (const auto problems = manipulatorProblems(manipulator); !problems.empty())
            throw Problem(problems.front());
        tools.emplace_back(manipulator);
    }
    refilling = scene.refilling;
    for (const Body& body : bodies) {
        runs.push_back(std::make_unique<BodyRun>(body));
        firstFillings.push_back(body.aggregate);
    }
    for (Fixture& fixture : scene.fixtures) {
        require(fixture.body < bodies.size(),
                Message("Fixture", "Fixture \"%1\" names a body that does not exist.").with(fixture.name));
        require(fixture.velocity.norm() <= fastestFixture,
                Message("Fixture", "Fixture \"%1\" must not move faster than 100 m/s.").with(fixture.name));
        require(gripProblem(fixture).empty(), gripProblem(fixture));
        fixtures.emplace_back(std::move(fixture));
    }
    for (Load& load : scene.loads) {
        require(load.body < bodies.size(),
                Message("Load", "Load \"%1\" names a body that does not exist.").with(load.name));
        const Aggregate& aggregate = *bodies[load.body].aggregate;
        require(loadProblem(load, aggregate.size()).empty(), loadProblem(load, aggregate.size()));
        loads.add({.load = std::move(load)}, aggregate);
    }
    for (const auto& run : runs)
        requireDamping(run->materials, integrator);
    setMasses();
    placeAtStart();
    noteToolsInside();
}

/// Forward Euler is not stable without.
void Simulation::State::requireDamping(const MaterialMap& materials, Integrator chosen) const
{
    const double least = -materials.largest([](const Material& material) { return -material.dampingRatio; });
    require(
        chosen != Integrator::forwardEuler || least > 0,
        Message("Scene",
                "Forward Euler is not stable without damping: raise the damping ratio, or use semi-implicit Euler."));
}

void Simulation::State::setMasses()
{
    addedMass = 0;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        setMass(b);
        if (massScalingTimeStep && runs[b]->deforms())
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
    const double frequency = frequencyForTimeStep(*massScalingTimeStep / timeStepShare, run.connections.dampingTime());
    std::vector<double> added(run.state.size());
    for (ObjectIndex i = 0; i < added.size(); ++i)
        added[i] = run.connections.contactStiffness(i);
    const std::vector<double> stiffness = run.connections.stiffnessBounds(run.state, added);
    const LaneVector<double> material = run.state.mass;
    for (std::size_t i = 0; i < stiffness.size(); ++i) {
        const double needed = stiffness[i] / (frequency * frequency);
        if (needed <= run.state.mass[i])
            continue;
        addedMass += needed - run.state.mass[i];
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
    findFixtureCenters();
    for (const auto& run : runs)
        run->gripOf.assign(run->state.size(), noFixture);
    for (FixtureId id = 0; id < fixtures.size(); ++id) {
        const auto& fixture = fixtures[id];
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

void Simulation::State::updateTimeStep()
{
    stableStep = std::numeric_limits<double>::infinity();
    double largest = 0;
    for (BodyId b = 0; b < runs.size(); ++b) {
        if (!runs[b]->deforms())
            continue;
        StructuralConnections& connections = runs[b]->connections;
        const double frequency = connections.largestFrequency(runs[b]->state, contacts->addedStiffness(b, crowding));
        largest = std::max(largest, frequency);
        stableStep = std::min(stableStep, integrator == Integrator::forwardEuler
                                              ? stableForwardEulerStep(frequency, connections.leastDampingTime(),
                                                                       connections.dampingTime())
                                              : stableTimeStep(frequency, connections.dampingTime()));
    }
    if (largest == 0)
        stableStep = rigidTimeStep / timeStepShare;
    contacts->updateParameters(largest > 0 ? largest : 1 / rigidTimeStep);
    if (!isImplicit())
        timeStep = wantedTimeStep.value_or(timeStepShare * stableStep);
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
    gripProgress.assign(fixtures.size(), {});
    loads.begin();
    componentsVersion = ~std::uint64_t{0};
    holdFixtures();
    contacts = std::make_unique<Contacts>(contactBodies(), vicinity);
    if (touching == Touching::glued)
        contacts->glueTouching();
    contactReport = {};
    annealings.clear();
    step = 0;
    time = 0;
    lastStep = 0;
    lastKick = 0;
    crowding = 1;
    recentCrowding = 0;
    fastestDriven = 0;
    refills = 0;
    unsolvedSteps = 0;
    unsolvedInRow = 0;
    penetration = 0;
    isPlacedInside = false;
    placedEnergy = 0;
    largestTravel = 0;
    surfaceTravel = 0;
    strayed = 0;
    rest.disturb();
    newlyBroken = false;
    wasSquashed = false;
    wasOverdrawn = false;
    health = {};
    energy = {};
    startEnergy = 0;
    unknownEnergy = 0;
    solverIterations = 0;
    implicit.reset();
    updateTimeStep();
    chooseIntegrator();
    startEnergy = storedEnergy().imbalance;
    lastGood = std::make_shared<const Moment>(moment());
}

} // namespace knead
