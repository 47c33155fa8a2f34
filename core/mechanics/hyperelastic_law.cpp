#include "core/mechanics/hyperelastic_law.h"

#include "core/aggregate/material.h"
#include "core/geometry/vec3.h"

#include <algorithm>
#include <cmath>

namespace knead {

RubberNumbers rubberNumbers(const Material& material)
{
    RubberNumbers numbers;
    if (!material.isRubberlike())
        return numbers;
    numbers.secondShare = material.secondInvariantShare;
    if (material.lockingElongation > 0) {
        const double s = 1 + material.lockingElongation;
        numbers.inverseChain = 3 / (s * s + 2 / s);
    }
    numbers.firstScale = (1 - numbers.secondShare) / firstSlope(1.0, numbers.inverseChain, 3.0);
    return numbers;
}

double stiffestWave(const Material& material, const double (&principal)[3])
{
    const Vec3 stretches(principal[0], principal[1], principal[2]);
    const RubberNumbers numbers = rubberNumbers(material);
    const double mu = material.shearModulus();
    const double bulk = material.lameLambda() + 2 * mu / 3;
    const double ratio = std::max(stretches.prod(), leastRubberRatio);
    const double scale = 1 / std::cbrt(ratio * ratio);
    const double most = stretches.maxCoeff();
    // |cof F n| is at most the product of the two larger stretches.
    const double cofactor = stretches.prod() / std::max(stretches.minCoeff(), 1e-3);
    const double slant = cofactor * cofactor / (ratio * ratio);
    const double first = scale * stretches.squaredNorm();
    const double second = 0.5 * (first * first - scale * scale * stretches.array().square().square().sum());
    const double slope = firstSlope(numbers.firstScale, numbers.inverseChain, first);
    const double curvature = firstCurvature(numbers.firstScale, numbers.inverseChain, first);
    const double spread = scale * most * most;
    const double volumetric = bulk * std::max(1 - std::log(ratio), 0.0) +
                              mu * (5.0 / 9 * slope * first + 14.0 / 9 * numbers.secondShare * second);
    return volumetric * slant +
           mu * (scale * slope + 2 * curvature * scale * spread + 2 * numbers.secondShare * scale * spread);
}

} // namespace knead
