#include "verify/experiment.h"

#include "core/skin/deformed_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace knead::book {

namespace {

constexpr double restShare = 1e-7;             // of stored energy, that may be in motion at rest: 3e-4 of forces
constexpr double steadyShare = 1e-4;           // of stored energy, that may come or go between two looks
constexpr std::size_t pictureTriangles = 2500; // of the shape on the page

double turnover(const EnergyLedger& energy)
{
    return std::max({std::abs(energy.toolWork), energy.dissipated(), energy.kinetic + energy.elastic});
}

} // namespace

void Experiment::runUntil(double time)
{
    while (m_simulation.time() < time && m_simulation.health().ok)
        m_simulation.step();
    if (!m_simulation.health().ok)
        throw Problem(m_simulation.health().message);
    notice(*m_simulation.snapshot());
}

void Experiment::settle(double latest, double look)
{
    double stored = -1;
    while (m_simulation.time() < latest) {
        runUntil(std::min(latest, m_simulation.time() + look));
        const EnergyLedger energy = m_simulation.snapshot()->energy;
        const double now = energy.elastic + energy.contact;
        if (energy.kinetic <= restShare * now && std::abs(now - stored) <= steadyShare * now)
            break;
        stored = now;
    }
}

std::vector<Vec3> Experiment::meanToolForces(double duration)
{
    m_simulation.snapshot(); // the mean begins here
    runUntil(m_simulation.time() + 0.5 * m_simulation.timeStep());
    const double end = m_simulation.time() + duration;
    while (m_simulation.time() < end && m_simulation.health().ok)
        m_simulation.step();
    std::vector<Vec3> forces;
    for (const ToolState& tool : m_simulation.snapshot()->tools)
        forces.push_back(tool.force);
    return forces;
}

void Experiment::notice(const Snapshot& shot)
{
    m_imbalance = std::max(m_imbalance, std::abs(shot.energy.imbalance));
}

Outcome Experiment::outcome(std::vector<double> values, const TriangleMesh& mesh)
{
    const auto shot = m_simulation.snapshot();
    notice(*shot);
    Outcome outcome{.values = std::move(values)};
    outcome.seconds = static_cast<double>(std::clock() - m_start) / CLOCKS_PER_SEC;
    outcome.picture =
        deformedSurface(mesh, *shot->bodies[0].aggregate, shot->bodies[0].displacements(), pictureTriangles);
    outcome.objects = shot->objects;
    outcome.spacing = shot->bodies[0].aggregate->lattice.spacing;
    outcome.imbalance = m_imbalance / std::max(turnover(shot->energy), 1e-300);
    return outcome;
}

Outcome guarded(std::size_t quantities, const std::function<Outcome()>& run)
{
    try {
        return run();
    } catch (const std::exception& error) {
        Outcome outcome;
        outcome.values.assign(quantities, std::numeric_limits<double>::quiet_NaN());
        outcome.trouble = error.what();
        return outcome;
    }
}

Motion gentleWay(const Pose& from, const Vec3& way, double begin, double end)
{
    constexpr int parts = 24;
    FollowKeyFrames motion;
    for (int i = 0; i <= parts; ++i) {
        const double t = static_cast<double>(i) / parts;
        motion.frames.push_back({begin + t * (end - begin), {from.position + gentle(t) * way, from.rotation}});
    }
    return motion;
}

} // namespace knead::book
