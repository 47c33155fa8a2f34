#pragma once

#include "core/simulation/moment.h"
#include "core/simulation/simulation.h"

#include <functional>
#include <memory>
#include <utility>

/// Simulations that go on from what a test makes of their state.
namespace knead::scenes {

/// Goes on from the present state as `change` leaves it.
inline void changeState(Simulation& simulation, const std::function<void(Moment&)>& change)
{
    Moment moment = *simulation.keepMoment();
    change(moment);
    simulation.goTo(std::make_shared<const Moment>(std::move(moment)));
}

/// Breaks all connections of a body between objects that lay below and above a place along an axis at rest.
inline void cut(Simulation& simulation, BodyId body, int axis, double place)
{
    changeState(simulation, [&](Moment& moment) {
        const Aggregate& aggregate = *simulation.bodies()[body].aggregate;
        const auto isAbove = [&](ObjectIndex object) { return aggregate.lattice.position(object)[axis] > place; };
        for (std::uint32_t d = 0; d < Lattice::directionCount; ++d)
            for (const Lattice::Segment& segment : aggregate.lattice.segments[d])
                for (ObjectIndex lower = segment.begin; lower < segment.end; ++lower)
                    if (aggregate.weight[d][lower] > 0 &&
                        isAbove(lower) != isAbove(lower + static_cast<ObjectIndex>(segment.offset)))
                        moment.bodies[body].changes.broken.push_back({d, lower});
    });
}

} // namespace knead::scenes
