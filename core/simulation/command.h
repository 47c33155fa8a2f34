#pragma once

#include "core/simulation/scene.h"

#include <cstdint>
#include <limits>
#include <variant>

namespace knead {

/// What a person (or a recipe) tells a running simulation. Commands are values; they take effect at the start of a step
/// and are recorded with its number: same start, same commands, same bits.
struct SetMaterial {
    BodyId body = 0;
    Material material;
};
struct SetGravity {
    Vec3 gravity = Vec3::Zero();
};
struct SetFloor {
    std::optional<double> height;
    double friction = 0.4;
};
/// Gets the next free ToolId: 0, 1, 2 ... in order of adding.
struct AddManipulator {
    Manipulator manipulator;
};
struct RemoveManipulator {
    ToolId tool = 0;
};
struct SetManipulatorMotion {
    ToolId tool = 0;
    Motion motion;
};
struct ReshapeManipulator {
    ToolId tool = 0;
    Vec3 size = Vec3::Zero();
    double friction = 0;
    double speedLimit = 0;
    double forceLimit = std::numeric_limits<double>::infinity();
};
/// At once, while paused; the tool does not push on the way.
struct PlaceManipulator {
    ToolId tool = 0;
    Pose pose;
};
/// Gets the next free FixtureId.
struct AddFixture {
    Fixture fixture;
};
struct RemoveFixture {
    FixtureId fixture = 0;
};

using Command = std::variant<SetMaterial, SetGravity, SetFloor, AddManipulator, RemoveManipulator, SetManipulatorMotion,
                             ReshapeManipulator, PlaceManipulator, AddFixture, RemoveFixture>;

/// A command and the step before which it took effect.
struct RecordedCommand {
    std::uint64_t step = 0;
    Command command;
};

} // namespace knead
