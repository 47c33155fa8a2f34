#include "core/integration/time_step.h"

#include <algorithm>
#include <cmath>

namespace knead {

double stableTimeStep(double frequency, double dampingTime)
{
    const double zeta = 0.5 * dampingTime * frequency;
    return 2 * (std::sqrt(1 + zeta * zeta) - zeta) / frequency;
}

double frequencyForTimeStep(double timeStep, double dampingTime)
{
    return 1 / std::sqrt(0.25 * timeStep * timeStep + 0.5 * timeStep * dampingTime);
}

double stableForwardEulerStep(double frequency, double leastDampingTime, double dampingTime)
{
    // |1 + lambda dt| <= 1 with lambda = -zeta omega +- sqrt(zeta^2 - 1) omega, zeta = dampingTime omega / 2.
    const double zeta = 0.5 * dampingTime * frequency;
    if (zeta < 1)
        return leastDampingTime;
    return std::min(leastDampingTime, 2 / (frequency * (zeta + std::sqrt(zeta * zeta - 1))));
}

} // namespace knead
