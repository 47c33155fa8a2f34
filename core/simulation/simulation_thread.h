#pragma once

#include "core/simulation/scripted_events.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace knead {

/// How much of a recording is known. Another number, another recording: each gesture and each going to a moment begins one.
struct RecordingMark {
    std::uint64_t recording = 0;
    std::size_t commands = 0;

    friend bool operator==(const RecordingMark&, const RecordingMark&) = default;
};

/// What came since.
struct RecordingNews {
    RecordingMark after; ///< what is known these follow; of another recording than was asked for: no commands
    std::vector<RecordedCommand> commands; ///< at the end of the recording
    std::uint64_t step = 0;                ///< at which the simulation is
};

/// Runs a Simulation in a thread of its own, in real time when the machine can: commands in, snapshots out.
/// All members may be called from one other thread (the window's); none of them waits for a step to end.
class SimulationThread {
public:
    /// Starts paused.
    /// @param script carried out beside what is posted; null: none
    explicit SimulationThread(Simulation simulation, std::unique_ptr<ScriptedEvents> script = nullptr);
    /// Stops at the end of the present step and joins.
    ~SimulationThread();
    SimulationThread(const SimulationThread&) = delete;
    SimulationThread& operator=(const SimulationThread&) = delete;

    void play();
    void pause();
    void stepOnce();             ///< one step, while paused; none at the end of the script, as play() stops there
    void reset();                ///< pauses and carries out Reset
    void setSpeed(double ratio); ///< wanted ratio of simulated to wall time, 0.01 .. 10; 1 at first
    void keepUp(bool on); ///< by a rougher Pace where it is slow; it does at first, but not while a script goes on
    void showPressing(bool on); ///< see Simulation::showPressing(); a new snapshot comes at once
    void post(Command command); ///< takes effect at the next step, at once while paused

    /// Pauses and puts the objects where there is balance, see Simulation::settle(). Snapshots wait for it.
    /// @param control called on the simulation's thread
    /// @param told called there with what came of it; with nothing when it was cancelled. It waits for that
    void settle(std::shared_ptr<TaskControl> control, std::function<void(std::optional<StaticReport>)> told);

    /// Ends a gesture at the present step, be it playing or not: what was posted before belongs to it, what is posted from
    /// now on to the next one.
    /// @param kept called on the simulation's thread, which waits for it: it packs what it was given or hands it on
    void endGesture(std::function<void(Gesture)> kept);

    /// Looks at the gesture under way: what was done so far, and at which step it is, so that whoever repeats that much is
    /// where the simulation is now.
    /// @param told called on the simulation's thread, which waits for it
    void lookAtGesture(std::function<void(std::vector<RecordedCommand> commands, std::uint64_t step)> told);

    /// Looks at what came since the last time: takes no longer the longer the gesture is.
    /// @param told as above
    void followGesture(RecordingMark known, std::function<void(RecordingNews)> told);

    /// Pauses and goes to a moment of this scene, see Simulation::goTo(). What was done since the last kept moment is given up.
    /// Snapshots from there on count one arrival more.
    void goTo(MomentPointer moment);

    /// Hands over every snapshot from now on.
    /// @param watcher called on the simulation's thread, which waits for it
    void watch(std::function<void(const SnapshotPointer&)> watcher);

    /// How many requests there were so far: a snapshot that counts as many has seen what all calls before asked for.
    std::uint64_t requests() const;

    /// The newest state; never null. A new pointer whenever anything changed.
    SnapshotPointer latest() const;

private:
    struct Worker;
    std::unique_ptr<Worker> m_worker;
};

} // namespace knead
