#pragma once

#include "app/sweep/slurm_commands.h"
#include "app/sweep/sweep_progress.h"
#include "app/sweep/sweep_table.h"

#include <cstddef>
#include <string>
#include <vector>

namespace knead {

struct SlurmOptions {
    unsigned throttle = 0;            ///< runs at a time; 0: as many as there is room for
    unsigned threads = 1;             ///< of each run
    std::vector<std::string> options; ///< for sbatch
};

/// Carries out points as tasks of a job array of Slurm, on machines that see the same files under the same paths. Tasks that an
/// earlier call submitted and that still wait or run are not submitted again. When cancelled, the tasks go on.
/// @throws std::runtime_error, in a sentence, when Slurm is not here or refuses. @throws Cancelled
LostPoints runOnSlurm(const SweepFolder& folder, const SweepPlan& plan, const std::vector<std::size_t>& points,
                      const SlurmOptions& options, SweepProgress& progress);

/// Jobs that were submitted for the sweep in a folder, ended ones included.
std::vector<SlurmJob> jobsOf(const SweepFolder& folder);

} // namespace knead
