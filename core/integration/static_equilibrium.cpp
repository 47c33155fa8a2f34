#include "core/integration/static_equilibrium.h"

#include "core/geometry/disjoint_sets.h"
#include "core/integration/solver_settings.h"
#include "core/task/parallel.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

constexpr std::size_t blockSize = 4096;

constexpr const StaticSettings& balance = solverSettings.balance;

/// Tells how far a solution is: forces that are left fall by about the same factor with every iteration.
class Progress {
public:
    explicit Progress(const StaticEquilibrium::Settings& settings)
        : m_settings(settings)
    {
    }

    void reached(double residual)
    {
        const double share = std::log(std::max(residual, m_settings.tolerance)) / std::log(m_settings.tolerance);
        m_share = std::max(m_share, std::clamp(share, 0.0, 1.0));
        m_settings.control->report(m_share, "finding the balance");
    }

private:
    const StaticEquilibrium::Settings& m_settings;
    double m_share = 0;
};

} // namespace

StaticEquilibrium::StaticEquilibrium(std::vector<BodyView> bodies)
    : m_bodies(std::move(bodies))
    , m_first(m_bodies.size(), 0)
{
    for (std::size_t b = 0; b < m_bodies.size(); ++b) {
        const BodyView& body = m_bodies[b];
        m_spacing = std::min(m_spacing, body.connections->aggregate().lattice.spacing);
        if (!body.deforms)
            continue;
        m_first[b] = m_system.addDeformable(*body.connections, *body.state);
        // c = a sqrt(k / m) of a chain, k and m the mean ones.
        double stiffness = 0;
        double mass = 0;
        Box around;
        for (const LaneVector<double>& along : body.connections->stiffness())
            for (const double k : along)
                stiffness += k;
        stiffness /= static_cast<double>(std::max<std::size_t>(1, body.connections->count()));
        for (std::size_t i = 0; i < body.state->size(); ++i) {
            mass += body.state->mass[i];
            around.extend(body.state->position.at(i));
        }
        mass /= static_cast<double>(body.state->size());
        const double cells = around.diagonal().norm() / body.connections->aggregate().lattice.spacing;
        m_step = std::max(m_step, balance.stepShare * (1 + cells) * std::sqrt(mass / std::max(stiffness, 1e-300)));
    }
    if (m_step == 0)
        m_step = 1;
    m_residual.resize(m_system.rows());
}

Contacts::Report StaticEquilibrium::findForces(const Loads& loads, const std::vector<VectorArray>& start,
                                               bool isBalance)
{
    for (std::size_t b = 0; b < m_bodies.size(); ++b) {
        ObjectState& state = *m_bodies[b].state;
        forEachBlock(state.size(), blockSize, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                state.velocity.set(i, (state.position.at(i) - start[b].at(i)) / m_step);
        });
        if (m_bodies[b].deforms) {
            m_bodies[b].connections->computeForces(state, m_step, loads.flowTime);
        } else {
            state.force.setZero();
        }
        state.damping.setZero(); // nothing moves
    }
    Contacts::Report report =
        loads.contacts->computeForces(loads.surfaces, {.duration = m_step,
                                                       .stickSpeed = balance.stickShare * m_spacing / m_step,
                                                       .isTrial = true,
                                                       .isStatic = true,
                                                       .isBalance = isBalance});
    if (loads.add)
        loads.add();
    return report;
}

/// Forces on the free objects, and the size of what acts: weight, and what held objects and surfaces take, which is all the rest
/// together.
void StaticEquilibrium::findResidual(const Vec3& gravity, const std::vector<ContactTangent>& tangents)
{
    double held = 0;
    double weight = 0;
    for (std::size_t b = 0; b < m_bodies.size(); ++b) {
        const ObjectState& state = *m_bodies[b].state;
        for (std::size_t i = 0; m_bodies[b].deforms && i < state.size(); ++i) {
            const Vec3 own = state.mass[i] * state.gravityShare(i) * gravity;
            const Vec3 force = state.force.at(i) + state.damping.at(i) + own;
            m_residual.set(m_first[b] + i, force);
            weight += own.squaredNorm();
            if (state.inverseMass[i] == 0)
                held += force.squaredNorm();
        }
    }
    m_system.clearHeld(m_residual);
    for (const ContactTangent& tangent : tangents)
        if (!tangent.second)
            held += tangent.force.squaredNorm();
    m_mostActing = std::max(m_mostActing, std::sqrt(held + weight));
    m_acting = std::max(balance.leastActing * m_mostActing, std::sqrt(held + weight));
}

LinkEnd StaticEquilibrium::endOf(const ObjectRef& object, const PointSpread* spread) const
{
    if (!m_bodies[object.body].deforms)
        return {};
    return {.row = static_cast<std::uint32_t>(m_first[object.body] + object.object),
            .spread = spread,
            .firstRow = static_cast<std::uint32_t>(m_first[object.body])};
}

std::vector<Link> StaticEquilibrium::linksOf(const std::vector<ContactTangent>& tangents) const
{
    std::vector<Link> links;
    links.reserve(tangents.size());
    for (const ContactTangent& tangent : tangents)
        links.push_back({.first = endOf(tangent.first, tangent.spread),
                         .second = tangent.second ? endOf(*tangent.second) : LinkEnd{},
                         .matrix = m_step * tangent.resistance});
    return links;
}

/// Whether a connected piece has neither three held objects that are not on one line, nor touches anything.
bool StaticEquilibrium::isFree(const std::vector<ContactTangent>& tangents) const
{
    DisjointSets pieces(m_system.rows() + 1);
    for (std::size_t b = 0; b < m_bodies.size(); ++b)
        if (m_bodies[b].deforms)
            m_bodies[b].connections->forEachConnection(
                [&](ObjectIndex lower, ObjectIndex upper) { pieces.join(m_first[b] + lower, m_first[b] + upper); });
    struct Hold {
        Vec3 sum = Vec3::Zero();
        Mat3 squares = Mat3::Zero();
        double count = 0;
        std::size_t objects = 0;
        bool touches = false;
    };
    std::vector<Hold> holds(m_system.rows());
    for (std::size_t b = 0; b < m_bodies.size(); ++b) {
        const ObjectState& state = *m_bodies[b].state;
        for (std::size_t i = 0; m_bodies[b].deforms && i < state.size(); ++i) {
            Hold& hold = holds[pieces.find(m_first[b] + i)];
            ++hold.objects;
            if (state.inverseMass[i] > 0)
                continue;
            const Vec3 place = state.position.at(i);
            hold.sum += place;
            hold.squares += place * place.transpose();
            hold.count += 1;
        }
    }
    for (const ContactTangent& tangent : tangents) {
        if (const LinkEnd end = endOf(tangent.first); end.row != LinkEnd::immovable)
            holds[pieces.find(end.row)].touches = true;
        if (tangent.second)
            if (const LinkEnd end = endOf(*tangent.second); end.row != LinkEnd::immovable)
                holds[pieces.find(end.row)].touches = true;
    }
    return std::ranges::any_of(holds, [](const Hold& hold) {
        if (hold.objects == 0 || hold.touches)
            return false;
        if (hold.count < 3)
            return hold.objects > hold.count;
        const Mat3 spread = hold.squares - hold.sum * hold.sum.transpose() / hold.count;
        const Vec3 extents = Eigen::SelfAdjointEigenSolver<Mat3>(spread, Eigen::EigenvaluesOnly).eigenvalues();
        return hold.objects > hold.count && extents[1] <= balance.spanShare * extents[2];
    });
}

/// Where Newton's method would go from here [m].
VectorArray StaticEquilibrium::newtonStep(const std::vector<ContactTangent>& tangents, Report& report,
                                          const TaskControl& control)
{
    m_system.update(m_step);
    m_system.setLinks(linksOf(tangents));
    m_preconditioner.updateBlocks(m_system);
    const bool isFirst = m_freshIterations == 0;
    if (isFirst)
        m_preconditioner.updateClusters(m_system);
    VectorArray rest(m_system.rows());
    for (std::size_t i = 0; i < m_system.rows(); ++i)
        rest.set(i, m_step * m_residual.at(i));
    const double size = m_preconditioner.sizeOf(m_system, rest);
    VectorArray way(m_system.rows());
    const ConjugateGradients::Report solved =
        m_solver.solve(m_system, m_preconditioner, rest, way, balance.linearTolerance * balance.linearTolerance * size,
                       balance.mostIterations, [&control] { return control.isCancelled(); });
    control.throwIfCancelled();
    report.iterations += solved.iterations;
    ++report.newtonIterations;
    if (isFirst)
        m_freshIterations = std::max(1, solved.iterations);
    else if (solved.iterations > balance.staleFactor * m_freshIterations)
        m_freshIterations = 0;
    for (std::size_t i = 0; i < m_system.rows(); ++i)
        way.set(i, m_step * way.at(i));
    return way;
}

/// From `place` on, as AndersonMixing makes of the step.
VectorArray StaticEquilibrium::mixed(const VectorArray& place, const VectorArray& step)
{
    VectorArray next = place;
    for (std::size_t i = 0; i < next.size(); ++i)
        next.add(i, step.at(i));
    m_mixing.accelerate(place, next);
    for (std::size_t i = 0; i < next.size(); ++i)
        next.add(i, -place.at(i));
    return next;
}

/// Change of any connection by its length, were the whole way gone.
double StaticEquilibrium::largestStrain(const VectorArray& way) const
{
    double largest = 0;
    for (std::size_t b = 0; b < m_bodies.size(); ++b) {
        const double spacing = m_bodies[b].connections->aggregate().lattice.spacing;
        if (m_bodies[b].deforms)
            m_bodies[b].connections->forEachConnection([&](ObjectIndex lower, ObjectIndex upper) {
                largest = std::max(largest, (way.at(m_first[b] + upper) - way.at(m_first[b] + lower)).norm() / spacing);
            });
    }
    return largest;
}

double StaticEquilibrium::longest(const VectorArray& way)
{
    double squared = 0;
    for (std::size_t i = 0; i < way.size(); ++i)
        squared = std::max(squared, way.at(i).squaredNorm());
    return std::sqrt(squared);
}

void StaticEquilibrium::move(const VectorArray& way, double share)
{
    for (std::size_t b = 0; b < m_bodies.size(); ++b)
        for (std::size_t i = 0; m_bodies[b].deforms && i < m_bodies[b].state->size(); ++i)
            if (m_bodies[b].state->inverseMass[i] > 0)
                m_bodies[b].state->position.add(i, share * way.at(m_first[b] + i));
}

StaticEquilibrium::Report StaticEquilibrium::solve(const Loads& loads, const std::vector<VectorArray>& start,
                                                   const Settings& settings)
{
    Report report;
    Progress progress(settings);
    m_mostActing = 0;
    m_freshIterations = 0;
    m_mixing.restart();
    VectorArray gone(m_system.rows()); // by all steps so far
    report.contacts = findForces(loads, start);
    findResidual(loads.gravity, report.contacts.tangents);
    report.isFree = isFree(report.contacts.tangents);
    while (!report.isFree) {
        const double left = std::sqrt(dotProduct(m_residual, m_residual));
        report.residual = m_acting > 0 ? left / std::max(m_acting, left) : 0;
        report.converged = left <= settings.tolerance * m_acting;
        if (report.converged || !std::isfinite(left) || report.newtonIterations == settings.mostIterations)
            break;
        settings.control->throwIfCancelled();
        progress.reached(report.residual);
        const VectorArray newton = newtonStep(report.contacts.tangents, report, *settings.control);
        VectorArray way = mixed(gone, newton);
        if (!(dotProduct(m_residual, way) > 0)) {
            m_mixing.restart();
            way = newton;
        }
        const double length = longest(way);
        double share = std::min({1.0, balance.largestStretch / std::max(largestStrain(way), 1e-300),
                                 loads.farthestStep / std::max(length, 1e-300)});
        const double slope = dotProduct(m_residual, way);
        double done = 0;
        for (int trial = 0; trial < balance.mostTrials; ++trial) {
            move(way, share - done);
            if (loads.moved)
                loads.moved(std::abs(share - done) * length);
            done = share;
            report.contacts = findForces(loads, start);
            findResidual(loads.gravity, report.contacts.tangents);
            const double now = dotProduct(m_residual, way);
            if (now >= -balance.lineTolerance * slope || !(slope > 0))
                break;
            share *= std::max(balance.shortestTrial, slope / (slope - now));
        }
        for (std::size_t i = 0; i < gone.size(); ++i)
            gone.add(i, done * way.at(i));
    }
    if (report.converged) {
        report.contacts = findForces(loads, start, true);
        for (std::size_t b = 0; b < m_bodies.size(); ++b)
            for (std::size_t i = 0; i < m_bodies[b].state->size(); ++i)
                report.farthest =
                    std::max(report.farthest, (m_bodies[b].state->position.at(i) - start[b].at(i)).norm());
    }
    return report;
}

} // namespace knead
