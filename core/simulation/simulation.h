#pragma once

#include "core/simulation/command.h"
#include "core/simulation/snapshot.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace knead {

/// The mechanics of a scene, step by step. One thread at a time owns it (SimulationThread in the window); inside it uses
/// as many threads as TBB allows, and the bits of the result do not depend on their number.
class Simulation {
public:
    /// @throws std::runtime_error, in a sentence, when a material or manipulator cannot be simulated.
    explicit Simulation(Scene scene);
    ~Simulation();
    Simulation(Simulation&&) noexcept;
    Simulation& operator=(Simulation&&) noexcept;

    /// Queues a command; it takes effect at the start of the next step, or at once in applyCommands().
    void post(Command command);

    /// Takes queued commands into account without advancing time. A command that cannot be carried out
    /// (no such body, a material out of range) leaves the state as it was and is reported in Snapshot::notice.
    void applyCommands();

    /// Advances by timeStep(). After trouble (see health()) it does nothing until reset().
    void step();

    /// Back to the start: bodies at rest in their first shape, with their present materials and fixtures; tools where they
    /// began, with the motion they began with. Time, energies and the recording begin anew.
    void reset();

    /// Connected pieces of material, by live connections and joints.
    std::size_t components();

    double timeStep() const; ///< largest stable step with a margin, or that of the implicit scheme [s]
    double time() const;     ///< [s]
    std::uint64_t stepCount() const;
    const std::vector<Body>& bodies() const; ///< with their present materials
    const Health& health() const;
    const std::string& integratorReason() const; ///< a sentence on which integrator is in use and why

    /// A copy of the state for other threads. Forces on tools are means since the previous snapshot.
    std::shared_ptr<Snapshot> snapshot();

    /// Hash of the bits of positions and velocities: equal for equal histories.
    std::uint64_t stateHash() const;

    const std::vector<RecordedCommand>& recording() const;

    struct State;

private:
    std::unique_ptr<State> m_state;
};

} // namespace knead
