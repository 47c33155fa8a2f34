// How the end of a step is found: Newton's method, and when it is done. Part of ImplicitEuler.
#include "core/integration/implicit_euler.h"

#include "core/integration/solver_settings.h"
#include "core/task/parallel.h"

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

constexpr std::size_t blockSize = 4096;

constexpr const NewtonSettings& newton = solverSettings.newton;

} // namespace

/// Calls change(component, row) for all numbers of a vector of the system, on all threads.
template <typename Change>
void ImplicitEuler::forEachNumber(Change&& change) const
{
    forEachBlock(m_system.rows(), blockSize, [&](std::size_t begin, std::size_t end) {
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t i = begin; i < end; ++i)
                change(c, i);
    });
}

/// Where the work of what is lacking is at its most on the way from `start` to m_velocity, about: there its force along the way is none.
/// Whole ways go beyond it where contacts close, and where stick turns to slip. @param look finds the residual at m_velocity
void ImplicitEuler::searchLine(const VectorArray& start, const std::function<void()>& look)
{
    m_way = m_velocity;
    forEachNumber([&](std::size_t c, std::size_t i) { m_way.component(c)[i] -= start.component(c)[i]; });
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
        const bool isNear = now >= -newton.lineTolerance * slope && (share == 1 || now <= newton.lineTolerance * slope);
        if (isNear || trial == newton.mostTrials || !(slope > 0))
            return;
        if (now < 0) {
            high = share;
            atHigh = now;
        } else {
            low = share;
            atLow = now;
        }
        // In turns by the chord, and in halves, as forces of contacts are far from straight.
        const double chord = std::clamp(atLow / (atLow - atHigh), newton.nearestTrial, newton.farthestTrial);
        share = low + (high - low) * (trial % 2 == 1 ? chord : 0.5);
        forEachNumber([&](std::size_t c, std::size_t i) {
            m_velocity.component(c)[i] = start.component(c)[i] + share * m_way.component(c)[i];
        });
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

/// Whether the step needs no solution, as the one before did not: by the preconditioner of then.
bool ImplicitEuler::isBalancedAlready(const Contacts::Report& contacts, double h, double floor)
{
    if (!m_wasBalanced || m_factoredStep != h || contacts.clinging > 0)
        return false;
    const double loads = sizeOfLoads(contacts.tangents, h);
    return sizeOf(m_residual) <= std::max(floor, std::pow(newton.loadShare * m_tolerance, 2) * loads) &&
           lackOfWholes(contacts.tangents, h) <= 1;
}

/// How much is lacking, squared and by the preconditioned norm [J], and what that is compared with.
struct ImplicitEuler::Lack {
    double floor = 0; ///< that is nothing
    double start = 0; ///< before the first solution
    double first = 0; ///< the same without contacts
    double reference = 0;
    double size = 0;
    double last = 0;       ///< before the last solution; 0: there was none
    double enough = 0;     ///< that is small after a solution
    bool beganFar = false; ///< with more than what acts in the step
    bool isSmall = false;
};

void ImplicitEuler::measure(Lack& lack, const std::vector<ContactTangent>& tangents, double h, bool isFirst)
{
    lack.size = sizeOf(m_residual);
    const double loads = sizeOfLoads(tangents, h);
    if (isFirst) {
        lack.first = tangents.empty() ? lack.size : std::min(lack.size, sizeWithoutContacts(tangents, h));
        lack.start = lack.size;
    }
    const double least = m_touched.empty() ? newton.leastFreeReference : newton.leastReference;
    const double acting = std::min(lack.start, std::max(least * lack.first, loads));
    const auto smallBeside = [&](double reference) {
        return std::max(
            {m_tolerance * m_tolerance * reference, lack.floor, std::pow(newton.loadShare * m_tolerance, 2) * loads});
    };
    lack.reference = isFirst ? lack.start : acting;
    lack.enough = smallBeside(acting);
    lack.beganFar = acting < lack.start;
    lack.isSmall = lack.size <= smallBeside(lack.reference);
}

/// To which the next linear system is solved: as well as the last one served (Eisenstat and Walker 1996).
double ImplicitEuler::goalOf(const Lack& lack, bool flows) const
{
    if (lack.isSmall) // but not balanced as a whole
        return newton.smallTolerance * newton.smallTolerance * lack.size;
    const auto servedBy = [&](double first, double later) {
        return lack.last > 0 ? std::clamp(lack.size / lack.last, newton.singleTolerance, later) : first;
    };
    double loose = servedBy(newton.touchingTolerance, newton.laterTouchingTolerance);
    // Tools shall come to where hands are, which is finer than what contacts need.
    const bool isLikelyLast = loose * loose * lack.size <= lack.enough;
    if (m_touched.empty() || !m_hands.empty() || flows || !lack.beganFar || isLikelyLast)
        loose = servedBy(newton.looseTolerance, newton.laterTolerance);
    return std::max({newton.linearTolerance * newton.linearTolerance * lack.reference, 0.25 * lack.floor,
                     loose * loose * lack.size});
}

/// Newton's iteration, from the velocities in m_velocity.
ImplicitEuler::Report ImplicitEuler::findEnd(Contacts& contacts, const Vec3& gravity, double h)
{
    Report report;
    m_gravity = gravity;
    weighPieces();
    m_mixing.restart();
    int tangentAge = newton.tangentInterval; // iterations since springs were linearized: not in this step yet
    ContactStep step{.duration = h,
                     .stickSpeed = stickSpeed(h),
                     .isTrial = true,
                     .steepest = std::max(1.0, newton.steeperShare * m_steepness),
                     .clings = true};
    const auto look = [&] {
        tryVelocities(h);
        report.contacts = findForces(contacts, step);
        noteTouched(report.contacts.tangents);
        findResidual(report.contacts, gravity, h);
    };
    Lack lack{.floor = m_mass * std::pow(newton.restShare * m_spacing / h, 2)};
    for (look();; ++report.newtonIterations) {
        const std::vector<ContactTangent>& tangents = report.contacts.tangents;
        const bool isFirst = report.newtonIterations == 0;
        const bool isLast = report.newtonIterations == newton.mostIterations;
        bool isBalanced = isFirst && isBalancedAlready(report.contacts, h, lack.floor);
        if (!isBalanced) {
            if (isFirst) {
                updateSystem(tangents, h, Renewal::all);
                tangentAge = 0;
            }
            measure(lack, tangents, h, isFirst);
            isBalanced = lack.isSmall && (isLast || lackOfWholes(tangents, h) <= 1);
        }
        if (isLast)
            report.isWhole = lackOfWholes(tangents, h, newton.leastGain) <= 1;
        step.clings = false;
        if (isBalanced && report.contacts.clinging > 0) {
            look();
            continue; // without what only seemed to hold
        }
        if (isBalanced && report.contacts.steepness > step.steepest && !isLast) {
            step.steepest = newton.steeperShare * report.contacts.steepness;
            look();
            continue; // with contacts as they must be at these forces
        }
        if (isBalanced) {
            keepMomenta(gravity, h);
            if (m_surfaces.empty() && m_bodies.size() == 1)
                break;
            // What they lacked may have been all of a fall: it must not end inside of something.
            report.contacts = findForces(contacts, step);
            if (report.contacts.tangents.empty() || !m_touched.empty() || isLast)
                break;
            takeOverVelocities();
            look();
            continue;
        }
        if (isLast || !std::isfinite(lack.size)) {
            report.converged = lack.size <= newton.failedTolerance * newton.failedTolerance * lack.reference;
            keepMomenta(gravity, h);
            break;
        }
        // The first solution brings contacts about; from then on the tangent, which is elastic, is what is wrong where it flows.
        const bool flows = !isFirst && flowedEnergy() > 0;
        if (!isFirst) {
            const bool renews = flows || m_touched.empty() || ++tangentAge >= newton.tangentInterval ||
                                goneSinceLinearized(h) > newton.tangentReach * m_spacing;
            updateSystem(tangents, h, renews ? Renewal::springs : Renewal::contacts);
            tangentAge = renews ? 0 : tangentAge;
        }
        if (lack.isSmall) // only as a whole it is not balanced: what touches has begun to slide, or to stick
            m_preconditioner.updateClusters(m_system);
        if (lack.last > 0 && lack.size > solverSettings.mixing.lost * lack.last)
            m_mixing.restart();
        m_scratch = m_velocity;
        report.iterations += solve(goalOf(lack, flows));
        lack.last = lack.size;
        if (flows)
            m_mixing.accelerate(m_scratch, m_velocity);
        searchLine(m_scratch, look);
    }
    m_wasBalanced = report.newtonIterations == 0;
    notePresses(report.contacts.tangents, h);
    account(report, h);
    return report;
}

} // namespace knead
