#pragma once

#include "core/mechanics/lattice_kernels.h"

namespace knead {

/// Adds the friction of the published model to the damping of a stretch of structural connections (eq 7):
/// u |F_N| against the sideways relative velocity, F_N the connection's own bond and damping force. Limited to half of what
/// would stop the sideways motion within dt. It also brakes a body that merely turns, which is why only published scenes
/// use it.
/// @param mass of the objects at both ends [kg]
/// @param pull, brake bond and damping force on the lower end, as computed before [N]
void addStructuralFriction(std::size_t count, const kernels::End& self, const kernels::End& neighbor,
                           const double* const (&mass)[2], double friction, double dt, const kernels::Vectors& pull,
                           const kernels::Vectors& brake);

} // namespace knead
