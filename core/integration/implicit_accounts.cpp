// How large what a step lacks is, what it must keep, and what it took out. Part of ImplicitEuler.
#include "core/integration/implicit_euler.h"
#include "core/integration/piece_momenta.h"

#include <algorithm>

namespace knead {

namespace {

// Share of what touches a piece that it may lack as a whole.
constexpr double wholeTolerance = 3e-3;

} // namespace

/// In the norm of the preconditioner, squared [J].
double ImplicitEuler::sizeOf(const VectorArray& momenta)
{
    if (m_system.rows() == 0)
        return 0;
    return m_preconditioner.sizeOf(m_system, momenta);
}

/// Size of the residual less what contacts do: what has gone far into a stiff surface within the step would say nothing about the
/// forces that there will be.
double ImplicitEuler::sizeWithoutContacts(const std::vector<ContactTangent>& tangents, double h)
{
    VectorArray rest = m_residual;
    for (const ContactTangent& tangent : tangents) {
        push(endOf(tangent.first, tangent.spread), -h * tangent.force, rest);
        if (tangent.second)
            push(endOf(*tangent.second), h * tangent.force, rest);
    }
    m_system.clearHeld(rest);
    return sizeOf(rest);
}

/// Size of what contacts do in the step, and of the change of momenta: what a residual may be compared with. What it was
/// before the first solution may be far larger, when a tool has gone on by more than the material can give way, or when a
/// stiff body turns.
double ImplicitEuler::sizeOfLoads(const std::vector<ContactTangent>& tangents, double h)
{
    VectorArray loads;
    loads.resize(m_system.rows());
    for (std::size_t b = 0; b < m_bodies.size(); ++b)
        if (m_bodies[b].deforms)
            for (std::size_t i = 0; i < m_bodies[b].state->size(); ++i)
                loads.set(m_first[b] + i,
                          m_bodies[b].state->mass[i] * (m_velocity.at(m_first[b] + i) - m_startVelocity[b].at(i)));
    for (const ContactTangent& tangent : tangents) {
        push(endOf(tangent.first, tangent.spread), h * tangent.force, loads);
        if (tangent.second)
            push(endOf(*tangent.second), -h * tangent.force, loads);
    }
    m_system.clearHeld(loads);
    return sizeOf(loads);
}

/// Whether what each piece as a whole lacks is little by all that touches it. The size of a residual hardly sees that of
/// a stiff block that slides: its preconditioner takes what rubs for what sticks.
bool ImplicitEuler::isBalancedAsAWhole(const std::vector<ContactTangent>& tangents, double h) const
{
    struct Whole {
        Vec3 lack = Vec3::Zero();
        double acts = 0;
        bool isHeld = false;
    };
    std::vector<std::vector<Whole>> wholes;
    for (std::size_t b = 0; b < m_bodies.size(); ++b)
        wholes.emplace_back(piecesOf(b).count);
    const auto touch = [&](const ObjectRef& object, double force) {
        wholes[object.body][piecesOf(object.body).ofObject[object.object]].acts += h * force;
    };
    for (const ContactTangent& tangent : tangents) {
        touch(tangent.first, tangent.force.norm());
        if (tangent.second)
            touch(*tangent.second, tangent.force.norm());
    }
    for (std::size_t b = 0; b < m_bodies.size(); ++b) {
        const ObjectState& state = *m_bodies[b].state;
        for (std::size_t i = 0; m_bodies[b].deforms && i < state.size(); ++i) {
            Whole& whole = wholes[b][piecesOf(b).ofObject[i]];
            whole.lack += m_residual.at(m_first[b] + i);
            whole.isHeld = whole.isHeld || state.inverseMass[i] == 0;
        }
        for (const Whole& whole : wholes[b])
            if (!whole.isHeld && whole.acts > 0 && whole.lack.norm() > wholeTolerance * whole.acts)
                return false;
    }
    return true;
}

double ImplicitEuler::elasticEnergy() const
{
    double sum = 0;
    for (const BodyView& body : m_bodies)
        if (body.deforms)
            sum += body.connections->energy(*body.state);
    return sum;
}

/// Of the trial so far [J].
double ImplicitEuler::flowedEnergy() const
{
    double sum = 0;
    for (const BodyView& body : m_bodies)
        sum += body.connections->flowedEnergy();
    return sum;
}

/// Pieces that touched nothing in any trial and are not held keep their momenta: linear ones to what the solver left over,
/// angular ones to what the scheme takes from anything that turns. A rigid motion of each piece puts them right.
void ImplicitEuler::keepMomenta(const Vec3& gravity, double h)
{
    std::vector<std::vector<std::uint8_t>> touches;
    for (std::size_t b = 0; b < m_bodies.size(); ++b)
        touches.emplace_back(piecesOf(b).count, std::uint8_t{0});
    for (const ObjectRef& object : m_touched)
        touches[object.body][piecesOf(object.body).ofObject[object.object]] = 1;
    for (std::size_t b = 0; b < m_bodies.size(); ++b) {
        if (!m_bodies[b].deforms)
            continue;
        const ObjectState& state = *m_bodies[b].state;
        for (std::size_t i = 0; i < state.size(); ++i)
            if (state.inverseMass[i] == 0)
                touches[b][piecesOf(b).ofObject[i]] = 1;
        if (std::find(touches[b].begin(), touches[b].end(), 0) != touches[b].end())
            keepMomenta(b, touches[b], gravity, h);
    }
}

/// @param touches per piece, 1 where it keeps none
void ImplicitEuler::keepMomenta(std::size_t body, const std::vector<std::uint8_t>& touches, const Vec3& gravity,
                                double h)
{
    ObjectState& state = *m_bodies[body].state;
    const Pieces& pieces = piecesOf(body);
    const std::vector<PieceMomenta> before = momentaOf(state, m_startPosition[body], m_startVelocity[body], pieces);
    const std::vector<PieceMomenta> now = momentaOf(state, state.position, state.velocity, pieces);
    const bool turns = m_bodies[body].connections->structuralFriction() == 0; // else it brakes turns, as published
    std::vector<Vec3> push(pieces.count, Vec3::Zero());
    std::vector<Vec3> spin(pieces.count, Vec3::Zero());
    for (std::size_t p = 0; p < pieces.count; ++p) {
        push[p] = (before[p].linear - now[p].linear + h * now[p].weighed * gravity) / now[p].mass;
        if (turns)
            spin[p] = now[p].spinOf(before[p].angular - now[p].angular);
    }
    for (std::size_t i = 0; i < state.size(); ++i) {
        const std::uint32_t p = pieces.ofObject[i];
        if (touches[p] != 0)
            continue;
        state.velocity.add(i, push[p] + spin[p].cross(state.position.at(i) - now[p].center));
        state.position.add(i, h * push[p]);
    }
}

/// What the work of the forces at the end over the step leaves unexplained: backward Euler takes it out.
double ImplicitEuler::numericalLoss(const Contacts::Report& contacts, double energyChange, double h) const
{
    double loss = -energyChange;
    for (const SurfaceLoad& load : contacts.loads)
        loss += h * load.power;
    loss += h * (contacts.brakingPower + m_loadPower);
    for (std::size_t b = 0; b < m_bodies.size(); ++b) {
        const BodyView& body = m_bodies[b];
        const ObjectState& state = *body.state;
        for (std::size_t i = 0; i < state.size(); ++i) {
            loss -= h * state.force.at(i).dot(state.velocity.at(i));
            if (body.deforms && state.inverseMass[i] > 0)
                loss += 0.5 * state.mass[i] * (state.velocity.at(i) - m_startVelocity[b].at(i)).squaredNorm();
        }
        if (!body.deforms && body.rigid != nullptr) {
            const Vec3 change = body.rigid->velocity() - m_startMotion[b]->velocity();
            const Vec3 turn = body.rigid->angularVelocity() - m_startMotion[b]->angularVelocity();
            loss += 0.5 * (body.rigid->mass() * change.squaredNorm() + turn.dot(body.rigid->inertia() * turn));
        }
    }
    return loss;
}

} // namespace knead
