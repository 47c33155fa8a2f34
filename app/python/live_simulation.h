#pragma once

#include "app/python/filled_part.h"
#include "core/mechanics/object_strain.h"
#include "core/message/message.h"
#include "core/model/export_options.h"
#include "core/model/part.h"
#include "core/session/recipe_files.h"
#include "core/simulation/simulation.h"
#include "core/task/task_control.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace knead::python {

/// A simulation at a moment, as arrays of a script see it. What is asked for is computed once. Any thread.
class SeenState {
public:
    explicit SeenState(SnapshotPointer snapshot);

    const Snapshot& snapshot() const { return *m_snapshot; }
    const std::vector<Vec3>& displacements(BodyId body) const; ///< from rest [m]
    const std::vector<ObjectStrain>& strains(BodyId body) const;
    const std::vector<double>& vonMises(BodyId body) const; ///< [Pa]

private:
    struct OfBody {
        std::optional<std::vector<Vec3>> displacements;
        std::optional<std::vector<ObjectStrain>> strains;
        std::optional<std::vector<double>> vonMises;
    };

    SnapshotPointer m_snapshot;
    mutable std::recursive_mutex m_mutex;
    mutable std::vector<OfBody> m_bodies;
};

using SeenStatePointer = std::shared_ptr<const SeenState>;

/// A simulation that a script makes and drives: bodies, fixtures and tools first, then steps, and more of them on the way. It begins
/// when something is asked of it that needs it. Any thread, without the interpreter's lock: what takes steps gives way to others
/// between two of them. A thread that asks something of it from within its own computation is refused with a Problem.
/// Held by a shared_ptr.
class LiveSimulation : public std::enable_shared_from_this<LiveSimulation> {
public:
    /// @param world gravity, floor and schemes; its bodies are made here
    /// @throws Problem without bodies, or where one is null
    LiveSimulation(std::vector<std::shared_ptr<FilledPart>> bodies, Scene world);

    const std::vector<std::shared_ptr<FilledPart>>& bodies() const { return m_filled; }

    /// Holds objects of a body: those that are said, in a box and at CAD faces.
    /// @throws Problem when nothing is there
    FixtureId fix(BodyId body, const std::optional<Box>& box, const std::vector<std::uint32_t>& faces, Fixture how);
    /// @throws Problem for a tool that cannot be simulated
    ToolId addTool(const Manipulator& tool);

    /// At once; what is added before anything else is part of what it begins with.
    /// @return the number of what was added; none where nothing was
    /// @throws Problem that says why it makes no sense; then nothing has changed
    std::optional<std::uint32_t> carryOut(Command command);

    /// Goes on by so many steps, or until the step nearest to a time. @throws Problem on numerical trouble, the state is then the last
    /// good one. @throws Cancelled between two steps; it may go on afterwards
    void step(std::uint64_t steps, TaskControl& control);
    void advanceTo(double time, TaskControl& control);
    /// Until so many steps were taken, as what was recorded counts them: numerical trouble at the last of them is part of it.
    /// @throws as step(), and Problem where they were taken before
    void stepTo(std::uint64_t step, TaskControl& control);

    /// Puts the objects where there is balance, see Simulation::settle(). @throws Problem when there is none. @throws Cancelled
    StaticReport settle(double duration, TaskControl& control);

    MomentPointer keepMoment();
    void goTo(const MomentPointer& moment);

    double time();     ///< [s]
    double timeStep(); ///< [s]
    std::uint64_t stepCount();
    std::uint64_t stateHash();
    std::vector<Reaction> reactions(); ///< in the last step
    SeenStatePointer state();          ///< of now

    /// Writes all bodies as they are now; the ending of the file decides the format, pictures among them.
    /// @throws std::runtime_error, in a sentence. @throws Cancelled
    WrittenExports write(const std::string& path, const ExportOptions& options, TaskControl& control);

private:
    class Turn; ///< of the thread that uses the simulation

    /// To threads that wait. @throws Cancelled
    void giveWay(const TaskControl& control) const;
    bool stepTowards(double time); ///< whether it was not there yet
    bool stepTowards(std::uint64_t step);

    // In the turn of the thread.
    Simulation& running(); ///< begins, if it has not
    void apply(Command command);
    FixtureId add(Fixture fixture);
    /// @return the number of what was added; none: the command adds nothing. @throws Problem, as once it runs
    std::optional<std::uint32_t> addToStart(const Command& command);
    const Body& bodyAtStart(BodyId body, const Message& problem) const;
    void stepOnce();
    const SeenStatePointer& seen(); ///< of now

    std::vector<std::shared_ptr<FilledPart>> m_filled;
    std::shared_ptr<const Model> m_model; ///< a part per body
    Scene m_scene;
    std::optional<Simulation> m_simulation;
    SeenStatePointer m_seen; ///< null after anything has changed
    std::mutex m_mutex;
    std::atomic<std::thread::id> m_owner{}; ///< of the mutex
    std::atomic<int> m_waiting{0};          ///< threads
};

} // namespace knead::python
