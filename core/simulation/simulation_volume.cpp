// Bodies that flow keep the volume that their surfaces enclose.
#include "core/simulation/simulation_state.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace knead {

namespace {

// Volume is lost slowly: it is looked at this often [steps]. A look costs as much as a part of a step.
constexpr std::uint64_t looksInExplicitSteps = 128;
constexpr std::uint64_t looksInImplicitSteps = 4;
// A body is looked at when so much of its volume has flowed.
constexpr double leastFlowed = 0.02;

/// Null where the surface does not say.
std::unique_ptr<const EnclosedVolume> enclosedVolumeOf(const Body& body)
{
    try {
        return EnclosedVolume::of(*body.surface, *body.aggregate);
    } catch (const std::runtime_error&) {
        return nullptr;
    }
}

} // namespace

/// See connection_volume.h. Bodies with cracks are left alone, since their surface is open there; so are those in which something keeps
/// its shape at rest, which the surface does not tell from what flows.
bool Simulation::State::keepsVolume(BodyId id) const
{
    const BodyRun& run = *runs[id];
    const auto& materials = run.materials.materials();
    return bodies[id].surface && run.deforms() && bodies[id].aggregate->weight.back().empty() &&
           std::ranges::all_of(materials, [](const Material& material) { return material.yields(); }) &&
           run.connections.changes().broken.empty() && run.connections.flowedShare() > leastFlowed;
}

void Simulation::State::keepVolumes()
{
    if (rest.rests || steps.count % (isImplicit() ? looksInImplicitSteps : looksInExplicitSteps) != 0)
        return;
    for (BodyId id = 0; id < bodies.size(); ++id) {
        if (!keepsVolume(id))
            continue;
        BodyRun& run = *runs[id];
        if (!std::exchange(run.knowsEnclosed, true))
            run.enclosed = enclosedVolumeOf(bodies[id]);
        if (run.enclosed)
            accounts.energy.plastic +=
                run.connections.keepVolume(run.state.position, run.enclosed->ratio(run.displacements()));
    }
}

} // namespace knead
