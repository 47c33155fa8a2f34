#include "core/integration/implicit_euler.h"

#include "core/integration/solver_settings.h"
#include "core/task/parallel.h"

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

constexpr std::size_t blockSize = 4096;

} // namespace

ImplicitEuler::ImplicitEuler(std::vector<BodyView> bodies, std::size_t mostHands)
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
    for (std::size_t n = 0; n < mostHands; ++n) {
        m_handIndex.push_back(m_system.rigids().size());
        m_handRow.push_back(m_system.addRigid());
    }
    m_pieceGain.resize(m_bodies.size());
    m_velocity.resize(m_system.rows());
    m_residual.resize(m_system.rows());
}

/// Velocities to begin with: as they are, and pieces that are not held go on changing theirs as a whole as in the last step: they
/// fall, or slide.
void ImplicitEuler::guess(std::size_t body, double h)
{
    const ObjectState& state = *m_bodies[body].state;
    const VectorArray& before = m_startVelocity[body];
    for (std::size_t c = 0; c < 3; ++c)
        std::copy_n(state.velocity.component(c), state.size(), m_velocity.component(c) + m_first[body]);
    const Pieces& pieces = piecesOf(body);
    m_pieceGain[body].assign(pieces.count, Vec3::Zero());
    if (before.size() != state.size() || m_lastStep == 0 || m_wasBalanced)
        return;
    std::vector<Vec3> gained(pieces.count, Vec3::Zero());
    std::vector<double> mass(pieces.count, 0); // infinite where a piece is held
    for (std::size_t i = 0; i < state.size(); ++i) {
        const std::uint32_t piece = pieces.ofObject[i];
        gained[piece] += state.mass[i] * (state.velocity.at(i) - before.at(i));
        mass[piece] += state.inverseMass[i] > 0 ? state.mass[i] : std::numeric_limits<double>::infinity();
    }
    for (std::uint32_t piece = 0; piece < pieces.count; ++piece)
        m_pieceGain[body][piece] = h / m_lastStep / mass[piece] * gained[piece];
    for (std::size_t i = 0; i < state.size(); ++i)
        m_velocity.add(m_first[body] + i, m_pieceGain[body][pieces.ofObject[i]]);
}

/// Of the tool that a hand guides: between where the hand is likely to have it, and along with what it pressed on in the last step,
/// whichever is stiffer. A tool that stays behind a stiff body that goes on, or runs ahead into it, begins the step with forces that
/// Newton's method does not come back from.
Vec3 ImplicitEuler::likelyVelocity(const ToolHand& hand) const
{
    const RigidSurface& tool = m_surfaces[hand.surface];
    const auto press = std::ranges::find(m_presses, tool.id, &Press::tool);
    if (press == m_presses.end())
        return tool.velocity;
    const auto [body, object] = press->object;
    Vec3 along = hand.velocity;
    if (m_bodies[body].deforms)
        along += m_pieceGain[body][piecesOf(body).ofObject[object]];
    return (hand.stiffness * tool.velocity + press->stiffness * along) / (hand.stiffness + press->stiffness);
}

void ImplicitEuler::notePresses(const std::vector<ContactTangent>& tangents, double h)
{
    m_presses.clear();
    for (const ToolHand& hand : m_hands) {
        Press press{.tool = m_surfaces[hand.surface].id, .object = {}};
        for (const ContactTangent& tangent : tangents) {
            if (tangent.second || tangent.surface != hand.surface)
                continue;
            press.stiffness += tangent.normal.dot(tangent.resistance * tangent.normal) / h;
            if (const double force = tangent.force.norm(); force > press.hardest) {
                press.hardest = force;
                press.object = tangent.first;
            }
        }
        if (press.hardest > 0)
            m_presses.push_back(press);
    }
}

void ImplicitEuler::weighPieces()
{
    m_pieceMass.resize(m_bodies.size());
    for (std::size_t b = 0; b < m_bodies.size(); ++b) {
        const ObjectState& state = *m_bodies[b].state;
        const Pieces& pieces = piecesOf(b);
        m_pieceMass[b].assign(pieces.count, 0);
        for (std::size_t i = 0; i < state.size(); ++i)
            m_pieceMass[b][pieces.ofObject[i]] +=
                state.inverseMass[i] > 0 ? state.mass[i] : std::numeric_limits<double>::infinity();
    }
}

/// Of the piece that an object is in; infinite where it does not give way as a whole [kg].
double ImplicitEuler::massAround(const ObjectRef& object) const
{
    return m_pieceMass[object.body][piecesOf(object.body).ofObject[object.object]];
}

/// ContactTangent::drag by the step [kg], where single precision has room for it.
Vec3 ImplicitEuler::dragOf(const ContactTangent& tangent, double h) const
{
    if (tangent.drag.isZero(0))
        return Vec3::Zero();
    double mass = massAround(tangent.first);
    if (tangent.second)
        mass = std::min(mass, massAround(*tangent.second));
    const double stiffness = h * tangent.normal.dot(tangent.resistance * tangent.normal);
    return stiffness <= solverSettings.linear.mostDragged * mass ? Vec3(h * tangent.drag) : Vec3(Vec3::Zero());
}

void ImplicitEuler::rememberStart(double h)
{
    for (std::size_t b = 0; b < m_bodies.size(); ++b) {
        const BodyView& body = m_bodies[b];
        m_startPosition[b] = body.state->position;
        if (body.deforms)
            guess(b, h);
        m_startVelocity[b] = body.state->velocity;
        if (!body.deforms && body.rigid != nullptr) {
            m_startMotion[b] = *body.rigid;
            m_velocity.set(m_first[b], body.rigid->velocity());
            m_velocity.set(m_first[b] + 1, body.rigid->radius() * body.rigid->angularVelocity());
        }
    }
    for (std::size_t n = 0; n < m_handRow.size(); ++n) {
        m_velocity.set(m_handRow[n], n < m_hands.size() ? likelyVelocity(m_hands[n]) : Vec3::Zero());
        m_velocity.set(m_handRow[n] + 1, Vec3::Zero());
    }
}

/// Rows of deformable bodies as their objects move now.
void ImplicitEuler::takeOverVelocities()
{
    for (std::size_t b = 0; b < m_bodies.size(); ++b)
        for (std::size_t c = 0; m_bodies[b].deforms && c < 3; ++c)
            std::copy_n(m_bodies[b].state->velocity.component(c), m_bodies[b].state->size(),
                        m_velocity.component(c) + m_first[b]);
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
    for (std::size_t n = 0; n < m_hands.size(); ++n) {
        RigidSurface& tool = m_surfaces[m_hands[n].surface];
        tool.velocity = m_velocity.at(m_handRow[n]);
        tool.pose.position = m_hands[n].from + h * tool.velocity;
    }
}

Contacts::Report ImplicitEuler::findForces(Contacts& contacts, const ContactStep& step)
{
    for (BodyView& body : m_bodies) {
        if (body.deforms) {
            body.connections->computeForces(*body.state, step.duration, step.duration);
        } else {
            body.state->force.setZero();
            body.state->damping.setZero();
        }
    }
    Contacts::Report report = contacts.computeForces(m_surfaces, step);
    m_loadPower = m_addLoads ? m_addLoads() : 0;
    return report;
}

/// What momenta lack at the velocities tried last: h f - M (v - v0).
void ImplicitEuler::findResidual(const Contacts::Report& contacts, const Vec3& gravity, double h)
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
    for (std::size_t n = 0; n < m_hands.size(); ++n) {
        const ToolHand& hand = m_hands[n];
        const Vec3 place = m_surfaces[hand.surface].pose.position;
        m_residual.set(m_handRow[n], h * (contacts.loads[hand.surface].force + hand.forceAt(place)));
    }
    m_system.clearHeld(m_residual);
}

/// What a contact or a joint pushes against.
LinkEnd ImplicitEuler::secondEnd(const ContactTangent& tangent) const
{
    if (tangent.second)
        return endOf(*tangent.second);
    for (std::size_t n = 0; n < m_hands.size(); ++n)
        if (m_hands[n].surface == tangent.surface)
            return {.row = static_cast<std::uint32_t>(m_handRow[n]), .isRigid = true};
    return {};
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
void ImplicitEuler::updateSystem(const std::vector<ContactTangent>& tangents, double h, Renewal renewal)
{
    if (renewal != Renewal::contacts) {
        m_system.update(h);
        m_linearized = m_velocity;
    }
    for (std::size_t b = 0; b < m_bodies.size(); ++b)
        if (const RigidMotion* rigid = m_bodies[b].rigid; rigid != nullptr && !m_bodies[b].deforms)
            m_system.setRigid(m_rigidIndex[b], rigid->mass(), rigid->inertia() / (rigid->radius() * rigid->radius()));
    std::vector<Link> links;
    links.reserve(tangents.size() + m_hands.size());
    for (const ContactTangent& tangent : tangents)
        links.push_back({.first = firstEnd(tangent),
                         .second = secondEnd(tangent),
                         .matrix = h * tangent.resistance,
                         .drag = dragOf(tangent, h),
                         .normal = tangent.normal});
    for (std::size_t n = 0; n < m_handRow.size(); ++n) {
        if (n >= m_hands.size()) { // there is none: nothing moves it
            m_system.setRigid(m_handIndex[n], 1, Mat3::Identity());
            continue;
        }
        const ToolHand& hand = m_hands[n];
        const double mass = solverSettings.linear.handMassShare * h * h * hand.stiffness;
        m_system.setRigid(m_handIndex[n], mass, mass * Mat3::Identity());
        links.push_back({.first = {.row = static_cast<std::uint32_t>(m_handRow[n]), .isRigid = true},
                         .second = {},
                         .matrix = h * h * hand.stiffnessAt(m_surfaces[hand.surface].pose.position)});
    }
    m_system.setLinks(std::move(links));
    if (m_system.rows() == 0)
        return;
    if (renewal == Renewal::all)
        m_preconditioner.updateBlocks(m_system);
    else
        m_preconditioner.updateLinks(m_system);
    const bool isStale =
        m_presentRate > solverSettings.linear.staleFactor * m_freshRate + solverSettings.linear.staleMore;
    if (m_factoredStep != h || isStale) {
        m_preconditioner.updateClusters(m_system);
        m_factoredStep = h;
        m_freshRate = 0;
    }
}

/// Along any axis, by anything in this step [m].
double ImplicitEuler::goneSinceLinearized(double h) const
{
    double fastest = 0;
    for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t row = 0; row < m_system.rows(); ++row)
            fastest = std::max(fastest, std::abs(m_velocity.component(c)[row] - m_linearized.component(c)[row]));
    return h * fastest;
}

/// Solves the system for the residual and adds what it gives to the velocities. @return iterations
int ImplicitEuler::solve(double goal)
{
    constexpr const LinearSettings& linear = solverSettings.linear;
    const LinearReport report =
        m_system.isSymmetric()
            ? m_conjugateGradients.solve(m_system, m_preconditioner, m_residual, m_velocity, goal,
                                         linear.mostIterations)
            : m_minimalResiduals.solve(m_system, m_preconditioner, m_residual, m_velocity, goal, linear.mostIterations);
    const double decades = 0.5 * std::log10(report.start / report.end);
    if (decades > (m_touched.empty() ? linear.ratedDecades : linear.ratedTouchingDecades)) {
        m_presentRate = report.iterations / decades;
        if (m_freshRate == 0)
            m_freshRate = m_presentRate;
    }
    return report.iterations;
}

Contacts::Report ImplicitEuler::settle(Contacts& contacts, double h)
{
    const Contacts::Report report = findForces(contacts, {.duration = h, .stickSpeed = stickSpeed(h)});
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
    m_presses = m_pressesThen;
}

ImplicitEuler::Report ImplicitEuler::step(Contacts& contacts, std::vector<RigidSurface> surfaces,
                                          std::vector<ToolHand> hands, const Vec3& gravity, double h,
                                          double contactEnergy)
{
    m_surfaces = std::move(surfaces);
    m_hands = std::move(hands);
    rememberStart(h);
    m_pressesThen = m_presses;
    m_lastStep = h;
    contacts.beginStep(m_surfaces, h);
    m_touched.clear();
    m_startEnergy = elasticEnergy() + contactEnergy;
    return findEnd(contacts, gravity, h);
}

ImplicitEuler::Report ImplicitEuler::goOn(Contacts& contacts, const Vec3& gravity, double h, double released)
{
    m_startEnergy -= released;
    return findEnd(contacts, gravity, h);
}

} // namespace knead
