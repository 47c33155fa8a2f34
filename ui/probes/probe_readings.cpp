#include "ui/probes/probe_readings.h"

#include "core/mechanics/object_strain.h"
#include "ui/document/film.h"

#include <map>

namespace knead {

namespace {

/// Strains of the bodies that have probes, each found once.
class Strains {
public:
    explicit Strains(const Snapshot& snapshot)
        : m_snapshot(snapshot)
    {
    }

    const std::vector<ObjectStrain>& of(const ProbePlace& probe)
    {
        auto& strains = m_strains[probe.id];
        if (strains.empty()) {
            const Snapshot::BodyState& state = m_snapshot.bodies[probe.id];
            const RelaxedState plain{.materials = MaterialMap(Material{}, probe.body->aggregate->size())};
            const std::vector<ConnectionId> none;
            strains = objectStrains(*probe.body->aggregate, state.displacements(),
                                    state.relaxed ? *state.relaxed : plain, state.broken ? *state.broken : none);
        }
        return strains;
    }

private:
    const Snapshot& m_snapshot;
    std::map<BodyId, std::vector<ObjectStrain>> m_strains;
};

/// As the skin goes: displacements and tensors of the objects, each with its share.
ProbeSample sampleOf(const ProbePlace& probe, const Snapshot& snapshot, Strains* strains)
{
    ProbeSample sample{.time = snapshot.time};
    const Snapshot::BodyState& state = snapshot.bodies[probe.id];
    Vec3 displacement = Vec3::Zero();
    for (const auto& [object, share] : probe.shares)
        displacement += share * state.displacement(object);
    sample.displacement = displacement.norm();
    for (const ToolState& tool : snapshot.tools)
        sample.force += tool.force.norm();
    if (strains == nullptr)
        return sample;
    Mat3 strain = Mat3::Zero();
    Mat3 stress = Mat3::Zero();
    for (const auto& [object, share] : probe.shares) {
        strain += share * strains->of(probe)[object].strain;
        stress += share * strains->of(probe)[object].stress;
    }
    sample.strain = equivalentStrain(strain);
    if (state.relaxed)
        sample.stress = vonMisesStress(stress);
    return sample;
}

} // namespace

ProbePlace probePlace(const SkinPlace& place, const ContentBodies& bodies)
{
    return {bodies[place.body], place.body, objectShares(place, *bodies[place.body])};
}

std::vector<ProbeSample> readProbes(const std::vector<ProbePlace>& probes, const Snapshot& snapshot, bool withStrains)
{
    Strains strains(snapshot);
    std::vector<ProbeSample> samples;
    samples.reserve(probes.size());
    for (const ProbePlace& probe : probes)
        samples.push_back(sampleOf(probe, snapshot, withStrains ? &strains : nullptr));
    return samples;
}

/// Only bodies with probes get their positions, in a snapshot that lives as long as this.
std::vector<ProbeSample> readProbes(const std::vector<ProbePlace>& probes, const FilmFrame& frame, bool withStrains)
{
    Snapshot snapshot;
    snapshot.time = frame.time;
    snapshot.tools = frame.tools;
    snapshot.bodies.resize(frame.objects.size());
    for (const ProbePlace& probe : probes) {
        Snapshot::BodyState& state = snapshot.bodies[probe.id];
        state.aggregate = probe.body->aggregate;
        const std::vector<float>& floats = frame.objects[probe.id];
        state.positions.resize(floats.size() / 3);
        for (std::size_t i = 0; i < state.positions.size(); ++i)
            state.positions[i] = Vec3(floats[3 * i], floats[3 * i + 1], floats[3 * i + 2]);
        state.broken = frame.broken.empty() ? nullptr : frame.broken[probe.id];
        state.relaxed = frame.relaxed.empty() ? nullptr : frame.relaxed[probe.id];
    }
    return readProbes(probes, snapshot, withStrains);
}

} // namespace knead
