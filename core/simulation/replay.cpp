#include "core/simulation/replay.h"

#include "core/message/message.h"

#include <algorithm>
#include <utility>

namespace knead {

namespace {

/// Tells how far a replay has come, by steps.
class Progress {
public:
    Progress(std::uint64_t all, TaskControl& control)
        : m_all(std::max<std::uint64_t>(all, 1))
        , m_control(control)
    {
    }

    void stepDone()
    {
        constexpr std::uint64_t interval = 16; // [steps]
        if (++m_done % interval != 0)
            return;
        m_control.throwIfCancelled();
        m_control.report(static_cast<double>(std::min(m_done, m_all)) / static_cast<double>(m_all), "repeating");
    }

private:
    std::uint64_t m_all;
    std::uint64_t m_done = 0;
    TaskControl& m_control;
};

std::uint64_t stepsOf(std::uint64_t begin, std::span<const RecordedCommand> commands, std::uint64_t upToStep)
{
    std::uint64_t steps = 0;
    std::uint64_t reached = begin;
    for (const RecordedCommand& recorded : commands) {
        steps += recorded.step - std::min(reached, recorded.step);
        reached = std::holds_alternative<Reset>(recorded.command) ? 0 : recorded.step;
    }
    return steps + upToStep - std::min(reached, upToStep);
}

void stepUntil(Simulation& simulation, std::uint64_t step, Progress& progress)
{
    while (simulation.stepCount() < step && simulation.health().ok) {
        simulation.step();
        progress.stepDone();
    }
    if (simulation.stepCount() != step)
        throw Problem(Message("History",
                              "The recording does not belong to this scene: it goes on at step %1, and the run is "
                              "at step %2. Start from the scene it was made with.")
                          .with(step, simulation.stepCount()));
}

} // namespace

Simulation replay(Simulation from, std::span<const RecordedCommand> commands, std::uint64_t upToStep,
                  TaskControl& control)
{
    Progress progress(stepsOf(from.stepCount(), commands, upToStep), control);
    for (const RecordedCommand& recorded : commands) {
        stepUntil(from, recorded.step, progress);
        from.post(recorded.command);
        from.applyCommands();
    }
    stepUntil(from, upToStep, progress);
    return from;
}

} // namespace knead
