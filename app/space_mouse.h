#pragma once

#include "ui/interaction/space_motion.h"

#include <functional>
#include <memory>

namespace knead {

/// Listens to a 3D mouse through spacenavd, as long as what is returned lives. When there is no such daemon, or it ends, it is
/// looked for again every two seconds. The socket is where SPNAV_SOCKET says, else where spacenavd puts it.
/// @param listener called on a thread of its own
std::shared_ptr<void> listenToSpaceMouse(std::function<void(const SpaceEvent&)> listener);

/// Axes of spacenavd, in its counts, to those of the screen.
SpaceMotion spaceMotionOf(const int (&push)[3], const int (&turn)[3], unsigned milliseconds);

} // namespace knead
