#include "core/simulation/simulation_state.h"

namespace knead {

std::vector<Reaction> Simulation::reactions() const
{
    const State& state = *m_state;
    std::vector<Reaction> all;
    for (FixtureId id = 0; id < state.grips.fixtures.size(); ++id)
        if (const auto& fixture = state.grips.fixtures[id])
            all.push_back({.kind = Reaction::Kind::fixture,
                           .id = id,
                           .name = fixture->name,
                           .force = id < state.grips.forces.size() ? state.grips.forces[id] : Vec3::Zero(),
                           .moment = id < state.grips.moments.size() ? state.grips.moments[id] : Vec3::Zero(),
                           .about = state.grips.centers[id]});
    for (ToolId id = 0; id < state.tools.size(); ++id)
        if (const auto& tool = state.tools[id])
            all.push_back({.kind = Reaction::Kind::tool,
                           .id = id,
                           .name = tool->manipulator.name,
                           .force = tool->force,
                           .moment = tool->torque,
                           .about = tool->manipulator.pose.position});
    for (LoadId id = 0; id < state.loads.size(); ++id)
        if (state.loads.isThere(id)) {
            const LoadRun& run = state.loads.run(id);
            const ActingLoads::Sum& sum = state.loads.sum(id);
            all.push_back({.kind = Reaction::Kind::load,
                           .id = id,
                           .name = run.load.name,
                           .force = sum.force,
                           .moment = sum.moment,
                           .about = state.loads.center(id)});
        }
    return all;
}

} // namespace knead
