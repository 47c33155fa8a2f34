#pragma once

#include "core/simulation/pace.h"
#include "core/simulation/scene.h"

#include <cstdint>
#include <limits>
#include <string>
#include <variant>

namespace knead {

/// What a person (or a recipe) tells a running simulation. Commands are values; they take effect at the start of a step
/// and are recorded with its number: same start, same commands, same bits.
struct SetMaterial {
    BodyId body = 0;
    Material material;
    std::vector<ObjectIndex> objects = {}; ///< only these; empty: all that are not of a region
};
struct SetBodyKind {
    BodyId body = 0;
    BodyKind kind = BodyKind::deformable;
};
/// Re-normalization: the body, or a part of it, takes its present shape for its own. Connections take part whose objects both
/// do.
struct Renormalize {
    BodyId body = 0;
    std::vector<ObjectIndex> objects = {}; ///< only these; empty: all
    double duration = 0;                   ///< gradually, as in annealing [s]; 0: at once
};
struct SetGravity {
    Vec3 gravity = Vec3::Zero();
};
struct SetFloor {
    std::optional<double> height;
    double friction = 0.4;
    double adhesion = 0; ///< [Pa]
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
    ToolKind kind = ToolKind::box;
    std::shared_ptr<const ToolPart> part = nullptr; ///< for ToolKind::part
    double adhesion = 0;                            ///< [Pa]
    bool rollsFreely = false;
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

/// Other steps from now on; nothing else changes.
struct SetIntegrator {
    Integrator integrator = Integrator::automatic;
};

/// Implicit steps are as long and as exact as that from now on.
struct SetPace {
    Pace pace = Pace::full;
};

struct MoveFixture {
    FixtureId fixture = 0;
    Vec3 velocity = Vec3::Zero(); ///< [m/s], up to 100
    GripTurn turn = {};
};

/// Gets the next free LoadId.
struct AddLoad {
    Load load;
};
struct RemoveLoad {
    LoadId load = 0;
};
/// The load goes evenly from what it is to another amount.
struct SetLoad {
    LoadId load = 0;
    LoadAmount amount;
    double ramp = 0; ///< [s] 0 .. 3600; 0: at once
};

/// Back to the start: bodies at rest in their first shape, with their present materials and fixtures; tools where they began,
/// with the motion they began with. Time, steps and energies begin anew.
struct Reset {};

/// Keeps the state of now, so that it can be gone back to, and goes on from what was kept: what can be found again from the
/// rest is found again. That changes rounding, and so is a command: whoever repeats the run must do it at the same step.
struct KeepMoment {};

/// What a part is called and how it is colored from now on, on the screen and in files that are written. For people only: the
/// simulation takes no notice of it.
struct SetPartLook {
    std::uint32_t part = 0; ///< index into Model::parts
    std::string name;       ///< empty: as in its file
    std::string color;      ///< sRGB as "#rrggbb"; empty: as in its file
};

/// Names are for people, too: nothing else of the tool or the fixture changes.
struct RenameManipulator {
    ToolId tool = 0;
    std::string name;
};
struct RenameFixture {
    FixtureId fixture = 0;
    std::string name;
};

/// Puts the objects where there is balance without inertia, for what tools, grips and loads are now, and time goes on by `duration`:
/// see Simulation::settle(). It counts as one step.
struct FindBalance {
    double duration = 1.0 / 60; ///< in which what moves goes on and material flows [s]
};

/// Fills a body anew in the shape that it has: it goes on with its material, its motion and its stress, on a lattice without any
/// distortion. Only for material that yields: elastic one would lose the shape that it goes back to.
struct Refill {
    BodyId body = 0;
    double spacing = 0; ///< of its objects from now on [m], 0: as it is
};

/// Cuts a body along a plane, without force and work: connections across it are no more.
struct Cut {
    BodyId body = 0;
    Vec3 point = Vec3::Zero();   ///< of the plane [m]
    Vec3 normal = Vec3::UnitZ(); ///< of any length but 0
};

using Command =
    std::variant<SetMaterial, SetBodyKind, Renormalize, SetGravity, SetFloor, AddManipulator, RemoveManipulator,
                 SetManipulatorMotion, ReshapeManipulator, PlaceManipulator, AddFixture, RemoveFixture, MoveFixture,
                 SetIntegrator, Reset, KeepMoment, SetPartLook, RenameManipulator, RenameFixture, AddLoad, RemoveLoad,
                 SetLoad, FindBalance, SetPace, Refill, Cut>;

/// A command and the step before which it took effect. Steps count on from the Reset before.
struct RecordedCommand {
    std::uint64_t step = 0;
    Command command;
    /// Of the body whose objects the command names, where it had been filled anew by then; 0: they are those of its first filling.
    std::uint32_t objectsInBody = 0;
};

} // namespace knead
