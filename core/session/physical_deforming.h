#pragma once

#include "core/session/end_grips.h"
#include "core/session/playback_cache.h"
#include "core/simulation/gesture.h"
#include "core/task/task_control.h"

namespace knead {

/// What came of a deformation by physics: a gesture, and what was seen meanwhile.
struct DeformedByPhysics {
    Gesture gesture;
    PlaybackCache film;
};

/// Adds grips, lets time run while they go their way, and on until nothing moves any more, a few seconds at most. Blocks. It goes at
/// the pace that leaves nothing out.
/// @param simulation at a moment @param names of its bodies, for sentences @param which of them; empty: all
/// @param filmMemory for what is seen [bytes]
/// @throws Problem as heldEnds(), and where the simulation gets into trouble. @throws Cancelled
DeformedByPhysics deformByPhysics(Simulation simulation, const PhysicalDeformation& deformation,
                                  const std::vector<std::string>& names, const std::vector<bool>& which,
                                  std::size_t filmMemory, TaskControl& control);

} // namespace knead
