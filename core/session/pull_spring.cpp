#include "core/session/pull_spring.h"

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

Vec3 noLonger(const Vec3& vector, double length)
{
    const double size = vector.norm();
    return size > length ? Vec3(vector * (length / size)) : vector;
}

} // namespace

PullSpring springFor(const Material& material, double radius, const PullChoice& choice)
{
    PullSpring spring;
    spring.radius = radius;
    spring.modulus = material.youngsModulus;
    spring.stiffness = choice.stiffness > 0 ? choice.stiffness : material.youngsModulus * radius;
    double stress = largestStress * material.youngsModulus;
    if (material.yieldStress > 0)
        stress = std::min(stress, stallYield * material.yieldStress);
    spring.limit = choice.limit > 0 ? choice.limit : stress * std::numbers::pi * radius * radius;
    return spring;
}

Vec3 springForce(const PullSpring& spring, const Vec3& patchToHand)
{
    return noLonger(spring.stiffness * patchToHand, spring.limit);
}

Vec3 pullVelocity(const PullSpring& spring, const Vec3& patchToHand, const Vec3& material, double largest)
{
    const double damping = (spring.stiffness + stiffest(spring)) * reactionTime;
    return noLonger((springForce(spring, patchToHand) + material) / damping, largest);
}

Vec3 flowVelocity(const PullSpring& spring, const Vec3& patchToHand, const Vec3& material, double largest)
{
    const double way = patchToHand.norm();
    if (way == 0)
        return Vec3::Zero();
    const double resistance = -material.dot(patchToHand) / (way * spring.limit);
    const double share = std::clamp(2 * (1 - resistance), 0.0, 1.0);
    return share * noLonger(patchToHand / reactionTime, largest);
}

Vec3 turnVelocity(const PullSpring& spring, const Vec3& angle, const Vec3& moment, double largest,
                  Vec3 (*velocity)(const PullSpring&, const Vec3&, const Vec3&, double))
{
    return velocity(spring, spring.radius * angle, moment / spring.radius, spring.radius * largest) / spring.radius;
}

} // namespace knead
