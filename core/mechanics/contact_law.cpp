#include "core/mechanics/contact_law.h"

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

double harmonicMean(double a, double b)
{
    return a + b > 0 ? 2 * a * b / (a + b) : 0;
}

} // namespace

ContactResult contactForce(const ContactState& state, const ContactParameters& parameters, const ContactStep& step)
{
    ContactResult result;
    const double late = step.isImplicit() ? parameters.onset / 2 : 0;
    if (state.overlap <= late)
        return result;
    const double overlap = std::min(state.overlap, parameters.largestOverlap);
    const double onset = step.isImplicit() ? 0 : parameters.onset;
    const bool begins = overlap < onset;
    const double begun = begins ? overlap * overlap / (2 * onset) : std::max(0.0, overlap - late - onset / 2);
    const double spring = parameters.stiffness * begun;
    const double normalSpeed = state.relativeVelocity.dot(state.normal);
    const double normalForce = std::max(0.0, spring - parameters.damping * normalSpeed);
    result.spring = spring * state.normal;
    result.damping = (normalForce - spring) * state.normal;
    const double stored =
        begins ? spring * overlap / 3 : 0.5 * parameters.stiffness * (begun * begun + onset * onset / 12);
    result.energy = stored + spring * (state.overlap - overlap);

    const Vec3 slide = state.relativeVelocity - normalSpeed * state.normal;
    const double speed = slide.norm();
    result.frictionLimit = parameters.friction * normalForce;
    if (step.isImplicit()) {
        const double coulomb = result.frictionLimit / std::max(speed, step.stickSpeed);
        const bool exceeds = state.slip > coulomb && normalForce > 0;
        result.slip = step.keepsSlip && !(step.limitsSlip && exceeds) ? state.slip : coulomb;
        result.friction = -result.slip * slide;
    } else if (speed > 0) {
        constexpr double share = 0.5;
        const double stopping = share * parameters.reducedMass * speed / step.duration;
        result.friction = -std::min(result.frictionLimit, stopping) / speed * slide;
    }
    result.damping += result.friction;
    if (step.isTrial && normalForce > 0) {
        const bool isCapped = state.overlap > parameters.largestOverlap;
        const double slope = isCapped ? 0 : parameters.stiffness;
        const Mat3 dyad = state.normal * state.normal.transpose();
        result.resistance =
            (step.duration * slope + parameters.damping) * dyad + result.slip * (Mat3::Identity() - dyad);
    }
    return result;
}

ContactParameters combine(const ContactParameters& a, const ContactParameters& b)
{
    return {.stiffness = harmonicMean(a.stiffness, b.stiffness),
            .damping = harmonicMean(a.damping, b.damping),
            .friction = std::sqrt(a.friction * b.friction),
            .reducedMass = harmonicMean(a.reducedMass, b.reducedMass) / 2,
            .onset = std::min(a.onset, b.onset),
            .largestOverlap = std::min(a.largestOverlap, b.largestOverlap)};
}

} // namespace knead
