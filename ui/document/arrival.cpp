#include "ui/document/arrival.h"

#include "core/simulation/moment.h"

#include <utility>

namespace knead {

Arrival Journey::go(TaskControl& control) const
{
    Arrival arrival;
    arrival.content = start.content;
    TaskPortion preparing(control, 0, 0.3);
    if (!arrival.content)
        arrival.content = std::make_shared<const Content>(contentOf(model, choices, start.start, preparing));
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

} // namespace knead
