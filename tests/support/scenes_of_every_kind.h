#pragma once

#include "support/material_scenes.h"

#include <functional>
#include <string>
#include <vector>

/// Small scenes that have in them, together, all that a simulation can do: for claims about states and histories.
namespace knead::scenes {

/// A scene that is carried out for some steps, with what is to be seen in it before and after its middle.
struct KindOfScene {
    std::string name;
    Scene scene;
    int steps = 200;                                        ///< of each half
    std::function<bool(const Snapshot&)> shows;             ///< in the middle; null: nothing special
    std::function<std::vector<Command>(int step)> commands; ///< before a step; null: none
};

inline Pose placedAt(const Vec3& position)
{
    return {position, Quaternion::Identity()};
}

inline Body boxAt(const Eigen::Vector3i& cells, double spacing, const Vec3& center, const Material& material,
                  const std::string& name)
{
    return body(shapes::moved(shapes::box(spacing * cells.cast<double>()), placedAt(center)), spacing, material, name);
}

/// A block on a floor that a tool presses.
inline Scene smallPress(const Material& material, int cells = 6)
{
    constexpr double a = 2e-3;
    Scene scene;
    scene.bodies.push_back(box({cells, cells, cells}, a, material));
    const double half = 0.5 * cells * a;
    scene.floorHeight = -half;
    Manipulator press{.name = "press", .size = {3 * half, 3 * half, 0.01}};
    press.pose.position.z() = half + 0.0052;
    press.motion = DriveAt{Vec3(0, 0, -0.2), Vec3::Zero()};
    scene.manipulators.push_back(press);
    return scene;
}

inline Material soft(double poissonRatio = 0.25)
{
    return {.youngsModulus = 2e5, .poissonRatio = poissonRatio, .dampingRatio = 0.1};
}

inline bool touches(const Snapshot& shot)
{
    return shot.contacts > 0;
}

inline KindOfScene pressedToALimit(const std::string& name, Integrator integrator)
{
    Scene scene = smallPress(soft());
    scene.integrator = integrator;
    scene.manipulators[0].forceLimit = 2;
    const bool isImplicit = integrator == Integrator::implicitEuler;
    if (isImplicit)
        scene.manipulators[0].motion = DriveAt{Vec3(0, 0, -0.005), Vec3::Zero()};
    return {name, scene, isImplicit ? 25 : 200, touches, {}};
}

/// While a tool flies away, steps are short; then they get longer little by little.
inline KindOfScene implicitPress()
{
    constexpr int steps = 25;
    Scene scene = smallPress(soft());
    scene.integrator = Integrator::implicitEuler;
    scene.manipulators[0].motion = DriveAt{Vec3(0, 0, -0.005), Vec3::Zero()};
    Manipulator far{.name = "far", .motion = DriveAt{Vec3(0, 0, 0.25), Vec3::Zero()}};
    far.pose.position.z() = 1;
    scene.manipulators.push_back(far);
    const auto commands = [](int step) -> std::vector<Command> {
        return step == steps ? std::vector<Command>{RemoveManipulator{1}} : std::vector<Command>{};
    };
    return {"implicit", scene, steps, touches, commands};
}

inline KindOfScene brittleBar()
{
    constexpr double a = 2e-3;
    Material brittle = soft(0.4);
    brittle.tensileStrength = 2e4;
    Scene scene = cantilever({10, 4, 4}, a, brittle, Vec3::Zero());
    const Aggregate& bar = *scene.bodies[0].aggregate;
    scene.fixtures.push_back({"grip", 0, objectsInBox(bar, Box(Vec3(9 * a / 2, -1, -1), Vec3(1, 1, 1))), {0.5, 0, 0}});
    return {"fracture", scene, 150, [](const Snapshot& shot) { return shot.broken > 0; }, {}};
}

/// Two lumps that meet: what they do then is up to the material.
inline Scene meetingLumps(const Material& material)
{
    constexpr double a = 2e-3;
    Scene scene;
    scene.bodies.push_back(boxAt({4, 4, 4}, a, Vec3(-2.1 * a, 0, 0), material, "left"));
    scene.bodies.push_back(boxAt({4, 4, 4}, a, Vec3(2.1 * a, 0.1 * a, 0), material, "right"));
    scene.bodies[0].velocity = Vec3(0.3, 0, 0);
    scene.bodies[1].velocity = Vec3(-0.3, 0, 0.05);
    return scene;
}

inline KindOfScene stickyLumps()
{
    Material sticky = soft();
    sticky.adhesion = 1e4;
    return {"adhesion", meetingLumps(sticky), 200, [](const Snapshot& shot) { return shot.joints > 0; }, {}};
}

inline KindOfScene healingLumps(double healingTime, bool isHealed)
{
    Material healing = clay();
    healing.healingTime = healingTime;
    healing.tensileStrength = 2e4;
    if (!isHealed)
        return {"pressed for long", meetingLumps(healing), 60, touches, {}};
    return {"healing", meetingLumps(healing), 100, [](const Snapshot& shot) { return shot.joints > 0; }, {}};
}

inline KindOfScene rigidAndGlue()
{
    constexpr double a = 2e-3;
    Scene scene = meetingLumps(soft());
    scene.bodies[0].kind = BodyKind::rigid;
    scene.bodies[0].angularVelocity = Vec3(5, 20, 10);
    Material glue = soft();
    glue.adhesion = 2e4;
    scene.bodies.push_back(boxAt({4, 4, 2}, a, Vec3(2.1 * a, 0, -3.3 * a), glue, "glue"));
    scene.bodies[2].kind = BodyKind::glue;
    scene.bodies[1].velocity.z() = -0.2;
    const auto commands = [](int step) -> std::vector<Command> {
        if (step == 120)
            return {SetBodyKind{1, BodyKind::rigid}};
        if (step == 260)
            return {SetBodyKind{1, BodyKind::deformable}, SetBodyKind{0, BodyKind::deformable}};
        return {};
    };
    return {"rigid bodies and glue", scene, 200, [](const Snapshot& shot) { return shot.joints > 0; }, commands};
}

inline KindOfScene annealedBar()
{
    constexpr double a = 2e-3;
    Scene scene = cantilever({8, 3, 3}, a, soft(0.4), Vec3(0, 0, -9.81));
    const Aggregate& bar = *scene.bodies[0].aggregate;
    const auto half = objectsInBox(bar, Box(Vec3(-1, -1, -1), Vec3(0, 1, 1)));
    const auto commands = [half](int step) -> std::vector<Command> {
        if (step == 100)
            return {Renormalize{0, half, 0.05}, Renormalize{0, {}, 0.2}};
        if (step == 150)
            return {Renormalize{0, half}};
        return {};
    };
    return {"annealing", scene, 200, [](const Snapshot& shot) { return shot.energy.plastic > 0; }, commands};
}

/// Edits of all kinds, with gaps among the ids of tools and fixtures.
inline KindOfScene editedPress()
{
    Material stiffer = soft(0.3);
    stiffer.youngsModulus = 4e5;
    const auto commands = [stiffer](int step) -> std::vector<Command> {
        Manipulator ball{.name = "ball", .size = Vec3::Constant(0.01)};
        ball.kind = ToolKind::ball;
        ball.pose.position = Vec3(0.02, 0, 0);
        ball.motion = GoTo{placedAt(Vec3(0.008, 0, 0))};
        switch (step) {
        case 20:
            return {AddManipulator{ball}, AddManipulator{ball}, AddFixture{{"hold", 0, {0, 1, 2}}},
                    AddFixture{{"grip", 0, {3, 4}, Vec3(0.01, 0, 0)}}};
        case 40:
            return {RemoveManipulator{1}, RemoveFixture{0}, SetMaterial{0, stiffer, {5, 6, 7, 8}},
                    SetGravity{Vec3(0, 0, -9.81)}};
        case 220:
            return {SetMaterial{0, stiffer}, MoveFixture{1, Vec3(0, 0.02, 0)}, SetFloor{std::nullopt},
                    PlaceManipulator{2, placedAt(Vec3(0, 0, 0.03))}};
        default:
            return {};
        }
    };
    return {"edits", smallPress(soft()), 200, [](const Snapshot& shot) { return shot.tools.size() == 2; }, commands};
}

inline KindOfScene changingIntegrator()
{
    const auto commands = [](int step) -> std::vector<Command> {
        Material stiff = soft();
        stiff.youngsModulus = 2e11;
        switch (step) {
        case 100:
            return {SetIntegrator{Integrator::automatic}, SetMaterial{0, stiff}};
        case 120:
            stiff.youngsModulus = 1e11;
            return {SetMaterial{0, stiff}};
        case 130:
            return {SetMaterial{0, soft()}};
        case 160:
            return {SetIntegrator{Integrator::forwardEuler}};
        default:
            return {};
        }
    };
    Scene scene = cantilever({12, 4, 4}, 2e-3, soft(), Vec3(0, 0, -9.81));
    const auto isImplicit = [](const Snapshot& shot) { return shot.integrator == Integrator::implicitEuler; };
    return {"changing integrator", scene, 115, isImplicit, commands};
}

inline KindOfScene slitAndPart()
{
    Scene scene;
    // Prongs of a cell's width, two apart.
    scene.bodies.push_back(body(shapes::fork(0.008, 0.03, 0.012, 0.008, 0.004), 2e-3, soft(), "fork"));
    for (const double side : {-1.0, 1.0}) {
        Manipulator jaw{.name = "jaw", .size = {0.01, 0.01, 0.03}};
        jaw.pose = placedAt({0.004 + side * 0.0095, 0.024, 0.006});
        jaw.motion = DriveAt{Vec3(-side * 0.5, 0, 0), Vec3::Zero()};
        if (side > 0) {
            jaw.kind = ToolKind::part;
            jaw.part = std::make_shared<const ToolPart>(shapes::box(jaw.size));
        }
        scene.manipulators.push_back(jaw);
    }
    return {"slit and imported tool", scene, 75, touches, {}};
}

/// Clay under a plate that follows key frames.
inline KindOfScene pressedClay()
{
    Material flowing = clay();
    flowing.hardening = 1e4;
    const Scene scene = pressedBlock(box({6, 6, 6}, 2e-3, flowing), 0.012,
                                     {.share = 0.2, .pressTime = 0.006, .waitTime = 0.001, .releaseTime = 0.003});
    return {"clay", scene, 200, [](const Snapshot& shot) { return shot.energy.plastic > 0; }, {}};
}

/// Lumps that lie at each other from the start, the one hard and rigid, the other soft.
inline KindOfScene hardAndSoft()
{
    constexpr double a = 2e-3;
    Scene scene = meetingLumps(soft());
    scene.bodies[1] = boxAt({4, 4, 4}, a, Vec3(1.6 * a, 0.1 * a, 0), soft(), "overlapping");
    Material hard = soft();
    hard.youngsModulus = 2e11;
    scene.bodies.push_back(boxAt({4, 4, 4}, a, Vec3(-6.4 * a, 0, 0.2 * a), hard, "hard"));
    scene.bodies[2].kind = BodyKind::rigid;
    scene.bodies[2].velocity = Vec3(0.8, 0, 0);
    return {"hard and soft", scene, 60, touches, {}};
}

/// A bar with a load that rises, another that is added, changed and taken away, and a grip that turns.
inline KindOfScene loadedAndTurned(Integrator integrator)
{
    constexpr double a = 2e-3;
    Scene scene = cantilever({10, 3, 3}, a, soft(0.3), Vec3(0, 0, -9.81));
    scene.integrator = integrator;
    const Aggregate& bar = *scene.bodies[0].aggregate;
    const TriangleMesh mesh = shapes::box(a * Vec3(10, 3, 3));
    scene.fixtures.push_back({"grip", 0, objectsInBox(bar, Box(Vec3(4.9 * a, -1, -1), Vec3(1, 1, 1)))});
    scene.fixtures[1].turn = {.center = Vec3(5 * a, 0, 0), .angularVelocity = Vec3(4, 0, 0), .angle = 0.5};
    Load load{.name = "pressure", .faces = {5}, .patch = loadPatch(bar, mesh, {5}, std::nullopt)};
    load.amount = {.force = Vec3(0, 0.01, 0), .pressure = 200};
    load.ramp = 0.03;
    scene.loads.push_back(load);
    load = {.name = "twist", .faces = {3}, .patch = loadPatch(bar, mesh, {3}, std::nullopt)};
    load.amount.moment = Vec3(0, 1e-5, 1e-5);
    const auto commands = [load](int step) -> std::vector<Command> {
        switch (step) {
        case 10:
            return {AddLoad{load}};
        case 35:
            return {SetLoad{1, {.force = Vec3(0, 0, 0.01)}, 0.02},
                    MoveFixture{1, Vec3(0, 0, 0.01), {.center = Vec3(0.01, 0, 0), .angularVelocity = Vec3(0, 2, 0)}}};
        case 60:
            return {RemoveLoad{0}};
        default:
            return {};
        }
    };
    return {integrator == Integrator::implicitEuler ? "implicit, loads and turns" : "loads and turns",
            scene,
            45,
            {},
            commands};
}

inline std::vector<KindOfScene> scenesOfEveryKind()
{
    std::vector<KindOfScene> kinds;
    kinds.push_back({"elastic", smallPress(soft()), 200, touches, {}});
    Material damped = soft(0.45);
    damped.shapeDamping = 20;
    kinds.push_back({"volumetric, damped, in blocks", smallPress(damped, 17), 40, touches, {}});
    kinds.push_back(pressedClay());
    kinds.push_back(brittleBar());
    kinds.push_back(stickyLumps());
    kinds.push_back(healingLumps(1e-3, true));
    kinds.push_back(healingLumps(8e-4, false));
    kinds.push_back(hardAndSoft());
    kinds.push_back(rigidAndGlue());
    kinds.push_back(pressedToALimit("force limit", Integrator::semiImplicitEuler));
    kinds.push_back(implicitPress());
    kinds.push_back(pressedToALimit("implicit, force limit", Integrator::implicitEuler));
    kinds.push_back(annealedBar());
    kinds.push_back(editedPress());
    kinds.push_back(changingIntegrator());
    kinds.push_back(slitAndPart());
    kinds.push_back({"as published", publishedBar(), 60, {}, {}});
    Scene scaled = smallPress(soft());
    scaled.massScalingTimeStep = 4e-4;
    kinds.push_back({"mass scaling", scaled, 150, [](const Snapshot& shot) { return shot.addedMass > 0; },
                     [](int step) -> std::vector<Command> {
                         return step == 100 ? std::vector<Command>{SetMaterial{0, soft(0.3)}} : std::vector<Command>{};
                     }});
    Scene seam = meetingLumps(soft());
    seam.bodies[1] = boxAt({4, 4, 4}, 2e-3, Vec3(1.9 * 2e-3, 0, 0), soft(), "glued on");
    seam.bodies[0].regions.push_back({"hard", {0, 1, 2, 3}, clay()});
    seam.touching = Touching::glued;
    kinds.push_back({"glued seam and regions", seam, 150, [](const Snapshot& shot) { return shot.joints > 0; }, {}});
    kinds.push_back(loadedAndTurned(Integrator::semiImplicitEuler));
    kinds.push_back(loadedAndTurned(Integrator::implicitEuler));
    return kinds;
}

/// Carries out steps of a kind of scene, with its commands.
inline void runSteps(Simulation& simulation, const KindOfScene& kind, int from, int to)
{
    for (int step = from; step < to; ++step) {
        if (kind.commands)
            for (const Command& command : kind.commands(step))
                simulation.post(command);
        simulation.step();
    }
}

} // namespace knead::scenes
