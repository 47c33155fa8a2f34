#include "core/simulation/simulation.h"

#include "core/simulation/simulation_state.h"

#include <utility>

namespace knead {

Simulation::Simulation(Scene scene)
    : m_state(std::make_unique<State>(std::move(scene)))
{
}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

void Simulation::step()
{
    State& state = *m_state;
    state.out.clock.begin(state.steps.count);
    state.applyCommands();
    if (!state.watch.health.ok)
        return;
    state.refillWhereBad();
    state.keepVolumes();
    if (state.stepAtRest()) {
        state.out.clock.end(Stage::motion);
        return;
    }
    state.bookToolsInside();
    if (state.isImplicit()) {
        state.out.clock.end(Stage::tools);
        state.changeConnections();
        state.out.clock.end(Stage::material);
        state.stepImplicitly();
        state.watchRest();
        state.out.clock.end(Stage::connections);
    } else {
        state.limitTravel(0);
        state.moveManipulators();
        state.out.clock.end(Stage::tools);
        state.updateVicinity();
        state.bookToolsInside(); // those that jumped
        state.out.clock.end(Stage::vicinity);
        state.changeConnections();
        state.out.clock.end(Stage::material);
        state.computeForces();
        state.out.clock.end(Stage::contacts);
        state.integrate();
        state.out.clock.end(Stage::motion);
    }
    state.cutWithKnives();
    state.checkHealth();
    state.out.clock.end(Stage::checks);
}

void Simulation::post(Command command)
{
    m_state->commands.pending.push_back(std::move(command));
}
void Simulation::applyCommands()
{
    m_state->applyCommands();
}

MomentPointer Simulation::keepMoment()
{
    post(KeepMoment{});
    applyCommands();
    return m_state->lastGood;
}

void Simulation::goTo(MomentPointer moment)
{
    m_state->goTo(std::move(moment));
}

double Simulation::timeStep() const
{
    return m_state->steps.length;
}
double Simulation::time() const
{
    return m_state->steps.time;
}
std::uint64_t Simulation::stepCount() const
{
    return m_state->steps.count;
}
const std::vector<Body>& Simulation::bodies() const
{
    return m_state->bodies;
}
void Simulation::stop(const Message& cause)
{
    m_state->stop(cause, Trouble::failed);
}
std::size_t Simulation::components()
{
    return m_state->components();
}
const Health& Simulation::health() const
{
    return m_state->watch.health;
}
const Message& Simulation::integratorReason() const
{
    return m_state->scheme.reason;
}
const std::vector<RecordedCommand>& Simulation::recording() const
{
    return m_state->commands.recording;
}
std::vector<RecordedCommand> Simulation::takeRecording()
{
    return std::exchange(m_state->commands.recording, {});
}

} // namespace knead
