#include "core/integration/implicit_euler.h"

#include "core/task/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace knead {

namespace {

constexpr std::size_t blockSize = 4096;

// Shares of the residual at the start of a step, by the preconditioned norm. What a step leaves is in the forces at the start
// of the next, so that a body at rest gets as near to balance as rounding allows, whatever these are.
constexpr double newtonTolerance = 1e-2; // at which a step is done
constexpr double linearTolerance = 5e-3; // to which a linear system is solved
// The first one only so far, by what is there: where it leads, contacts and turns are others anyway. Friction is fitted to what the
// next ones give.
constexpr double looseTolerance = 0.1;
constexpr int looseIterations = 1;
constexpr double singleTolerance = 1e-3; // and no solution goes further in single precision
// Share of what acts in the step, at which it is done as well: what is near balance as it is costs no solution.
constexpr double loadTolerance = 1e-3;
constexpr double failedTolerance = 0.3; // above which a step has failed
// Of what was there before the first solution, so much is always enough to compare with: a body that is just let go of by
// all it touched has loads of nothing.
constexpr double leastReference = 1e-6;
constexpr double leastFreeReference = 1e-4; // where nothing touches
constexpr int mostNewtonIterations = 12;
constexpr int mostIterations = 400; // of conjugate gradients for one linear system

// Bodies that would move slower than this, in spacings per step, are at rest: no system is solved for less.
constexpr double restShare = 1e-8;

// Contacts are taken to be as steep at most as so much more than the deepest one of the last step makes them, until those of the
// solution are deeper.
constexpr double steeperShare = 1.2;

// Slides slower than this stick, in spacings per step.
constexpr double stickShare = 3e-4;

// Accelerated iterations that make the residual so much larger, squared, are forgotten and begun anew.
constexpr double mixingLost = 4;

// A line is searched until the force along it is this share of what it was, in so many trials; each within these shares of where it
// must be.
constexpr double lineTolerance = 0.5;
constexpr int mostTrials = 6;
constexpr double nearestTrial = 0.1;
constexpr double farthestTrial = 0.9;

// The coarse factor is found again when iterations per decade have grown by this factor and so many since it was new.
constexpr double staleFactor = 1.5;
constexpr double staleMore = 3;

} // namespace

ImplicitEuler::ImplicitEuler(std::vector<BodyView> bodies)
    : m_bodies(std::move(bodies))
    , m_first(m_bodies.size(), 0)
    , m_rigidIndex(m_bodies.size(), 0)
    , m_startPosition(m_bodies.size())
    , m_startVelocity(m_bodies.size())
    , m_startMotion(m_bodies.size())
{
    for (std::size_t b = 0; b < m_bodies.size(); ++b) {
        const BodyView& body = m_bodies[b];
        m_spacing = std::min(m_spacing, body.connections->aggregate().lattice.spacing);
        if (body.deforms) {
            m_first[b] = m_system.addDeformable(*body.connections, *body.state);
        } else if (body.rigid != nullptr) {
            m_rigidIndex[b] = m_system.rigids().size();
            m_first[b] = m_system.addRigid();
        }
        m_whole.push_back({.ofObject = std::vector<std::uint32_t>(body.state->size(), 0), .count = 1});
        for (std::size_t i = 0; i < body.state->size(); ++i)
            m_mass += body.state->mass[i];
    }
    m_velocity.resize(m_system.rows());
    m_residual.resize(m_system.rows());
}

void ImplicitEuler::rememberStart()
{
    for (std::size_t b = 0; b < m_bodies.size(); ++b) {
        const BodyView& body = m_bodies[b];
        m_startPosition[b] = body.state->position;
        m_startVelocity[b] = body.state->velocity;
        if (body.deforms) {
            for (std::size_t i = 0; i < body.state->size(); ++i)
                m_velocity.set(m_first[b] + i, body.state->velocity.at(i));
        } else if (body.rigid != nullptr) {
            m_startMotion[b] = *body.rigid;
            m_velocity.set(m_first[b], body.rigid->velocity());
            m_velocity.set(m_first[b] + 1, body.rigid->radius() * body.rigid->angularVelocity());
        }
    }
}

/// Rows of deformable bodies as their objects move now.
void ImplicitEuler::takeOverVelocities()
{
    for (std::size_t b = 0; b < m_bodies.size(); ++b)
        for (std::size_t i = 0; m_bodies[b].deforms && i < m_bodies[b].state->size(); ++i)
            m_velocity.set(m_first[b] + i, m_bodies[b].state->velocity.at(i));
}

/// Places and velocities of the objects as the rows of m_velocity have them.
void ImplicitEuler::tryVelocities(double h)
{
    for (std::size_t b = 0; b < m_bodies.size(); ++b) {
        BodyView& body = m_bodies[b];
        if (body.deforms) {
            const VectorArray& start = m_startPosition[b];
            const std::size_t first = m_first[b];
            forEachBlock(start.size(), blockSize, [&](std::size_t begin, std::size_t end) {
                for (std::size_t i = begin; i < end; ++i) {
                    const Vec3 velocity = m_velocity.at(first + i);
                    body.state->velocity.set(i, velocity);
                    body.state->position.set(i, start.at(i) + h * velocity);
                }
            });
        } else if (body.rigid != nullptr) {
            *body.rigid = *m_startMotion[b];
            body.rigid->moveWith(*body.state, m_velocity.at(m_first[b]),
                                 m_velocity.at(m_first[b] + 1) / body.rigid->radius(), h);
        }
    }
}

Contacts::Report ImplicitEuler::findForces(Contacts& contacts, std::span<const RigidSurface> surfaces,
                                           const ContactStep& step)
{
    for (BodyView& body : m_bodies) {
        if (body.deforms) {
            body.connections->computeForces(*body.state, step.duration, step.duration);
        } else {
            body.state->force.setZero();
            body.state->damping.setZero();
        }
    }
    Contacts::Report report = contacts.computeForces(surfaces, step);
    m_loadPower = m_addLoads ? m_addLoads() : 0;
    return report;
}

/// What momenta lack at the velocities tried last: h f - M (v - v0).
void ImplicitEuler::findResidual(const Vec3& gravity, double h)
{
    for (std::size_t b = 0; b < m_bodies.size(); ++b) {
        const BodyView& body = m_bodies[b];
        const ObjectState& state = *body.state;
        const std::size_t first = m_first[b];
        if (body.deforms) {
            forEachBlock(state.size(), blockSize, [&](std::size_t begin, std::size_t end) {
                for (std::size_t i = begin; i < end; ++i)
                    m_residual.set(first + i,
                                   h * (state.force.at(i) + state.damping.at(i)) +
                                       state.mass[i] * (h * state.gravityShare(i) * gravity + m_startVelocity[b].at(i) -
                                                        m_velocity.at(first + i)));
            });
        } else if (body.rigid != nullptr) {
            const RigidMotion& start = *m_startMotion[b];
            const RigidMotion::Load load = body.rigid->loadOf(state, gravity);
            m_residual.set(first, h * load.force + start.mass() * (start.velocity() - body.rigid->velocity()));
            m_residual.set(first + 1, (h * load.torque + start.angularMomentum() - body.rigid->angularMomentum()) /
                                          start.radius());
        }
    }
    m_system.clearHeld(m_residual);
}

/// @param spread of a point between objects; null: the object itself
LinkEnd ImplicitEuler::endOf(const ObjectRef& object, const PointSpread* spread) const
{
    const BodyView& body = m_bodies[object.body];
    if (body.deforms)
        return {.row = static_cast<std::uint32_t>(m_first[object.body] + object.object),
                .spread = spread,
                .firstRow = static_cast<std::uint32_t>(m_first[object.body])};
    if (body.rigid == nullptr)
        return {};
    const Vec3 place = spread != nullptr ? spread->at(body.state->position) : body.state->position.at(object.object);
    return {.row = static_cast<std::uint32_t>(m_first[object.body]),
            .isRigid = true,
            .arm = (place - body.rigid->center()) / body.rigid->radius()};
}

/// The system at the places tried last.
void ImplicitEuler::updateSystem(const std::vector<ContactTangent>& tangents, double h, bool isFirst)
{
    m_system.update(h);
    for (std::size_t b = 0; b < m_bodies.size(); ++b)
        if (const RigidMotion* rigid = m_bodies[b].rigid; rigid != nullptr && !m_bodies[b].deforms)
            m_system.setRigid(m_rigidIndex[b], rigid->mass(), rigid->inertia() / (rigid->radius() * rigid->radius()));
    std::vector<Link> links;
    links.reserve(tangents.size());
    for (const ContactTangent& tangent : tangents)
        links.push_back({.first = endOf(tangent.first, tangent.spread),
                         .second = tangent.second ? endOf(*tangent.second) : LinkEnd{},
                         .matrix = h * tangent.resistance});
    m_system.setLinks(std::move(links));
    if (m_system.rows() == 0)
        return;
    if (isFirst)
        m_preconditioner.updateBlocks(m_system);
    else
        m_preconditioner.updateLinks(m_system);
    const bool isStale = m_presentRate > staleFactor * m_freshRate + staleMore;
    if (m_factoredStep != h || isStale) {
        m_preconditioner.updateClusters(m_system);
        m_factoredStep = h;
        m_freshRate = 0;
    }
}

/// Solves the system for the residual and adds what it gives to the velocities. @return iterations
int ImplicitEuler::solve(double goal)
{
    const ConjugateGradients::Report report =
        m_solver.solve(m_system, m_preconditioner, m_residual, m_velocity, goal, mostIterations);
    const double decades = 0.5 * std::log10(report.start / report.end);
    if (decades > 1) {
        m_presentRate = report.iterations / decades;
        if (m_freshRate == 0)
            m_freshRate = m_presentRate;
    }
    return report.iterations;
}

Contacts::Report ImplicitEuler::settle(Contacts& contacts, std::span<const RigidSurface> surfaces, double h)
{
    const Contacts::Report report =
        findForces(contacts, surfaces, {.duration = h, .stickSpeed = stickShare * m_spacing / h});
    m_steepness = report.steepness;
    return report;
}

void ImplicitEuler::undo()
{
    for (std::size_t b = 0; b < m_bodies.size(); ++b) {
        m_bodies[b].connections->rejectFlow();
        m_bodies[b].state->position = m_startPosition[b];
        m_bodies[b].state->velocity = m_startVelocity[b];
        if (m_startMotion[b])
            *m_bodies[b].rigid = *m_startMotion[b];
    }
}

ImplicitEuler::Report ImplicitEuler::step(Contacts& contacts, std::span<const RigidSurface> surfaces,
                                          const Vec3& gravity, double h, double contactEnergy)
{
    rememberStart();
    contacts.beginStep(surfaces, h);
    m_touched.clear();
    m_startEnergy = elasticEnergy() + contactEnergy;
    return findEnd(contacts, surfaces, gravity, h);
}

ImplicitEuler::Report ImplicitEuler::goOn(Contacts& contacts, std::span<const RigidSurface> surfaces,
                                          const Vec3& gravity, double h, double released)
{
    m_startEnergy -= released;
    return findEnd(contacts, surfaces, gravity, h);
}

/// Where the work of what is lacking is at its most on the way from `start` to m_velocity, about: there its force along the way is none.
/// Whole ways go beyond it where contacts close, and where stick turns to slip. @param look finds the residual at m_velocity
void ImplicitEuler::searchLine(const VectorArray& start, const std::function<void()>& look)
{
    m_way = m_velocity;
    for (std::size_t i = 0; i < m_system.rows(); ++i)
        m_way.add(i, -start.at(i));
    m_system.clearHeld(m_way);
    const double slope = dotProduct(m_residual, m_way);
    double low = 0; // shares before and beyond it, and the forces there
    double atLow = slope;
    double high = 1;
    double atHigh = 0;
    double share = 1;
    for (int trial = 1;; ++trial) {
        look();
        const double now = dotProduct(m_residual, m_way);
        const bool isNear = now >= -lineTolerance * slope && (share == 1 || now <= lineTolerance * slope);
        if (isNear || trial == mostTrials || !(slope > 0))
            return;
        if (now < 0) {
            high = share;
            atHigh = now;
        } else {
            low = share;
            atLow = now;
        }
        // In turns by the chord, and in halves, as forces of contacts are far from straight.
        const double chord = std::clamp(atLow / (atLow - atHigh), nearestTrial, farthestTrial);
        share = low + (high - low) * (trial % 2 == 1 ? chord : 0.5);
        for (std::size_t i = 0; i < m_system.rows(); ++i)
            m_velocity.set(i, start.at(i) + share * m_way.at(i));
    }
}

/// Takes note of what touches in a trial.
void ImplicitEuler::noteTouched(const std::vector<ContactTangent>& tangents)
{
    for (const ContactTangent& tangent : tangents) {
        m_touched.push_back(tangent.first);
        for (std::uint32_t n = 0; tangent.spread != nullptr && n < tangent.spread->count; ++n)
            m_touched.push_back({tangent.first.body, tangent.spread->objects[n]});
        if (tangent.second)
            m_touched.push_back(*tangent.second);
    }
}

/// Newton's iteration, from the velocities in m_velocity.
ImplicitEuler::Report ImplicitEuler::findEnd(Contacts& contacts, std::span<const RigidSurface> surfaces,
                                             const Vec3& gravity, double h)
{
    Report report;
    m_mixing.restart();
    ContactStep step{.duration = h,
                     .stickSpeed = stickShare * m_spacing / h,
                     .isTrial = true,
                     .steepest = std::max(1.0, steeperShare * m_steepness)};
    const auto look = [&] {
        tryVelocities(h);
        report.contacts = findForces(contacts, surfaces, step);
        noteTouched(report.contacts.tangents);
        findResidual(gravity, h);
    };
    const double floor = m_mass * std::pow(restShare * m_spacing / h, 2);
    double first = 0;
    double reference = 0;
    double lastSize = std::numeric_limits<double>::infinity();
    for (look();; ++report.newtonIterations) {
        const std::vector<ContactTangent>& tangents = report.contacts.tangents;
        const bool isFirst = report.newtonIterations == 0;
        const bool isLast = report.newtonIterations == mostNewtonIterations;
        if (isFirst)
            updateSystem(tangents, h, true);
        const double size = sizeOf(m_residual);
        if (isFirst) {
            first = tangents.empty() ? size : std::min(size, sizeWithoutContacts(tangents, h));
            reference = size;
        }
        const double loads = sizeOfLoads(tangents, h);
        if (!isFirst)
            reference =
                std::min(reference, std::max((m_touched.empty() ? leastFreeReference : leastReference) * first, loads));
        const bool isBalanced = size <= std::max({newtonTolerance * newtonTolerance * reference, floor,
                                                  loadTolerance * loadTolerance * loads}) &&
                                (isLast || isBalancedAsAWhole(tangents, h));
        if (isBalanced && report.contacts.steepness > step.steepest && !isLast) {
            step.steepest = steeperShare * report.contacts.steepness;
            look();
            continue; // with contacts as they must be at these forces
        }
        if (isBalanced) {
            keepMomenta(gravity, h);
            if (surfaces.empty() && m_bodies.size() == 1)
                break;
            // What they lacked may have been all of a fall: it must not end inside of something.
            report.contacts = findForces(contacts, surfaces, step);
            if (report.contacts.tangents.empty() || !m_touched.empty() || isLast)
                break;
            takeOverVelocities();
            look();
            continue;
        }
        if (isLast || !std::isfinite(size)) {
            report.converged = size <= failedTolerance * failedTolerance * reference;
            keepMomenta(gravity, h);
            break;
        }
        if (!isFirst)
            updateSystem(tangents, h, false);
        // The first solution brings contacts about; from then on the tangent, which is elastic, is what is wrong where it flows.
        const bool flows = !isFirst && flowedEnergy() > 0;
        if (size > mixingLost * lastSize)
            m_mixing.restart();
        lastSize = size;
        m_scratch = m_velocity;
        const double loose = report.newtonIterations < looseIterations ? looseTolerance : singleTolerance;
        report.iterations +=
            solve(std::max({linearTolerance * linearTolerance * reference, 0.25 * floor, loose * loose * size}));
        if (flows)
            m_mixing.accelerate(m_scratch, m_velocity);
        searchLine(m_scratch, look);
    }
    for (const BodyView& body : m_bodies) {
        for (std::size_t i = 0; i < body.state->size(); ++i) {
            const Vec3 velocity = body.state->velocity.at(i);
            report.dampingWork += h * body.state->damping.at(i).dot(velocity);
            const double speed = velocity.norm();
            if (!(speed <= report.largestSpeed))
                report.largestSpeed = std::isfinite(speed) ? speed : std::numeric_limits<double>::infinity();
        }
    }
    for (const BodyView& body : m_bodies)
        if (body.deforms)
            report.plastic += body.connections->flowWork();
    report.numerical =
        -report.plastic + numericalLoss(report.contacts, elasticEnergy() + report.contacts.energy - m_startEnergy, h);
    return report;
}

} // namespace knead
