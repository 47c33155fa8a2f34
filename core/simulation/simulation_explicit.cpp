#include "core/integration/forward_euler.h"
#include "core/integration/semi_implicit_euler.h"
#include "core/integration/shape_damping.h"
#include "core/integration/solver_settings.h"
#include "core/simulation/simulation_state.h"
#include "core/simulation/smallest_spacing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace knead {

namespace {

constexpr const ExplicitSettings& explicitSteps = solverSettings.explicitSteps;

/// What the flow of this step took out of the motion [J]. Where the stress of an object has grown by ds since the last flow, in
/// n = flowInterval equal parts, the scheme has worked with s - ds + (1 + ... + n - 1) ds / n^2 in the mean, and not with the
/// s - ds / 2 that the stored energy loses: less by ds / (2 n), an n-th of what a flow in every step would be off. Objects that flow
/// now and then are off by less: a block that is pressed evenly by all of that, one that a ball is pressed into by 0.43 of it. Half is
/// taken, which leaves the ledger below .6 percent in all.
double workOfFlow(const StructuralConnections& connections)
{
    const double stored = connections.flowedEnergy();
    return stored - 0.5 * (stored - connections.flowWork()) / static_cast<double>(explicitSteps.flowInterval);
}

} // namespace

std::vector<RigidSurface> Simulation::State::surfaces() const
{
    std::vector<RigidSurface> all;
    for (ToolId id = 0; id < tools.size(); ++id)
        if (const auto& tool = tools[id])
            all.push_back({.id = id,
                           .shape = tool->manipulator.shape(),
                           .pose = tool->manipulator.pose,
                           .velocity = tool->velocity,
                           .angularVelocity = tool->angularVelocity,
                           .friction = tool->manipulator.friction,
                           .adhesion = tool->manipulator.adhesion});
    if (around.floorHeight)
        all.push_back({.id = RigidSurface::floorId,
                       .isFloor = true,
                       .pose = {Vec3(0, 0, *around.floorHeight), Quaternion::Identity()},
                       .friction = around.floorFriction,
                       .adhesion = around.floorAdhesion});
    return all;
}

/// Over the step that its velocity is already that of.
void Simulation::State::turnTool(ToolRun& tool, const Quaternion& next) const
{
    Manipulator& manipulator = tool.manipulator;
    const Eigen::AngleAxisd turn(next * manipulator.pose.rotation.conjugate());
    tool.angularVelocity = turn.axis() * (turn.angle() / steps.length);
    manipulator.pose.rotation = next;
    if (!manipulator.rolls())
        return;
    const Vec3 rate = rollingRate(manipulator, tool.velocity, tool.force);
    tool.angularVelocity += rate;
    if (const double angle = rate.norm() * steps.length; angle > 0)
        manipulator.pose.rotation = (Quaternion(Eigen::AngleAxisd(angle, rate.normalized())) * next).normalized();
}

/// As far as the forces of the last step let them.
void Simulation::State::moveManipulators()
{
    travel.ofSurfaces = 0;
    const double spacing = smallestSpacing(bodies);
    for (auto& tool : tools) {
        if (!tool)
            continue;
        Manipulator& manipulator = tool->manipulator;
        const Pose next = yieldTo(tool->force, manipulator, advance(manipulator, steps.time, steps.length),
                                  steps.length, !isImplicit());
        tool->velocity = (next.position - manipulator.pose.position) / steps.length;
        turnTool(*tool, next.rotation);
        manipulator.pose.position = next.position;
        const double speed = tool->velocity.norm() + tool->angularVelocity.norm() * 0.5 * manipulator.size.norm();
        travel.ofSurfaces = std::max(travel.ofSurfaces, speed * steps.length);
        const bool hasJumped = !isImplicit() && speed * steps.length > explicitSteps.jump * spacing;
        if (hasJumped) { // it was put there, and hits nothing
            tool->velocity = tool->angularVelocity = Vec3::Zero();
            watch.isPlacedInside = true;
        }
    }
    turnGrips();
}

void Simulation::State::updateVicinity()
{
    contacts->updateVicinity(surfaces(), travel.largest, travel.ofSurfaces);
    bookTornSkin();
}

/// Ends of broken connections may touch now, and the skin between them does not any more.
void Simulation::State::touchWhereBroken()
{
    contacts->connectionsBroke(surfaces());
    bookTornSkin();
}

void Simulation::State::bookTornSkin()
{
    const double released = contacts->takeReleased();
    contactReport.energy -= released;
    accounts.energy.fracture += released;
}

/// Those that bear too much at present. @return how many they were
std::size_t Simulation::State::breakConnections()
{
    std::size_t broken = 0;
    for (auto& run : runs) {
        if (!run->deforms() || !run->connections.breaks())
            continue;
        const auto report = run->connections.breakOverloaded(run->state, isImplicit() ? 0 : steps.length);
        accounts.energy.fracture += report.released;
        broken += report.broken;
    }
    cracks.areNew = cracks.areNew || broken > 0;
    return broken;
}

void Simulation::State::changeConnections()
{
    if (steps.count % every(explicitSteps.breakingInterval) == 0)
        breakConnections();
    if (steps.count % every(explicitSteps.annealingInterval) == 0)
        anneal();
    if (cracks.areNew && steps.count % every(explicitSteps.touchingInterval) == 0) {
        touchWhereBroken();
        cracks.areNew = false;
    }
}

void Simulation::State::anneal()
{
    const double dt = steps.length * static_cast<double>(every(explicitSteps.annealingInterval));
    for (auto& run : runs)
        if (run->deforms() && run->connections.yields() &&
            run->materials.largest([](const Material& material) { return material.healingTime; }) > 0)
            run->connections.recover(dt);
    for (const Annealing& annealing : annealings) {
        BodyRun& run = *runs[annealing.body];
        const double share = steps.time >= annealing.end ? 1 : -std::expm1(-annealing.rate * dt);
        accounts.energy.plastic += run.connections.renormalize(run.state, annealing.marks, share);
    }
    std::erase_if(annealings, [&](const Annealing& annealing) { return steps.time >= annealing.end; });
}

void Simulation::State::computeForces()
{
    const double flowTime = steps.count % explicitSteps.flowInterval == 0
                                ? static_cast<double>(explicitSteps.flowInterval) * steps.length
                                : 0;
    for (auto& run : runs) {
        if (run->deforms()) {
            run->connections.computeForces(run->state, steps.length, flowTime);
            accounts.energy.plastic += workOfFlow(run->connections);
            run->connections.acceptFlow();
            continue;
        }
        run->state.force.setZero();
        run->state.damping.setZero();
    }
    out.clock.end(Stage::connections);
    contactReport = contacts->computeForces(surfaces(), {.duration = steps.length});
    bookContacts();
    bookLoadsBefore();
    loadFixtures();
}

/// What contacts did in the step, to the ledger and to the tools.
void Simulation::State::bookContacts()
{
    accounts.energy.viscous -= contactReport.brakingPower * steps.length;
    accounts.energy.viscous += contactReport.jointFrictionPower * steps.length;
    accounts.energy.friction -= contactReport.jointFrictionPower * steps.length;
    accounts.energy.plastic += contactReport.plastic;
    accounts.energy.fracture += contactReport.fracture;
    bookPlaced(contactReport);
    std::size_t surface = 0;
    for (auto& tool : tools) {
        if (!tool)
            continue;
        const SurfaceLoad& load = contactReport.loads[surface++];
        accounts.energy.toolWork += load.power * steps.length;
        tool->force = load.force;
        tool->torque = load.torque;
        tool->forceSum += load.force;
        tool->torqueSum += load.torque;
        ++tool->stepsInSum;
        tool->peakForce = std::max(tool->peakForce, load.force.norm());
    }
}

/// What the objects of a fixture lack for moving on evenly is what the fixture gives.
void Simulation::State::loadFixtures()
{
    grips.forces.assign(grips.fixtures.size(), Vec3::Zero());
    grips.moments.assign(grips.fixtures.size(), Vec3::Zero());
    for (FixtureId id = 0; id < grips.fixtures.size(); ++id) {
        if (!grips.fixtures[id])
            continue;
        const ObjectState& state = runs[grips.fixtures[id]->body]->state;
        const LaneVector<double>& weighed = state.weighedMass();
        const Vec3& center = grips.centers[id];
        for (const ObjectIndex object : grips.fixtures[id]->objects) {
            if (object >= state.size())
                continue;
            const Vec3 force = state.force.at(object) + state.damping.at(object) + weighed[object] * around.gravity;
            const Vec3 place = state.position.at(object);
            const Vec3 felt = force - state.mass[object] * centripetal(id, place);
            grips.forces[id] += felt;
            grips.moments[id] += (place - center).cross(felt);
            if (isMovedBy(id, object)) // a rigid body is not moved by any: its velocity is 0
                accounts.energy.toolWork -= force.dot(state.velocity.at(object)) * steps.length;
        }
    }
}

/// Friction is among the braking forces; its share of their work follows from the mean velocities of the step.
void Simulation::State::tellFrictionApart()
{
    const auto meanVelocity = [this](const BodyRun& run, ObjectIndex i) {
        Vec3 velocity = run.state.velocity.at(i);
        if (!isImplicit() && run.deforms() && run.state.inverseMass[i] > 0)
            velocity -= 0.5 * steps.length *
                        (run.state.inverseMass[i] * (run.state.force.at(i) + run.state.damping.at(i)) +
                         run.state.gravityShare(i) * around.gravity);
        return velocity;
    };
    double lost = 0;
    double cut = 0;
    for (const Contacts::Friction& friction : contactReport.frictions) {
        const BodyRun& run = *runs[friction.object.body];
        Vec3 velocity = Vec3::Zero();
        if (friction.spread == nullptr)
            velocity = meanVelocity(run, friction.object.object);
        else
            for (std::uint32_t n = 0; n < friction.spread->count; ++n)
                velocity += friction.spread->weights[n] * meanVelocity(run, friction.spread->objects[n]);
        (friction.cuts ? cut : lost) -= friction.force.dot(velocity - friction.velocity) * steps.length;
    }
    contactReport.frictions.clear();
    accounts.energy.friction += lost;
    accounts.energy.fracture += cut;
    accounts.energy.viscous -= lost + cut;
}

/// Shape damping of a body over a duration [s]. @return energy taken out [J]
double Simulation::State::brakeShape(BodyId body, double duration)
{
    BodyRun& run = *runs[body];
    const double rate = run.materials.materials().front().shapeDamping;
    return rate > 0 && run.deforms() ? dampShape(run.state, rate, duration, piecesOf(body)) : 0;
}

/// Material that yields or is rubberlike gets stiffer as it is squashed, and contacts with tools and the floor as they are pressed,
/// sooner than the stable step is looked at again: where something goes far in a step, the next one is shorter.
/// @param speed of objects [m/s]; tools are looked at here
void Simulation::State::limitTravel(double speed)
{
    for (const auto& tool : tools) {
        if (!tool)
            continue;
        const Manipulator& manipulator = tool->manipulator;
        const Pose next = advance(manipulator, steps.time, steps.length);
        const double turn = next.rotation.angularDistance(manipulator.pose.rotation);
        const double way = (next.position - manipulator.pose.position).norm() + turn * 0.5 * manipulator.size.norm();
        speed = std::max(speed, way / steps.length);
    }
    if (chosen.timeStep || !std::isfinite(speed) || speed <= 0)
        return;
    const double longest = explicitSteps.timeStepShare * steps.stable;
    steps.length = std::min(steps.length, std::max(explicitSteps.farthestInStep * smallestSpacing(bodies) / speed,
                                                   explicitSteps.shortestShare * longest));
}

void Simulation::State::chooseNextStep(double speed)
{
    if (!chosen.timeStep)
        steps.length = explicitSteps.timeStepShare * steps.stable;
    const bool touches = around.floorHeight || contactReport.count > 0;
    const bool stiffens = std::any_of(runs.begin(), runs.end(), [](const auto& run) {
        return run->deforms() && run->connections.stiffensWhenSquashed();
    });
    if (touches || stiffens)
        limitTravel(speed);
}

void Simulation::State::integrate()
{
    const bool leaps = scheme.inUse == Integrator::semiImplicitEuler;
    const double change = leaps && steps.last > 0 ? 0.5 * (steps.last - steps.length) : 0;
    double largestSpeed = 0;
    for (BodyId b = 0; b < runs.size(); ++b) {
        const auto& run = runs[b];
        if (change != 0 && run->rigid)
            run->rigid->kick(run->state, around.gravity, change);
        else if (change != 0 && run->deforms())
            kick(run->state, around.gravity, change);
        StepReport report;
        if (run->rigid) {
            report.dampingWork = run->rigid->advance(run->state, around.gravity, steps.length);
            report.largestSpeed = run->rigid->largestSpeed();
        } else if (run->deforms()) {
            report = scheme.inUse == Integrator::forwardEuler
                         ? forwardEuler(run->state, around.gravity, steps.length)
                         : semiImplicitEuler(run->state, around.gravity, steps.length);
            if (steps.count % explicitSteps.shapeDampingInterval == 0)
                accounts.energy.viscous += brakeShape(b, steps.length * explicitSteps.shapeDampingInterval);
        }
        const bool isNumber = std::isfinite(report.largestSpeed);
        largestSpeed = isNumber ? std::max(largestSpeed, report.largestSpeed) : std::numeric_limits<double>::infinity();
        accounts.energy.viscous -= report.dampingWork;
    }
    tellFrictionApart();
    bookLoadsAfter();
    grips.endTurns(steps.length);
    travel.largest = largestSpeed * steps.length;
    travel.lastKick = steps.length + change;
    steps.last = steps.length;
    chooseNextStep(largestSpeed);
    accounts.unknown = 0;
    steps.time += steps.length;
    ++steps.count;
}

} // namespace knead
