#pragma once

#include "core/simulation/simulation.h"

#include <cstdint>
#include <vector>

namespace knead {

/// What was done since the moment before was kept or gone to, and the moment at its end. Carrying out the commands from that
/// moment on (see replay()) leads here, to the bit.
struct Gesture {
    std::vector<RecordedCommand> commands; ///< the last one is KeepMoment
    MomentPointer moment;                  ///< never null
    std::uint64_t hash = 0;                ///< Simulation::stateHash()
};

/// How often steps begin to be counted anew within commands.
std::uint32_t resetsIn(const std::vector<RecordedCommand>& commands);

/// The commands that lead to a step and no further.
/// @param run in which the step is reached: after so many resets within the commands
std::vector<RecordedCommand> commandsBefore(const std::vector<RecordedCommand>& commands, std::uint32_t run,
                                            std::uint64_t step);

/// Ends a gesture now: keeps the moment and takes the recording.
Gesture endGesture(Simulation& simulation);

} // namespace knead
