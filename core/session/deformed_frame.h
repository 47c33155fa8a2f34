#pragma once

#include "core/geometry/smooth_map.h"
#include "core/session/frame.h"
#include "core/task/task_control.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace knead {

/// What a map makes of the surfaces of a frame, to be looked at before it is done.
struct DeformedFrame {
    FramePointer frame; ///< with the same snapshot and bodies
    /// Per body, at the vertices of FilledBody::mesh: how far the map takes them [m]; empty for bodies that it is not for.
    std::vector<std::vector<float>> ways;
    double largestWay = 0;    ///< [m]
    std::optional<Vec3> fold; ///< a place, before the map, where it turns material inside out [m]
};

/// Carries the surfaces that a frame shows through a map. On all threads. @throws Cancelled
/// @param which per body; empty: all
DeformedFrame deformedFrame(const FramePointer& shown, const SmoothMap& map, const std::vector<bool>& which,
                            TaskControl& control = TaskControl::none());

/// SmoothMap::evaluate() on all threads.
void evaluateInBlocks(const SmoothMap& map, std::span<const Vec3> points, std::span<Vec3> places);

} // namespace knead
