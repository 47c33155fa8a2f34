#pragma once

#include "core/simulation/simulation.h"
#include "core/task/task_control.h"

#include <cstdint>
#include <span>

namespace knead {

/// Repeats what was recorded: each command before the step before which it took effect, then steps until `upToStep`, which
/// counts from the last Reset like those of the commands. From the same state it comes to the same state, bit for bit, on any
/// number of threads.
/// @param from where the recording began: the start of the scene, or a moment that was gone to
/// @throws Problem when the commands do not belong to this simulation, so that a step is never reached; Cancelled
Simulation replay(Simulation from, std::span<const RecordedCommand> commands, std::uint64_t upToStep,
                  TaskControl& control = TaskControl::none());

} // namespace knead
