// How large what a step lacks is, what it must keep, and what it took out. Part of ImplicitEuler.
#include "core/integration/implicit_euler.h"
#include "core/integration/piece_momenta.h"
#include "core/integration/solver_settings.h"
#include "core/task/block_sums.h"

#include <algorithm>

namespace knead {

namespace {

constexpr std::size_t blockSize = 4096;

/// Of state.damping [W].
double dampingPower(const ObjectState& state)
{
    return sumOverBlocks(state.size(), blockSize, [&](std::size_t begin, std::size_t end) {
        double power = 0;
        for (std::size_t i = begin; i < end; ++i)
            power += state.damping.at(i).dot(state.velocity.at(i));
        return power;
    });
}

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
    m_momenta = m_residual;
    addContacts(tangents, -h);
    return sizeOf(m_momenta);
}

/// What contacts give in a time, to m_momenta.
void ImplicitEuler::addContacts(const std::vector<ContactTangent>& tangents, double duration)
{
    for (const ContactTangent& tangent : tangents) {
        push(firstEnd(tangent), duration * tangent.force, m_momenta);
        push(secondEnd(tangent), -duration * tangent.force, m_momenta);
    }
    m_system.clearHeld(m_momenta);
}

/// Size of what contacts do in the step, and of the change of momenta: what a residual may be compared with. What it was
/// before the first solution may be far larger, when a tool has gone on by more than the material can give way, or when a
/// stiff body turns.
double ImplicitEuler::sizeOfLoads(const std::vector<ContactTangent>& tangents, double h)
{
    if (m_momenta.size() != m_system.rows())
        m_momenta.resize(m_system.rows());
    m_momenta.setZero();
    for (std::size_t b = 0; b < m_bodies.size(); ++b)
        if (m_bodies[b].deforms) {
            const LaneVector<double>& mass = m_bodies[b].state->mass;
            const std::size_t first = m_first[b];
            forEachBlock(mass.size(), blockSize, [&](std::size_t begin, std::size_t end) {
                for (std::size_t c = 0; c < 3; ++c)
                    for (std::size_t i = begin; i < end; ++i)
                        m_momenta.component(c)[first + i] =
                            mass[i] * (m_velocity.component(c)[first + i] - m_startVelocity[b].component(c)[i]);
            });
        }
    addContacts(tangents, h);
    return sizeOf(m_momenta);
}

/// A piece of a body as a whole.
struct ImplicitEuler::Whole {
    Vec3 lack = Vec3::Zero();   ///< of momentum [N s]
    Vec3 normal = Vec3::Zero(); ///< sum of how skins push it [N s]
    double pushed = 0;          ///< of the same without directions [N s]
    double acts = 0;            ///< of all that touches it, without directions [N s]
    double mass = 0;            ///< [kg]
    Vec3 gain = Vec3::Zero();   ///< of momentum in the step [N s]
    Vec3 before = Vec3::Zero(); ///< momentum at its start [N s]
    double weight = 0;          ///< momentum that its weight gives it in the step [N s]
    double rest = 0;            ///< momentum that is none [N s]
    bool isHeld = false;
    bool hasTouched = false; ///< something, in a trial of the step

    /// Of the lack, along what it stands on; all of it where that is not flat.
    Vec3 sliding() const
    {
        if (normal.norm() < solverSettings.newton.flatShare * pushed)
            return lack;
        const Vec3 up = normal.normalized();
        return lack - lack.dot(up) * up;
    }

    /// The lack by what it may be. What touched in a trial, and touches nothing now, may have been lifted off by a step that went
    /// too far: it flies only if it falls.
    /// @param leastShare of the gain of momentum, which at least is to compare with: what flies and grazes something touches nearly nothing
    double share(double leastShare) const
    {
        if (isHeld || !hasTouched || lack.norm() <= rest)
            return 0;
        const double compared = acts > 0 ? std::max(acts, leastShare * gain.norm())
                                         : std::max(weight, solverSettings.newton.flyingShare * before.norm());
        if (compared == 0)
            return 0;
        const Vec3 side = sliding();
        return std::max(side.norm() / solverSettings.newton.wholeTolerance,
                        (lack - side).norm() / solverSettings.newton.pushedTolerance) /
               compared;
    }
};

/// Per body and piece.
std::vector<std::vector<ImplicitEuler::Whole>> ImplicitEuler::wholesOf(const std::vector<ContactTangent>& tangents,
                                                                       double h) const
{
    std::vector<std::vector<Whole>> wholes;
    for (std::size_t b = 0; b < m_bodies.size(); ++b)
        wholes.emplace_back(piecesOf(b).count);
    const auto touch = [&](const ObjectRef& object, const Vec3& force, const Vec3& normal) {
        Whole& whole = wholes[object.body][piecesOf(object.body).ofObject[object.object]];
        const double push = force.dot(normal);
        whole.acts += h * force.norm();
        whole.normal += h * push * normal;
        whole.pushed += h * std::abs(push);
    };
    for (const ObjectRef& object : m_touched)
        wholes[object.body][piecesOf(object.body).ofObject[object.object]].hasTouched = true;
    for (const ContactTangent& tangent : tangents) {
        if (tangent.spread == nullptr)
            touch(tangent.first, tangent.force, tangent.normal);
        else
            for (std::uint32_t n = 0; n < tangent.spread->count; ++n)
                touch({tangent.first.body, tangent.spread->objects[n]}, tangent.spread->weights[n] * tangent.force,
                      tangent.normal);
        if (tangent.second)
            touch(*tangent.second, -tangent.force, tangent.normal);
    }
    for (std::size_t b = 0; b < m_bodies.size(); ++b) {
        const ObjectState& state = *m_bodies[b].state;
        for (std::size_t i = 0; m_bodies[b].deforms && i < state.size(); ++i) {
            Whole& whole = wholes[b][piecesOf(b).ofObject[i]];
            whole.lack += m_residual.at(m_first[b] + i);
            whole.mass += state.mass[i];
            whole.weight += h * state.weighedMass()[i] * m_gravity.norm();
            whole.before += state.mass[i] * m_startVelocity[b].at(i);
            whole.gain += state.mass[i] * (m_velocity.at(m_first[b] + i) - m_startVelocity[b].at(i));
            whole.isHeld = whole.isHeld || state.inverseMass[i] == 0;
        }
        for (Whole& whole : wholes[b])
            whole.rest = whole.mass * solverSettings.newton.restShare * m_spacing / h;
    }
    return wholes;
}

/// What a piece as a whole lacks at most, by all that touches it; up to 1 it is balanced. The size of a residual hardly sees that
/// of a stiff block that slides: its preconditioner takes what rubs for what sticks.
/// @param leastShare see Whole::share()
double ImplicitEuler::lackOfWholes(const std::vector<ContactTangent>& tangents, double h, double leastShare) const
{
    double most = 0;
    if (m_touched.empty())
        return most;
    for (const std::vector<Whole>& ofBody : wholesOf(tangents, h))
        for (const Whole& whole : ofBody)
            most = std::max(most, whole.share(leastShare));
    return most;
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
        if (std::ranges::find(touches[b], 0) != touches[b].end())
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
        loss += sumOverBlocks(state.size(), blockSize, [&](std::size_t begin, std::size_t end) {
            double sum = 0;
            for (std::size_t i = begin; i < end; ++i) {
                sum -= h * state.force.at(i).dot(state.velocity.at(i));
                if (body.deforms && state.inverseMass[i] > 0)
                    sum += 0.5 * state.mass[i] * (state.velocity.at(i) - m_startVelocity[b].at(i)).squaredNorm();
            }
            return sum;
        });
        if (!body.deforms && body.rigid != nullptr) {
            const Vec3 change = body.rigid->velocity() - m_startMotion[b]->velocity();
            const Vec3 turn = body.rigid->angularVelocity() - m_startMotion[b]->angularVelocity();
            loss += 0.5 * (body.rigid->mass() * change.squaredNorm() + turn.dot(body.rigid->inertia() * turn));
        }
    }
    return loss;
}

/// What the step did, at its end.
void ImplicitEuler::account(Report& report, double h) const
{
    for (const BodyView& body : m_bodies) {
        report.largestSpeed = std::max(report.largestSpeed, largestSpeed(*body.state));
        report.dampingWork += h * dampingPower(*body.state);
        if (body.deforms)
            report.plastic += body.connections->flowWork();
    }
    report.numerical =
        -report.plastic + numericalLoss(report.contacts, elasticEnergy() + report.contacts.energy - m_startEnergy, h);
}

} // namespace knead
