#pragma once

#include "core/geometry/vec3.h"
#include "core/mechanics/tool_shape.h"
#include "core/message/message.h"

#include <cstdint>
#include <limits>
#include <string>
#include <variant>
#include <vector>

namespace knead {

using ToolId = std::uint32_t;

/// A place at a time, for recorded and recipe motions.
struct KeyFrame {
    double time = 0; ///< [s] since the start of the simulation
    Pose pose;
};

/// How a manipulator moves. Position-driven: the material feels it, it does not feel the material (but reports the force).
struct HoldStill {};
struct DriveAt {                         ///< moves on until told otherwise
    Vec3 velocity = Vec3::Zero();        ///< [m/s]
    Vec3 angularVelocity = Vec3::Zero(); ///< [rad/s], world axes
};
struct GoTo { ///< goes there in a straight line, no faster than the speed limit
    Pose target;
};
struct FollowKeyFrames {          ///< linear between frames; before the first and after the last it stands still
    std::vector<KeyFrame> frames; ///< ascending times, at least one
};
/// Moments keep the place in this list: another one comes last.
using Motion = std::variant<HoldStill, DriveAt, GoTo, FollowKeyFrames>;

/// A rigid tool that pushes material.
struct Manipulator {
    std::string name;
    Vec3 size = Vec3(0.02, 0.02, 0.02);                          ///< edge lengths of its box, as the kind says [m], > 0
    Pose pose;                                                   ///< of its center
    double friction = 0.4;                                       ///< Coulomb, 0 .. 2
    double speedLimit = 0.5;                                     ///< [m/s]
    double forceLimit = std::numeric_limits<double>::infinity(); ///< it stalls rather than push harder, > 0 [N]
    Motion motion;
    ToolKind kind = ToolKind::box;
    std::shared_ptr<const ToolPart> part; ///< for ToolKind::part
    double adhesion = 0; ///< tension that what touched it bears [Pa], 0 .. 1e9; 0: nothing sticks to it
    /// A ball or a cylinder turns as it is moved over material, see rollingRate(); what its motion says of turning holds for its axis
    /// only. Other forms take no notice of it.
    bool rollsFreely = false;

    ToolShape shape() const { return {kind, size, part}; }
    bool rolls() const { return rollsFreely && canRoll(kind); }
};

/// w = (n x v) / r, for a cylinder the part of it about its axis: where the material presses, the surface of the tool does not move.
/// @param velocity v of its center [m/s]
/// @param force of the material on the tool, which says where it presses: n is its direction across the axis. Zero: it does not turn
/// @return [1/s], world axes; zero for what does not roll
Vec3 rollingRate(const Manipulator& manipulator, const Vec3& velocity, const Vec3& force);

/// Where a manipulator is after `dt` [s] of its motion, starting from `pose` at `time` [s]. One that rolls is turned with its axis
/// only; what it rolls comes on top.
Pose advance(const Manipulator& manipulator, double time, double dt);

/// Where a manipulator goes that wants to be at `next` after `dt` [s] while the material pushes on it with `force` [N].
/// Beyond its force limit it stalls: it moves with the force or not at all. Afterwards it catches up no faster than its
/// speed limit. Without a force limit it goes where it wants.
/// @param goesBack for short steps: near its limit the tool gets slower and beyond it goes back, by (1 - f / limit) / 0.05 of its way,
/// so that it comes to rest at the limit, not at the peaks of what vibrates
Pose yieldTo(const Vec3& force, const Manipulator& manipulator, const Pose& next, double dt, bool goesBack = false);

/// One sentence per thing that cannot be simulated: sizes, places, speeds or key frames out of range. Empty when all is well.
std::vector<Message> manipulatorProblems(const Manipulator& manipulator);

} // namespace knead
