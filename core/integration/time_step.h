#pragma once

namespace knead {

/// Largest stable time step of the semi-implicit Euler scheme with damping at the old velocity, for one mode [s]:
/// dt < 2 (sqrt(1 + zeta^2) - zeta) / omega with zeta = dampingTime omega / 2.
/// @param frequency omega [rad/s], > 0
/// @param dampingTime b / k [s], >= 0
double stableTimeStep(double frequency, double dampingTime);

/// The frequency whose largest stable step is `timeStep`: the inverse of stableTimeStep() [rad/s].
double frequencyForTimeStep(double timeStep, double dampingTime);

/// Largest stable time step of the forward Euler scheme for all modes up to a frequency, damped in proportion to their
/// stiffness [s]: b / k for slow modes, less for overdamped ones. 0 without damping: then no step is stable.
/// @param leastDampingTime, dampingTime bounds of b / k over all modes [s]
double stableForwardEulerStep(double frequency, double leastDampingTime, double dampingTime);

} // namespace knead
