// Load steps without inertia.
#include "core/integration/solver_settings.h"
#include "core/integration/static_equilibrium.h"
#include "core/simulation/simulation_state.h"
#include "core/simulation/smallest_spacing.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace knead {

namespace {

constexpr double longestLoadStep = 3600; // [s]
Message subjectOf(const Body& body)
{
    return body.name.empty() ? Message("Balance", "The body") : Message::verbatim("\"" + body.name + "\"");
}

std::string inScientific(double number)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.1e", number);
    return text;
}

double diagonalOf(const std::vector<Body>& bodies)
{
    Box around;
    for (const Body& body : bodies)
        for (ObjectIndex i = 0; i < body.aggregate->size(); ++i)
            around.extend(body.aggregate->lattice.position(i));
    return around.diagonal().norm();
}

} // namespace

/// One part of a load step. @return whether there is balance at its end; else the state is anything
bool Simulation::State::balance(double duration, TaskControl& control, StaticReport& report)
{
    steps.length = duration;
    const double imbalance = storedEnergy().imbalance;
    changeConnections();
    for (auto& run : runs)
        run->state.velocity.setZero();
    holdFixtures();
    moveManipulators();
    updateVicinity();

    std::vector<StaticEquilibrium::BodyView> views;
    std::vector<VectorArray> start;
    double gripTravel = 0;
    for (auto& run : runs) {
        views.push_back({.state = &run->state, .connections = &run->connections, .deforms = run->deforms()});
        start.push_back(run->state.position);
        for (std::size_t i = 0; run->deforms() && i < run->state.size(); ++i)
            if (run->state.inverseMass[i] == 0) {
                run->state.position.add(i, duration * run->state.velocity.at(i));
                gripTravel = std::max(gripTravel, duration * run->state.velocity.at(i).norm());
            }
    }
    StaticEquilibrium equilibrium(std::move(views));
    // Velocities are ways by a time of its own there, so that dampers and masses have no say.
    const double slower = duration / equilibrium.waySeconds();
    std::vector<RigidSurface> moved = surfaces();
    for (RigidSurface& surface : moved) {
        surface.velocity *= slower;
        surface.angularVelocity *= slower;
    }
    StaticEquilibrium::Loads acting{
        .contacts = contacts.get(), .surfaces = moved, .gravity = around.gravity, .add = {}, .flowTime = duration};
    acting.moved = [&](double way) { contacts->updateVicinity(moved, way, 0); };
    acting.moved(gripTravel);
    if (!moved.empty() || bodies.size() > 1)
        acting.farthestStep = solverSettings.balance.farthestStep * smallestSpacing(bodies);
    if (!loads.empty())
        acting.add = [&] { return addLoads(steps.time + duration); };
    const StaticEquilibrium::Report found = equilibrium.solve(acting, start, {.control = &control});
    report.residual = found.residual;
    report.iterations += found.newtonIterations;
    scheme.iterations = found.iterations;
    if (found.isFree)
        report.message = Message(
            "Balance", "A body is free to move: hold it, or let time run (dynamic) until it rests on something.");
    if (!found.converged || found.farthest > solverSettings.balance.lostShare * diagonalOf(bodies))
        return false;
    watch.isPlacedInside = false; // all that was put into material has been pushed out
    for (auto& run : runs) {
        accounts.energy.plastic += run->connections.flowWork();
        run->connections.acceptFlow();
    }

    // Forces and ways belong together: the work of the forces at the end on the way there.
    steps.length = equilibrium.waySeconds();
    contactReport = found.contacts;
    bookContacts();
    tellFrictionApart();
    bookLoadsAfter();
    steps.length = duration;
    for (auto& run : runs)
        for (std::size_t i = 0; i < run->state.size(); ++i)
            run->state.velocity.set(i, run->state.velocity.at(i) / slower);
    loadFixtures();
    grips.endTurns(steps.length);
    for (auto& run : runs)
        run->state.velocity.setZero();
    holdFixtures();
    steps.last = travel.lastKick = duration;
    accounts.unknown = 0;
    steps.time += duration;
    accounts.energy.numerical -= storedEnergy().imbalance - imbalance;
    travel.largest = found.farthest;
    return true;
}

StaticReport Simulation::State::findBalance(double duration, TaskControl& control)
{
    StaticReport report;
    if (!(duration > 0 && duration <= longestLoadStep)) {
        report.message = Message("Balance", "A load step takes more than 0 and up to 3600 s.");
        return report;
    }
    if (!isImplicit())
        setIntegrator(Integrator::implicitEuler);
    implicit.reset();
    for (std::size_t b = 0; b < runs.size(); ++b)
        if (runs[b]->rigid) {
            report.message =
                Message("Balance",
                        "%1 is rigid and free to move: hold it, make it deformable, or let time run (dynamic).")
                    .with(subjectOf(bodies[b]));
            return report;
        }
    const Moment before = moment();
    const double end = steps.time + duration;
    double part = duration;
    for (int halvings = 0; end - steps.time > 1e-9 * duration;) {
        const Moment here = moment();
        if (balance(std::min(part, end - steps.time), control, report)) {
            ++report.parts;
            continue;
        }
        restore(here);
        if (!report.message.empty() || ++halvings > solverSettings.balance.mostParts)
            break;
        part /= 2;
    }
    report.converged = end - steps.time <= 1e-9 * duration;
    if (!report.converged) {
        restore(before);
        if (report.message.empty())
            report.message =
                Message("Balance",
                        "No balance was found at %1 s: forces of %2 of those that act are left. Take more load steps "
                        "or a smaller load, hold what is free to slide or turn, or let time run (dynamic).")
                    .with(std::to_string(end), inScientific(report.residual));
        return report;
    }
    ++steps.count;
    steps.length = duration; // events are due at the nearest load step
    return report;
}

/// The same for a person: nothing is left of it where it fails, and time runs afterwards as it was chosen. Begins with a moment
/// that is kept, so that the state is the same whether it was tried and given up or not.
StaticReport Simulation::State::settle(double duration, TaskControl& control)
{
    const Integrator wanted = scheme.wanted;
    keepMoment();
    const MomentPointer before = lastGood;
    StaticReport report;
    try {
        report = findBalance(duration, control);
    } catch (...) {
        restore(*before);
        throw;
    }
    if (report.converged)
        checkHealth();
    if (!watch.health.ok)
        report = {.message = watch.health.message};
    if (report.converged)
        setIntegrator(wanted);
    else
        restore(*before);
    implicit.reset();
    return report;
}

StaticReport Simulation::settle(const FindBalance& command, TaskControl& control)
{
    State& state = *m_state;
    control.throwIfCancelled();
    state.applyCommands();
    if (!state.watch.health.ok)
        return {.message = state.watch.health.message};
    const std::uint64_t before = state.steps.count;
    const auto record = [&](const Command& done) { state.commands.recording.push_back({before, done}); };
    try {
        StaticReport report = state.settle(command.duration, control);
        record(report.converged ? Command(command) : Command(KeepMoment{}));
        return report;
    } catch (const Cancelled&) {
        record(KeepMoment{});
        throw;
    }
}

StaticReport Simulation::findBalance(double duration)
{
    m_state->applyCommands();
    if (!m_state->watch.health.ok)
        return {.message = m_state->watch.health.message};
    StaticReport report = m_state->findBalance(duration, TaskControl::none());
    if (report.converged) {
        m_state->checkHealth();
        if (!m_state->watch.health.ok)
            return {.message = m_state->watch.health.message};
    }
    return report;
}

} // namespace knead
