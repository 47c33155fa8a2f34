#pragma once

#include "core/aggregate/material.h"
#include "core/geometry/vec3.h"

namespace knead {

/// What of the spring a person chose. 0: goes by the material.
struct PullChoice {
    double stiffness = 0; ///< [N/m]
    double limit = 0;     ///< [N]
    friend bool operator==(const PullChoice&, const PullChoice&) = default;
};

/// A spring between a hand and a patch of material.
struct PullSpring {
    double stiffness = 1; ///< [N/m], > 0
    double limit = 1;     ///< the hand does not pull harder [N], > 0
    double radius = 0.01; ///< of the patch [m]
    double modulus = 1e6; ///< Young's modulus of the material around it [Pa]
};

/// One that pulls the material visibly without tearing it.
PullSpring springFor(const Material& material, double radius, const PullChoice& choice = {});

/// What the spring gives when it reaches from the patch to the hand [N].
Vec3 springForce(const PullSpring& spring, const Vec3& patchToHand);

/// How fast the patch has to move for spring and material to be in balance soon [m/s]. The patch is held as a grip holds it, so
/// that whatever the hand does is in a recording as velocities; a damper that suits the stiffest the material can be keeps it
/// calm although the window looks only now and then.
/// @param material force of the material on the patch [N]
/// @param largest speed [m/s]
Vec3 pullVelocity(const PullSpring& spring, const Vec3& patchToHand, const Vec3& material, double largest);

/// How fast a patch of material that yields goes to the hand [m/s]: as fast as the way asks, v = d / t, less where it resists with more
/// than half of the limit, and not at all at the limit. Flow resists fast and slow motion alike, so that the damper of elastic
/// material would only make the hand slow.
Vec3 flowVelocity(const PullSpring& spring, const Vec3& patchToHand, const Vec3& material, double largest);

/// The same for a patch that is turned: the spring gives radius^2 times the stiffness per angle, radius times the limit at most [1/s].
/// @param angle from the patch to the hand [rad]
/// @param moment of the material on the patch [N m]
/// @param velocity pullVelocity or flowVelocity
Vec3 turnVelocity(const PullSpring& spring, const Vec3& angle, const Vec3& moment, double largest,
                  Vec3 (*velocity)(const PullSpring&, const Vec3&, const Vec3&, double) = pullVelocity);

} // namespace knead
