#include "ui/document/arrival.h"

#include "core/simulation/moment.h"
#include "core/simulation/replay.h"

#include <algorithm>
#include <utility>

namespace knead {

Arrival Journey::go(TaskControl& control) const
{
    Arrival arrival;
    arrival.content = start.content;
    TaskPortion preparing(control, 0, 0.3);
    if (!arrival.content)
        arrival.content = std::make_shared<const Content>(contentOf(model, start.choices, start.start, preparing));
    TaskPortion repeating(control, start.content ? 0 : 0.3, 1);
    const Scene& scene = start.start.scene;
    arrival.moment = follow(way, scene, packing, repeating);
    if (!way.commands.empty())
        arrival.found = std::make_shared<const Bytes>(momentToBytes(*arrival.moment, packing));
    if (changesStart) {
        arrival.simulation.emplace(scene);
        arrival.simulation->goTo(arrival.moment);
        arrival.frame = prepareFrame(arrival.content->bodies, arrival.simulation->snapshot(), nullptr);
    }
    return arrival;
}

Branch Journey::branch(const std::vector<RecordedCommand>& commands, std::uint32_t run, std::uint64_t upToStep,
                       TaskControl& control) const
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
