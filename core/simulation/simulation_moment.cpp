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
                  .fixtures = grips.fixtures,
                  .fixtureForces = grips.forces,
                  .gripProgress = grips.progress,
                  .loads = loads.runs(),
                  .annealings = annealings,
                  .contacts = contacts->memory(),
                  .contactEnergy = contactReport.energy,
                  .contactCount = contactReport.count,
                  .around = around,
                  .scheme = scheme,
                  .steps = steps,
                  .accounts = accounts,
                  .watch = watch,
                  .addedMass = massScaling.added};
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
        if (massScaling.timeStep)
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
        if (body.materials.indices().size() != (body.refilled ? body.refilled : refilling.first[b])->size())
            return false;
    }
    return true;
}

void Simulation::State::restore(const Moment& moment)
{
    around = moment.around;
    scheme = moment.scheme;
    steps = moment.steps;
    accounts = moment.accounts;
    watch = moment.watch;
    massScaling.added = moment.addedMass;
    travel = {.recentCrowding = steps.crowding}; // it takes a whole interval without contacts to allow longer steps
    cracks = {};
    rest.disturb();
    tools = moment.tools;
    for (auto& tool : tools)
        if (tool)
            tool->velocity = tool->angularVelocity = Vec3::Zero(); // files do not have them
    grips.fixtures = moment.fixtures;
    grips.forces = moment.fixtureForces;
    grips.moments.clear(); // not kept: the next step finds them
    grips.progress = moment.gripProgress;
    grips.progress.resize(grips.fixtures.size());
    refilling.count = 0;
    for (BodyId b = 0; b < runs.size(); ++b)
        if (const auto& refilled = moment.bodies[b].refilled ? moment.bodies[b].refilled : refilling.first[b];
            refilled != bodies[b].aggregate)
            replaceRun(b, refilled);
    loads.restore(moment.loads, bodies);
    annealings = moment.annealings;
    restoreBodies(moment);
    takeContacts(moment.contacts);
    contactReport = {.energy = moment.contactEnergy, .count = moment.contactCount};
    implicit.reset();
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

/// Goes on from exactly what going back to the moment would make.
void Simulation::State::keepMoment()
{
    const double imbalance = storedEnergy().imbalance;
    const bool knowsForces = travel.lastKick > 0;
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
        kept.accounts.unknown = accounts.unknown = imbalance - storedEnergy().imbalance;
    lastGood = std::make_shared<const Moment>(std::move(kept));
}

void Simulation::State::goTo(MomentPointer moment)
{
    commands.pending.clear();
    out.notice = {};
    if (!isOfThisScene(*moment)) {
        out.notice = Message("History", "The moment belongs to other bodies than these. Nothing was changed.");
        return;
    }
    restore(*moment);
    commands.resets = 0;
    out.penetration = 0;
    commands.recording.clear();
    lastGood = std::move(moment);
}

} // namespace knead
