#include "ui/interaction/pull_control.h"

#include <algorithm>
#include <numbers>

namespace knead {

namespace {

constexpr double reactionTime = 0.12; // of hand and window; longer than from one look to the next [s]
constexpr double largestStress = 0.3; // of the patch, in Young's moduli: enough to draw it out
constexpr double stallYield = 4;      // the same, in yield stresses

/// Of a round patch on a deep body, Boussinesq's 2 E r: nothing that hangs on it can be stiffer [N/m].
double stiffest(const PullSpring& spring)
{
    return 2 * spring.modulus * spring.radius;
}

} // namespace

PullSpring springFor(const Material& material, double radius, double chosenStiffness, double chosenLimit)
{
    PullSpring spring;
    spring.radius = radius;
    spring.modulus = material.youngsModulus;
    spring.stiffness = chosenStiffness > 0 ? chosenStiffness : material.youngsModulus * radius;
    double stress = largestStress * material.youngsModulus;
    if (material.yieldStress > 0)
        stress = std::min(stress, stallYield * material.yieldStress);
    spring.limit = chosenLimit > 0 ? chosenLimit : stress * std::numbers::pi * radius * radius;
    return spring;
}

Vec3 springForce(const PullSpring& spring, const Vec3& patchToHand)
{
    const Vec3 force = spring.stiffness * patchToHand;
    const double size = force.norm();
    return size > spring.limit ? Vec3(force * (spring.limit / size)) : force;
}

Vec3 pullVelocity(const PullSpring& spring, const Vec3& patchToHand, const Vec3& material, double largest)
{
    const double damping = (spring.stiffness + stiffest(spring)) * reactionTime;
    const Vec3 velocity = (springForce(spring, patchToHand) + material) / damping;
    const double speed = velocity.norm();
    return speed > largest ? Vec3(velocity * (largest / speed)) : velocity;
}

} // namespace knead
