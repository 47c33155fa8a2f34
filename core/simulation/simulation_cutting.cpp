// What knives and planes cut.
#include "core/simulation/simulation_state.h"

#include <algorithm>

namespace knead {

namespace {

constexpr double nearestEnd = 1e-6; // of a cut, by the length of a connection: what is cut lies within

} // namespace

/// Connections that an edge went through in this step are no more. What they bore is set free.
void Simulation::State::cutWithKnives()
{
    const std::vector<std::vector<BrokenConnection>> cuts = contacts->cuts(surfaces());
    for (BodyId b = 0; b < runs.size(); ++b) {
        if (cuts[b].empty())
            continue;
        accounts.energy.fracture += runs[b]->connections.cut(runs[b]->state, cuts[b], isImplicit() ? 0 : steps.last);
        cracks.areNew = true;
    }
}

/// Cuts a body along a plane, wherever it is now. @param normal unit @return how many connections there were across it
std::size_t Simulation::State::cutAlong(BodyId body, const Vec3& point, const Vec3& normal)
{
    BodyRun& run = *runs[body];
    const auto height = [&](ObjectIndex object) { return (run.state.position.at(object) - point).dot(normal); };
    std::vector<BrokenConnection> cut;
    for (ObjectIndex lower = 0; lower < run.state.size(); ++lower) {
        const double from = height(lower);
        run.connections.forEachConnection(lower, [&](ObjectIndex upper, const ConnectionId& id) {
            if (id.lower != lower)
                return;
            const double to = height(upper);
            if ((from < 0) != (to < 0))
                cut.push_back({id, std::clamp(from / (from - to), nearestEnd, 1 - nearestEnd)});
        });
    }
    if (cut.empty())
        return 0;
    const double before = storedEnergy().imbalance;
    run.connections.cut(run.state, cut, 0);
    touchWhereBroken();
    updateTimeStep();
    contactReport = lookAtContacts();
    travel.lastKick = 0;
    accounts.atStart += storedEnergy().imbalance - before;
    return cut.size();
}

} // namespace knead
