#pragma once

#include "app/sweep/sweep_progress.h"
#include "app/sweep/sweep_table.h"

#include <cstddef>
#include <vector>

namespace knead {

struct LocalOptions {
    unsigned jobs = 0;    ///< runs at a time; 0: as many as fit on the cores
    unsigned threads = 1; ///< of each run
};

/// Carries out points on this machine, several at a time.
/// @throws std::runtime_error, in a sentence, when the sweep cannot go on. @throws Cancelled, once all runs have ended
LostPoints runLocally(const SweepFolder& folder, const SweepPlan& plan, const std::vector<std::size_t>& points,
                      const LocalOptions& options, SweepProgress& progress);

} // namespace knead
