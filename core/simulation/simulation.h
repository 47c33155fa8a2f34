#pragma once

#include "core/simulation/command.h"
#include "core/simulation/reaction.h"
#include "core/simulation/snapshot.h"
#include "core/simulation/static_report.h"
#include "core/task/task_control.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace knead {

struct Moment;
using MomentPointer = std::shared_ptr<const Moment>;

/// The mechanics of a scene, step by step. One thread at a time owns it (SimulationThread in the window); inside it uses
/// as many threads as TBB allows, and the bits of the result do not depend on their number.
class Simulation {
public:
    /// @throws Problem when a material or manipulator cannot be simulated.
    explicit Simulation(Scene scene);
    ~Simulation();
    Simulation(Simulation&&) noexcept;
    Simulation& operator=(Simulation&&) noexcept;

    /// Queues a command; it takes effect at the start of the next step, or at once in applyCommands().
    void post(Command command);

    /// Takes queued commands into account without advancing time. A command that cannot be carried out
    /// (no such body, a material out of range) leaves the state as it was and is reported in Snapshot::notice.
    void applyCommands();

    /// Advances by timeStep(). After trouble (see health()) it does nothing until Reset or goTo().
    void step();

    /// A load step without inertia: takes queued commands into account, lets tools, grips, loads and material go on for a time,
    /// and puts the objects where there is balance then; nothing moves afterwards. Where the way is too far for one step, it is
    /// halved, up to 64 times. It counts as one step. The scheme is the implicit one from here on. What is left of the work of
    /// loads and tools when all is at rest is in the ledger as `numerical`.
    ///
    /// When it does not come to balance the state is the one before, and the report says why.
    /// @param duration 0 .. 3600 s, > 0
    StaticReport findBalance(double duration);

    /// Carries out FindBalance at once, with progress: as findBalance() does, with the chosen scheme from there on as before. When
    /// there is no balance, or it was cancelled, the state is the one before.
    /// @throws Cancelled
    StaticReport settle(const FindBalance& command, TaskControl& control = TaskControl::none());

    /// Takes queued commands into account and carries out KeepMoment. @return the moment, to be gone back to; never null
    MomentPointer keepMoment();

    /// The simulation goes on as it did from the moment, of this or another simulation of the same scene, bit for bit. Queued
    /// commands are dropped, and the recording begins anew. A moment of other bodies leaves the state as it was and is
    /// reported in Snapshot::notice.
    /// @pre moment is not null
    void goTo(MomentPointer moment);

    /// Something else than the numbers went wrong, within a step or beside it: stops and goes back to the last good state, as
    /// with other trouble.
    /// @param cause a sentence with its remedy
    void stop(const Message& cause);

    /// Connected pieces of material, by live connections and joints.
    std::size_t components();

    double timeStep() const; ///< largest stable step with a margin, or that of the implicit scheme [s]
    double time() const;     ///< [s]
    std::uint64_t stepCount() const;
    const std::vector<Body>& bodies() const; ///< with their present materials
    const Health& health() const;
    const Message& integratorReason() const; ///< a sentence on which integrator is in use and why

    /// Whether snapshots tell what presses on each object, which takes time. Changes nothing else.
    void showPressing(bool on);

    /// What fixtures, tools and loads did in the last step, in this order. Far quicker than a snapshot.
    std::vector<Reaction> reactions() const;

    /// A copy of the state for other threads. Forces on tools are means since the previous snapshot.
    std::shared_ptr<Snapshot> snapshot();

    /// Hash of the bits of positions and velocities: equal for equal histories.
    std::uint64_t stateHash() const;

    /// Commands that were carried out, in order: since the beginning, the last goTo() or the last takeRecording().
    const std::vector<RecordedCommand>& recording() const;
    std::vector<RecordedCommand> takeRecording(); ///< and begins anew

    struct State;

private:
    std::unique_ptr<State> m_state;
};

} // namespace knead
