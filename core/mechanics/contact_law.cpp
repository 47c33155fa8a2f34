#include "core/mechanics/contact_law.h"

#include "core/kernels/contact_kernels.h"

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

double harmonicMean(double a, double b)
{
    return a + b > 0 ? 2 * a * b / (a + b) : 0;
}

// Friction forgets the pressure of ends that parted so many times later than it follows it.
constexpr double keptFor = 20;

// Coulomb's friction does not answer to the speed of a slide. The rest of what a stick would answer stays, so that Newton's method
// does not go far beyond where a slide ends.
constexpr double slipShare = 0.9;

bool followsLate(const ContactParameters& parameters, const ContactStep& step)
{
    return !step.isImplicit() && parameters.frictionDelay > 0;
}

/// Of ends that are apart and stick: the spring yields at the adhesion.
ContactSpring stickingSpring(double gap, const ContactParameters& parameters)
{
    const double k = parameters.stiffness;
    const double longest = parameters.adhesion / k;
    const double stretch = std::min(gap, longest);
    return {.force = -k * stretch,
            .slope = gap < longest ? k : 0,
            .energy = 0.5 * k * stretch * stretch + parameters.adhesion * (gap - stretch)};
}

/// @param steepest in place of d1
ContactSpring springUpTo(double steepest, double overlap, const ContactParameters& parameters, bool sticks)
{
    if (overlap <= 0)
        return sticks ? stickingSpring(-overlap, parameters) : ContactSpring{};
    const double k = parameters.stiffness;
    const double felt = std::min(overlap, parameters.largestOverlap);
    const double d = std::min(felt, steepest);
    const double squared = d / parameters.stiffening * (d / parameters.stiffening);
    const double fourth = squared * squared;
    ContactSpring spring{
        .force = k * d * (1 + fourth), .slope = k * (1 + 5 * fourth), .energy = 0.5 * k * d * d * (1 + fourth / 3)};
    const double beyond = felt - d;
    spring.energy += beyond * (spring.force + 0.5 * spring.slope * beyond);
    spring.force += spring.slope * beyond;
    if (overlap > felt) {
        spring.energy += spring.force * (overlap - felt);
        spring.slope = 0;
    }
    return spring;
}

} // namespace

ContactSpring contactSpring(double overlap, const ContactParameters& parameters, bool sticks)
{
    return springUpTo(parameters.steepest, overlap, parameters, sticks);
}

double pressureKept(const ContactParameters& parameters, const ContactStep& step)
{
    return followsLate(parameters, step) ? std::exp(-step.duration / parameters.frictionDelay) : 0;
}

double pressureKeptApart(const ContactParameters& parameters, const ContactStep& step)
{
    return followsLate(parameters, step) ? std::exp(-step.duration / (keptFor * parameters.frictionDelay)) : 0;
}

FrictionMemory parted(const FrictionMemory& memory, const ContactParameters& parameters, const ContactStep& step)
{
    return {.pressure = memory.pressure == 0 ? 0 : memory.pressure * pressureKeptApart(parameters, step)};
}

/// Of ends that are apart and hold on to each other: a spring as stiff as that of the deepest contact of the last step.
ContactResult clingingForce(const ContactState& state, const ContactParameters& parameters, const ContactStep& step)
{
    const double squared = step.steepest * step.steepest;
    const double stiffness = parameters.stiffness * (std::isfinite(squared) ? 1 + squared * squared : 1);
    ContactResult result;
    result.spring = stiffness * state.overlap * state.normal;
    result.slope = stiffness;
    result.resistance = (step.duration * stiffness + parameters.damping) * state.normal * state.normal.transpose();
    return result;
}

ContactResult contactForce(const ContactState& state, const ContactParameters& parameters, const ContactStep& step)
{
    const bool sticks = parameters.adhesion > 0 && (state.overlap > 0 || state.memory.sticks);
    if (state.overlap <= 0 && !sticks && step.clings && !state.memory.isEmpty())
        return clingingForce(state, parameters, step);
    ContactResult result;
    const double steepest = std::min(parameters.steepest, step.steepest * parameters.stiffening);
    const ContactSpring spring = springUpTo(steepest, state.overlap, parameters, sticks);
    const double farthest = std::max(parameters.adhesion / parameters.stiffness, parameters.adhesionReach);
    const bool isTornOff = sticks && step.remembers() && -state.overlap >= farthest;
    if (state.overlap <= 0 && (!sticks || isTornOff)) {
        result.memory = parted(state.memory, parameters, step);
        result.released = spring.energy;
        return result;
    }
    const double adhesion = sticks ? parameters.adhesion : 0;
    result.steepness = std::clamp(state.overlap, 0.0, parameters.steepest) / parameters.stiffening;
    const double normalSpeed = state.relativeVelocity.dot(state.normal);
    double normalForce = std::max(-adhesion, spring.force - parameters.damping * normalSpeed);
    if (!step.isImplicit() && parameters.mass > 0 && state.overlap > 0) {
        const double turned =
            std::min(state.overlap, parameters.steepest) / step.duration + std::max(0.0, -normalSpeed);
        normalForce = std::min(normalForce, kernels::mostTurned * parameters.mass * turned / step.duration);
    }
    result.spring = spring.force * state.normal;
    result.damping = (normalForce - spring.force) * state.normal;
    result.energy = spring.energy;
    result.slope = spring.slope;

    const Vec3 slide = state.relativeVelocity - normalSpeed * state.normal;
    const double sideways =
        state.overlap > 0 ? step.duration * spring.force / state.overlap : step.duration * parameters.stiffness;
    const Vec3& before = state.memory.hold;
    const Vec3 held = before - before.dot(state.normal) * state.normal + sideways * slide;
    const Vec3 sticking = held + parameters.damping * slide;
    const double wanted = sticking.norm();
    result.memory.pressure = normalForce + (state.memory.pressure - normalForce) * pressureKept(parameters, step);
    result.memory.sticks = sticks;
    const double limit = parameters.friction * std::max(0.0, result.memory.pressure + adhesion);
    const double grip = wanted > limit ? limit / wanted : 1; // 1 sticks, less slips
    result.friction = -grip * sticking;
    result.memory.hold = grip * held;
    result.damping += result.friction;
    if (step.isTrial && normalForce > -adhesion) {
        const Mat3 dyad = state.normal * state.normal.transpose();
        result.resistance = (step.duration * spring.slope + parameters.damping) * dyad +
                            grip * (sideways + parameters.damping) * (Mat3::Identity() - dyad);
        if (grip < 1) {
            result.resistance -= slipShare * grip * (sideways + parameters.damping) / (wanted * wanted) * sticking *
                                 sticking.transpose();
            result.drag =
                -parameters.friction * (step.duration * spring.slope + parameters.damping) / wanted * sticking;
        }
    }
    return result;
}

ContactParameters combine(const ContactParameters& a, const ContactParameters& b)
{
    return {.stiffness = harmonicMean(a.stiffness, b.stiffness),
            .damping = harmonicMean(a.damping, b.damping),
            .friction = std::sqrt(a.friction * b.friction),
            .stiffening = std::min(a.stiffening, b.stiffening),
            .steepest = std::min(a.steepest, b.steepest),
            .frictionDelay = std::max(a.frictionDelay, b.frictionDelay),
            .largestOverlap = std::min(a.largestOverlap, b.largestOverlap)};
}

} // namespace knead
