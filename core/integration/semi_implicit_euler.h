#pragma once

#include "core/mechanics/object_state.h"

namespace knead {

/// What an integration step found on its way.
struct StepReport {
    double largestSpeed = 0; ///< [m/s]; not finite when any velocity is not
    double dampingWork = 0;  ///< of state.damping on the objects, with the mean of old and new velocity [J]
};

/// One step of semi-implicit (symplectic) Euler: v += dt (F + D + w g) / m, then x += dt v with the new v. The weight w g is
/// that of the material, be the inertia m scaled or not.
/// Objects with inverse mass 0 stay where they are. Several threads; same bits for any number.
StepReport semiImplicitEuler(ObjectState& state, const Vec3& gravity, double dt);

/// Adds dt times the present acceleration to the velocities. Velocities of the semi-implicit scheme belong to half a step before
/// the positions; when the step changes from one length to another, half the difference is missing.
void kick(ObjectState& state, const Vec3& gravity, double dt);

} // namespace knead
