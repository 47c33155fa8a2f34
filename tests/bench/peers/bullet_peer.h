#pragma once

#include "peers/peer_bar.h"

namespace knead {

/// Steps a bar as a soft body of Bullet, links solved once per step and without any contacts, on one thread; returns the
/// seconds per step.
double bulletStepTime(const PeerBar& bar, int steps);

} // namespace knead
