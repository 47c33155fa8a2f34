#pragma once

#include "core/geometry/vec3.h"

namespace knead {

/// A structural connection that rubs.
struct RubbingConnection {
    Vec3 across = Vec3::Zero();   ///< from one object to its neighbor [m]
    Vec3 velocity = Vec3::Zero(); ///< of the neighbor against the object [m/s]
    double stiffness = 0;         ///< k [N/m]
    double damping = 0;           ///< b [N s/m]
    double nominalLength = 0;     ///< l [m]
    double reducedMass = 0;       ///< of the two [kg]
};

/// Friction u of a structural connection as published (eq 7): the force on the object [N], against its slide along the
/// neighbor and u times what the connection bears, but no more than what would stop the slide within the time step.
/// @param dt > 0 [s]
Vec3 structuralFriction(const RubbingConnection& connection, double friction, double dt);

} // namespace knead
