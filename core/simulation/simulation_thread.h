#pragma once

#include "core/simulation/simulation.h"

#include <memory>

namespace knead {

/// Runs a Simulation in a thread of its own, in real time when the machine can: commands in, snapshots out.
/// All members may be called from one other thread (the window's); none of them waits for a step to end.
class SimulationThread {
public:
    /// Starts paused.
    explicit SimulationThread(Simulation simulation);
    /// Stops at the end of the present step and joins.
    ~SimulationThread();
    SimulationThread(const SimulationThread&) = delete;
    SimulationThread& operator=(const SimulationThread&) = delete;

    void play();
    void pause();
    void stepOnce();             ///< one step, while paused
    void reset();                ///< pauses and goes back to the start
    void setSpeed(double ratio); ///< wanted ratio of simulated to wall time, 0.01 .. 10; 1 at first
    void post(Command command);  ///< takes effect at the next step, at once while paused

    /// The newest state; never null. A new pointer whenever anything changed.
    SnapshotPointer latest() const;

private:
    struct Worker;
    std::unique_ptr<Worker> m_worker;
};

} // namespace knead
