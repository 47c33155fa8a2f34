#pragma once

#include "core/integration/semi_implicit_euler.h"

namespace knead {

/// One step of forward Euler, as published: x += dt v with the old v, then v += dt ((F + D) / m + g). First order like the
/// semi-implicit scheme, but it gains energy where that one keeps it: only damping makes it stable.
/// Objects with inverse mass 0 stay where they are. Several threads; same bits for any number.
StepReport forwardEuler(ObjectState& state, const Vec3& gravity, double dt);

} // namespace knead
