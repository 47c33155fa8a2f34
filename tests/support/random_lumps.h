#pragma once

#include "io/formats/mesh_writer.h"
#include "support/pressed_part.h"

#include <limits>
#include <string>

/// Two lumps in a file, and what may be done to them, at random.
namespace knead::sessions {

/// The scene of two lumps as files have it.
inline std::string writeLumps(const std::string& path)
{
    const auto lump = [](const std::string& name, double size, double height) {
        return MeshBody{name, Color{},
                        shapes::moved(shapes::box(Vec3::Constant(size)), scenes::placedAt(Vec3(0, 0, height)))};
    };
    writeMeshes(path, {lump("Lump", 4 * lumpSpacing, 0), lump("Lump", 2 * lumpSpacing, 6 * lumpSpacing)});
    return path;
}

/// Everything that scenes and commands can say, at random.
inline Command anyMove(fuzz::Random& random)
{
    const auto number = [&] { return 1e-6 * static_cast<double>(random.below(20'001)) / 3 - 0.003; };
    const Pose place = shapes::tilt(100 * number(), Vec3(number(), number(), 0.01 + number()));
    const auto tool = static_cast<ToolId>(random.below(3));
    Manipulator cylinder{.name = random.chance(50) ? "roller \"1\"" : "", .size = Vec3(0.003, 0.003, 0.01 / 3)};
    cylinder.kind = ToolKind::cylinder;
    cylinder.pose = place;
    cylinder.friction = 1.0 / 3;
    cylinder.speedLimit = 0.7 / 3;
    cylinder.forceLimit = random.chance(50) ? 1.0 / 3 : std::numeric_limits<double>::infinity();
    cylinder.motion = DriveAt{Vec3(number(), number(), -0.1), Vec3(number(), 1.0 / 3, 0)};
    switch (random.below(9)) {
    case 0:
        return SetManipulatorMotion{tool, DriveAt{100 * place.position, Vec3(number(), 1, number())}};
    case 1:
        return SetManipulatorMotion{tool, HoldStill{}};
    case 2:
        return SetManipulatorMotion{tool, FollowKeyFrames{{{1e-3 / 3, place}, {0.01 / 3, Pose{}}, {0.2, place}}}};
    case 3:
        return AddManipulator{cylinder};
    case 4:
        return ReshapeManipulator{.tool = tool,
                                  .size = Vec3::Constant(0.01 / 3),
                                  .friction = 0.1,
                                  .speedLimit = 0.3,
                                  .kind = random.chance(50) ? ToolKind::ball : ToolKind::wedge};
    case 5:
        return Renormalize{0, {3, 4, 5, 90}, random.chance(50) ? 0 : 1e-3 / 3};
    case 6:
        return SetMaterial{1, scenes::clay(), {2, 5, 6}};
    case 7:
        return KeepMoment{};
    default:
        return SetManipulatorMotion{tool, GoTo{place}};
    }
}

/// @param isStopped whether it was, as poor physics may be
/// @param hasLoads which are on no faces that a recipe could name
inline Document randomDocument(const Scene& scene, std::uint64_t seed, bool& isStopped, bool hasLoads = false)
{
    isStopped = false;
    fuzz::Random random(seed);
    Document document(scene);
    for (int i = 0; i < 12; ++i) {
        if (random.chance(25))
            document.visit(static_cast<Entry>(random.below(document.history.records().size())));
        for (std::size_t n = random.below(12); n > 0; --n) {
            {
                const Command command = random.chance(60) ? anyMove(random) : anyCommand(random);
                if (hasLoads || !std::holds_alternative<AddLoad>(command))
                    document.simulation.post(command);
            }
            for (std::size_t steps = random.below(5); steps > 0; --steps) {
                document.simulation.step();
                isStopped = isStopped || !document.simulation.health().ok;
            }
        }
        endGesture(document, "gesture " + std::to_string(i));
    }
    return document;
}

/// A scene in which every key of a recipe has something to say.
inline Scene richScene(const Model& model)
{
    Scene scene = restingScene(model, lumpSpacing);
    scene.bodies[0].velocity = Vec3(0, 0, 0.1 / 3);
    scene.bodies[1].velocity = Vec3(0, 0.01 / 7, -0.3);
    scene.bodies[1].angularVelocity = Vec3(1.0 / 3, 0, 20);
    scene.bodies[1].material = scenes::clay();
    scene.bodies[0].regions = {{"", {1, 2, 3}, scenes::clay()}, {"soft", {7, 9, 40}, scenes::soft(0.1)}};
    scene.floorHeight = -2.5 * lumpSpacing;
    scene.floorFriction = 1.0 / 3;
    scene.gravity = Vec3(0, 0, -9.81);
    scene.touching = Touching::glued;
    scene.vicinity = VicinityMethod::halfPartition;
    scene.integrator = Integrator::automatic;
    scene.fixtures = {{"hold", 0, {0, 1, 2, 3, 4}, {}}, {"hold", 1, {0, 5, 11}, Vec3(0, 0, 0.01 / 3)}};
    scene.manipulators = scenes::smallPress(scenes::soft(), 4).manipulators;
    scene.manipulators.push_back(scene.manipulators[0]);
    scene.manipulators[1].motion = GoTo{shapes::tilt(0.3, Vec3(0.02, 0, 0.01))};
    return scene;
}

} // namespace knead::sessions
