#pragma once

#include "core/document/history.h"
#include "core/document/project.h"
#include "core/simulation/replay.h"
#include "support/fuzz_random.h"
#include "support/scenes_of_every_kind.h"

#include <optional>
#include <string>
#include <vector>

/// Sessions as people have them, at random: gestures, undo, branches.
namespace knead::sessions {

using Entry = History::Entry;

inline constexpr double lumpSpacing = 2e-3;

/// Any edit, some of which cannot be carried out.
inline Command anyCommand(fuzz::Random& random)
{
    const auto number = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random.below(1001)) / 1000;
    };
    const auto some = [&] { return static_cast<std::uint32_t>(random.below(3)); };
    Manipulator ball{.name = "ball", .size = Vec3::Constant(0.006)};
    ball.kind = ToolKind::ball;
    ball.pose.position = Vec3(0.0075, number(-0.002, 0.002), 0);
    ball.motion = DriveAt{Vec3(-0.3, 0, 0), Vec3::Zero()};
    switch (random.below(18)) {
    case 0: {
        Material material = random.chance(50) ? scenes::soft(number(0, 0.45)) : scenes::clay();
        material.youngsModulus = number(1e5, 4e5);
        return SetMaterial{some(), material, {}};
    }
    case 1: {
        Material brittle = scenes::soft();
        brittle.tensileStrength = 5e3;
        brittle.adhesion = 1e4;
        return SetMaterial{0, brittle, {1, 2, 3, 4, 5, 6, 7, 8, 9}};
    }
    case 2:
        return SetBodyKind{some(), random.chance(30) ? BodyKind::rigid : BodyKind::deformable};
    case 3:
        return Renormalize{0, {}, random.chance(50) ? 0 : 0.01};
    case 4:
        return SetGravity{Vec3(0, 0, number(-20, 0))};
    case 5:
        return SetFloor{random.chance(50) ? std::optional(-2.5 * lumpSpacing) : std::nullopt};
    case 6:
        return AddManipulator{ball};
    case 7:
        return RemoveManipulator{some()};
    case 8:
        return SetManipulatorMotion{some(), GoTo{scenes::placedAt(Vec3(number(-0.01, 0.01), 0, 0.012))}};
    case 9:
        return PlaceManipulator{some(), scenes::placedAt(Vec3(0, number(-0.02, 0.02), 0.02))};
    case 10:
        return AddFixture{{"grip", 0, {0, 1, 2}, Vec3(0, 0, number(-0.05, 0.05))}};
    case 11:
        return RemoveFixture{some()};
    case 12:
        return MoveFixture{some(), Vec3(number(-0.05, 0.05), 0, 0)};
    case 13:
        return SetIntegrator{random.chance(25) ? Integrator::implicitEuler : Integrator::automatic};
    case 14:
        return MoveFixture{some(), Vec3::Zero(), {Vec3::Zero(), Vec3(0, 0, number(-20, 20)), number(0.01, 0.1)}};
    case 15: {
        Load load{.name = "push", .patch = {{0, 1, 5, 6}, {1e-6, 1e-6, 2e-6, 2e-6}, {4, Vec3(0, 0, 1e-6)}}};
        load.amount = {Vec3(0, 0, number(-0.02, 0.02)), Vec3(number(-1e-5, 1e-5), 0, 0), number(-100, 100)};
        load.ramp = random.chance(50) ? 0 : 0.005;
        return AddLoad{load};
    }
    case 16:
        return random.chance(50) ? Command(RemoveLoad{some()}) : Command(SetLoad{some(), {}, number(0, 0.01)});
    default:
        return random.chance(30) ? Command(Reset{}) : Command(SetGravity{Vec3::Zero()});
    }
}

inline Scene twoLumps()
{
    Scene scene = scenes::smallPress(scenes::soft(), 4);
    scene.bodies.push_back(
        scenes::boxAt({2, 2, 2}, lumpSpacing, Vec3(0, 0, 6 * lumpSpacing), scenes::soft(), "second"));
    scene.bodies[1].velocity = Vec3(0, 0, -0.3);
    return scene;
}

/// A document without a window: a simulation and its history.
struct Document {
    explicit Document(const Scene& start, std::size_t memory = History::defaultMemory)
        : scene(start)
        , simulation(start)
        , history(recordOf(endGesture(simulation), "start"), memory)
    {
    }

    void doSomething(fuzz::Random& random, int mostSteps)
    {
        for (std::size_t i = random.below(3); i > 0; --i)
            simulation.post(anyCommand(random));
        for (std::size_t i = random.below(static_cast<std::size_t>(mostSteps)); i > 0; --i)
            simulation.step();
        history.append(recordOf(endGesture(simulation), "gesture"));
    }

    /// @return whether the state there is the one that was
    bool visit(Entry entry)
    {
        const Way way = history.wayTo(entry);
        const MomentPointer moment = follow(way, scene);
        simulation.goTo(moment);
        repeated += way.commands.empty() ? 0 : 1;
        history.goTo(entry);
        return simulation.stateHash() == history.record(entry).hash &&
               simulation.stepCount() == history.record(entry).step;
    }

    std::uint64_t hashOfStraightRun() const
    {
        std::vector<RecordedCommand> commands;
        for (const Entry entry : history.pathTo(history.current())) {
            const auto& own = history.record(entry).commands;
            commands.insert(commands.end(), own.begin(), own.end());
        }
        return replay(Simulation(scene), commands, simulation.stepCount()).stateHash();
    }

    Scene scene;
    Simulation simulation;
    History history;
    int repeated = 0; ///< visits that had to repeat commands
};

/// What a document leaves behind.
inline Project projectOf(const Document& document, std::shared_ptr<const Model> model = nullptr,
                         std::vector<std::size_t> partOfBody = {})
{
    Project project;
    project.model = std::move(model);
    project.starts = {{document.scene, std::move(partOfBody)}};
    project.entries = document.history.records();
    project.current = document.history.current();
    return project;
}

/// A document in which so many gestures were made, going back now and then.
inline Document branchedDocument(const Scene& scene, std::uint64_t seed, int gestures, int mostSteps = 30)
{
    fuzz::Random random(seed);
    Document document(scene);
    for (int i = 0; i < gestures; ++i) {
        if (random.chance(30))
            document.visit(static_cast<Entry>(random.below(document.history.records().size())));
        document.doSomething(random, mostSteps);
    }
    return document;
}

inline Project withoutMoments(Project project)
{
    for (HistoryRecord& record : project.entries)
        record.moment = nullptr;
    return project;
}

} // namespace knead::sessions
