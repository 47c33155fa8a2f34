#pragma once

#include "core/session/filled_model.h"

namespace knead {

/// What follows from the numbers of a material and the spacing.
struct MaterialFacts {
    double soundSpeed = 0;      ///< of a thin bar [m/s]
    double stableStep = 0;      ///< of an explicit scheme, for all bodies together [s]
    double ratio = 0;           ///< of simulated to wall time that can be expected
    bool isMeasured = false;    ///< the ratio comes from steps that were taken, not from a rule
    double cellsAcrossWall = 0; ///< the thinnest one; 0: not measured
};

/// @param secondsPerStep as measured with the present integrator and material; 0: not yet
MaterialFacts factsOf(const FilledModel& content, const Snapshot& now, BodyId body, double secondsPerStep);

/// Wall time of a step, as long as nothing was measured: by the number of connections and objects, on a present-day core [s].
double expectedStepSeconds(const Snapshot& now);

} // namespace knead
