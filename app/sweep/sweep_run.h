#pragma once

#include "app/sweep/sweep_folder.h"
#include "core/task/task_control.h"

#include <cstddef>
#include <stdexcept>

namespace knead {

/// A run that was ended from outside: it has no result, and may have one the next time.
struct RunWasEnded : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Carries out a point as a process `knead run --json` and keeps what it gave. Failures and crashes of the run are results
/// too. The process ends with this thread.
/// @param threads of the run
/// @throws RunWasEnded, in a sentence, and std::runtime_error, in a sentence, when an input has changed or the disk refuses.
/// @throws Cancelled
PointResult runPoint(const SweepFolder& folder, const SweepPlan& plan, std::size_t point, unsigned threads,
                     TaskControl& control);

} // namespace knead
