#include "core/simulation/gesture.h"

#include <utility>

namespace knead {

Gesture endGesture(Simulation& simulation)
{
    MomentPointer moment = simulation.keepMoment();
    return {.commands = simulation.takeRecording(), .moment = std::move(moment), .hash = simulation.stateHash()};
}

} // namespace knead
