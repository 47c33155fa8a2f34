#include "core/session/history_navigation.h"

#include "core/simulation/moment.h"
#include "core/simulation/replay.h"

#include <algorithm>
#include <utility>

namespace knead {

HistoryDestination HistoryNavigation::go(TaskControl& control) const
{
    HistoryDestination destination;
    destination.content = start.content;
    TaskPortion preparing(control, 0, 0.3);
    if (!destination.content)
        destination.content =
            std::make_shared<const FilledModel>(contentOf(model, start.choices, start.start, preparing));
    TaskPortion repeating(control, start.content ? 0 : 0.3, 1);
    const Scene& scene = start.start.scene;
    destination.moment = follow(way, scene, packing, repeating);
    if (!way.commands.empty())
        destination.found = std::make_shared<const Bytes>(momentToBytes(*destination.moment, packing));
    if (changesStart) {
        destination.simulation.emplace(scene);
        destination.simulation->goTo(destination.moment);
        destination.frame = prepareFrame(destination.content->bodies, destination.simulation->snapshot(), nullptr);
    }
    return destination;
}

Branch HistoryNavigation::branch(const std::vector<RecordedCommand>& commands, std::uint32_t run,
                                 std::uint64_t upToStep, TaskControl& control) const
{
    const Scene& scene = start.start.scene;
    TaskPortion going(control, 0, way.commands.empty() ? 0.05 : 0.5);
    Simulation simulation(scene);
    simulation.goTo(follow(way, scene, packing, going));
    const std::vector<RecordedCommand> before = commandsBefore(commands, run, upToStep);
    const std::uint64_t begin = resetsIn(before) == 0 ? simulation.stepCount() : 0;
    TaskPortion repeating(control, way.commands.empty() ? 0.05 : 0.5, 1);
    simulation = replay(std::move(simulation), before, std::max(begin, upToStep), repeating);
    return {endGesture(simulation)};
}

} // namespace knead
