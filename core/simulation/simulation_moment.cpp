// Keeping moments and going back to them.
#include "core/simulation/simulation_state.h"

#include <algorithm>

namespace knead {

void ToolRun::findMeans()
{
    if (stepsInSum == 0)
        return;
    meanForce = forceSum / stepsInSum;
    meanTorque = torqueSum / stepsInSum;
    forceSum.setZero();
    torqueSum.setZero();
    stepsInSum = 0;
}

Moment Simulation::State::moment() const
{
    Moment moment{.bodies = {},
                  .tools = tools,
                  .fixtures = fixtures,
                  .fixtureForces = fixtureForces,
                  .gripProgress = gripProgress,
                  .loads = loads.runs(),
                  .annealings = annealings,
                  .contacts = contacts->memory(),
                  .contactEnergy = contactReport.energy,
                  .contactCount = contactReport.count,
                  .gravity = gravity,
                  .floorHeight = floorHeight,
                  .floorFriction = floorFriction,
                  .floorAdhesion = floorAdhesion,
                  .wantedIntegrator = wantedIntegrator,
                  .integrator = integrator,
                  .integratorReason = integratorReason,
                  .solverIterations = solverIterations,
                  .pace = pace,
                  .step = step,
                  .time = time,
                  .timeStep = timeStep,
                  .lastStep = lastStep,
                  .stableStep = stableStep,
                  .crowding = crowding,
                  .unsolvedSteps = unsolvedSteps,
                  .unsolvedInRow = unsolvedInRow,
                  .isPlacedInside = isPlacedInside,
                  .placedEnergy = placedEnergy,
                  .addedMass = addedMass,
                  .energy = energy,
                  .startEnergy = startEnergy,
                  .unknownEnergy = unknownEnergy,
                  .wasSquashed = wasSquashed,
                  .health = health};
    for (const auto& run : runs) {
        Moment::BodyMoment body{.materials = run->materials,
                                .kind = run->kind,
                                .changes = run->connections.changes(),
                                .fastestMode = run->connections.fastestMode()};
        if (run->rigid) {
            body.rigid = run->rigid->memory();
        } else {
            body.position = run->state.position;
            body.velocity = run->state.velocity;
        }
        if (massScalingTimeStep)
            body.mass = run->state.mass;
        if (const auto id = static_cast<BodyId>(moment.bodies.size()); !isFirstFilling(id))
            body.refilled = bodies[id].aggregate;
        moment.bodies.push_back(std::move(body));
    }
    forgetTurns(moment);
    return moment;
}

bool Simulation::State::isOfThisScene(const Moment& moment) const
{
    if (moment.bodies.size() != runs.size())
        return false;
    for (std::size_t b = 0; b < runs.size(); ++b) {
        const Moment::BodyMoment& body = moment.bodies[b];
        if (body.materials.indices().size() != (body.refilled ? body.refilled : firstFillings[b])->size())
            return false;
    }
    return true;
}

void Simulation::State::restore(const Moment& moment)
{
    step = moment.step;
    time = moment.time;
    timeStep = moment.timeStep;
    lastStep = moment.lastStep;
    lastKick = 0; // the forces of that step are not kept
    stableStep = moment.stableStep;
    crowding = moment.crowding;
    recentCrowding = crowding; // not kept: it takes a whole interval without contacts to allow longer steps
    fastestDriven = 0;
    unsolvedSteps = moment.unsolvedSteps;
    unsolvedInRow = moment.unsolvedInRow;
    isPlacedInside = moment.isPlacedInside;
    placedEnergy = moment.placedEnergy;
    addedMass = moment.addedMass;
    energy = moment.energy;
    startEnergy = moment.startEnergy;
    unknownEnergy = moment.unknownEnergy;
    wasSquashed = moment.wasSquashed;
    wasOverdrawn = false;
    health = moment.health;
    gravity = moment.gravity;
    floorHeight = moment.floorHeight;
    floorFriction = moment.floorFriction;
    floorAdhesion = moment.floorAdhesion;
    wantedIntegrator = moment.wantedIntegrator;
    integrator = moment.integrator;
    integratorReason = moment.integratorReason;
    solverIterations = moment.solverIterations;
    pace = moment.pace;
    tools = moment.tools;
    for (auto& tool : tools)
        if (tool)
            tool->velocity = tool->angularVelocity = Vec3::Zero(); // files do not have them
    fixtures = moment.fixtures;
    fixtureForces = moment.fixtureForces;
    fixtureMoments.clear(); // not kept: the next step finds them
    gripProgress = moment.gripProgress;
    gripProgress.resize(fixtures.size());
    refills = 0;
    for (BodyId b = 0; b < runs.size(); ++b)
        if (const auto& refilled = moment.bodies[b].refilled ? moment.bodies[b].refilled : firstFillings[b];
            refilled != bodies[b].aggregate)
            replaceRun(b, refilled);
    loads.restore(moment.loads, bodies);
    annealings = moment.annealings;
    restoreBodies(moment);
    restoreContacts(moment);
    implicit.reset();
    largestTravel = 0;
    surfaceTravel = 0;
    strayed = 0;
    rest.disturb();
    newlyBroken = false;
    componentsVersion = ~std::uint64_t{0};
}

/// Materials, tools' and fixtures' turn has been; masses come before what moves with them.
void Simulation::State::restoreBodies(const Moment& moment)
{
    for (std::size_t b = 0; b < runs.size(); ++b) {
        BodyRun& run = *runs[b];
        const Moment::BodyMoment& body = moment.bodies[b];
        bodies[b].material = body.materials.materials().front();
        bodies[b].kind = run.kind = body.kind;
        run.materials = body.materials;
        run.connections.restore(body.changes);
        run.pieces.forget();
        run.connections.setFastestMode(body.fastestMode);
        setMass(b);
        if (!body.mass.empty() && run.state.mass != body.mass) {
            run.state.trueMass = run.state.mass;
            run.state.mass = body.mass;
        }
        run.state.force.setZero();
        run.state.damping.setZero();
        run.rigid.reset();
        if (body.rigid) {
            run.rigid.emplace(*body.rigid, run.state.mass);
            run.rigid->place(run.state);
        } else {
            run.state.position = body.position;
            run.state.velocity = body.velocity;
        }
    }
    holdFixtures();
}

void Simulation::State::restoreContacts(const Moment& moment)
{
    contacts = std::make_unique<Contacts>(contactBodies(), vicinity, moment.contacts);
    contacts->setScheme({}, isImplicit());
    contactReport = {.energy = moment.contactEnergy, .count = moment.contactCount};
}

/// Goes on from exactly what going back to the moment would make.
void Simulation::State::keepMoment()
{
    const double imbalance = storedEnergy().imbalance;
    const bool knowsForces = lastKick > 0;
    touchWhereBroken();
    for (auto& run : runs)
        if (run->rigid)
            run->rigid->place(run->state);
    for (auto& tool : tools)
        if (tool)
            tool->findMeans();
    Moment kept = moment();
    restore(kept);
    if (knowsForces)
        kept.unknownEnergy = unknownEnergy = imbalance - storedEnergy().imbalance;
    lastGood = std::make_shared<const Moment>(std::move(kept));
}

void Simulation::State::goTo(MomentPointer moment)
{
    pending.clear();
    notice = {};
    if (!isOfThisScene(*moment)) {
        notice = Message("History", "The moment belongs to other bodies than these. Nothing was changed.");
        return;
    }
    restore(*moment);
    resets = 0;
    penetration = 0;
    recording.clear();
    lastGood = std::move(moment);
}

} // namespace knead
