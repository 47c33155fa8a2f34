#pragma once

#include "core/aggregate/material.h"
#include "core/simulation/scene.h"

#include <string>
#include <vector>

namespace knead {

/// A part under a recorded hand: a tool that comes down, presses until it stalls at its limit of force, stays, slides and lifts.
struct RealtimeScene {
    std::string name;
    Scene scene;
    double depth = 0;  ///< that the hand means to press [m]; 0: it does nothing
    Vec3 slide{};      ///< of the pressed tool [m]
    double height = 0; ///< above the part at the start [m]
};

/// @param objects about so many in all
std::vector<RealtimeScene> realtimeScenes(const Material& material, double objects);

/// Where the hand wants the tool at a time, from where it began.
Vec3 handAt(const RealtimeScene& scene, double time);
inline constexpr double handSeconds = 1.2; ///< that it takes [s]

} // namespace knead
