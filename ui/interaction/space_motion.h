#pragma once

#include "core/geometry/vec3.h"

#include <functional>
#include <memory>

namespace knead {

/// What a person does with a 3D mouse, as seen on the screen: x to the right, y up, z towards the eye. Full deflection is about 1.
struct SpaceMotion {
    Vec3 push = Vec3::Zero();
    Vec3 turn = Vec3::Zero(); ///< about these axes, counterclockwise
    double seconds = 0;       ///< since the motion before

    bool isRest() const { return push.isZero() && turn.isZero(); }
};

struct SpaceEvent {
    enum class Kind { motion, buttonPressed, connected, disconnected };
    Kind kind = Kind::motion;
    SpaceMotion motion;
    int button = 0;
};

/// Listens to a 3D mouse for as long as what it returns lives. The listener is called on a thread of its own. A mouse that is
/// not there, or comes and goes, is no error.
using ListenToSpaceMouse = std::function<std::shared_ptr<void>(std::function<void(const SpaceEvent&)> listener)>;

} // namespace knead
