#pragma once

#include "core/aggregate/material.h"
#include "core/geometry/vec3.h"

namespace knead {

/// A spring between a hand and a patch of material.
struct PullSpring {
    double stiffness = 1; ///< [N/m], > 0
    double limit = 1;     ///< the hand does not pull harder [N], > 0
    double radius = 0.01; ///< of the patch [m]
    double modulus = 1e6; ///< Young's modulus of the material around it [Pa]
};

/// One that pulls the material visibly without tearing it.
/// @param chosenStiffness, chosenLimit of a person; 0: by the material
PullSpring springFor(const Material& material, double radius, double chosenStiffness, double chosenLimit);

/// What the spring gives when it reaches from the patch to the hand [N].
Vec3 springForce(const PullSpring& spring, const Vec3& patchToHand);

/// How fast the patch has to move for spring and material to be in balance soon [m/s]. The patch is held as a grip holds it, so
/// that whatever the hand does is in a recording as velocities; a damper that suits the stiffest the material can be keeps it
/// calm although the window looks only now and then.
/// @param material force of the material on the patch [N]
/// @param largest speed [m/s]
Vec3 pullVelocity(const PullSpring& spring, const Vec3& patchToHand, const Vec3& material, double largest);

} // namespace knead
