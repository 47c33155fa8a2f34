#include "core/integration/time_step.h"

#include <cmath>

namespace knead {

double stableTimeStep(double frequency, double dampingTime)
{
    const double zeta = 0.5 * dampingTime * frequency;
    return 2 * (std::sqrt(1 + zeta * zeta) - zeta) / frequency;
}

} // namespace knead
