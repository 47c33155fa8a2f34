#include "core/session/probe_readings.h"

#include "core/mechanics/object_strain.h"
#include "core/session/playback_cache.h"

namespace knead {

namespace {

/// Strain and stress where a probe is.
void readMaterial(const ProbePlace& probe, const Snapshot& snapshot, ProbeSample& sample)
{
    const Snapshot::BodyState& state = snapshot.bodies[probe.id];
    const RelaxedState plain{.materials = MaterialMap(Material{}, probe.body->aggregate->size())};
    const std::vector<BrokenConnection> none;
    const std::vector<Vec3> displacements = state.displacements();
    const ObjectStrains objects(*probe.body->aggregate, displacements, state.relaxed ? *state.relaxed : plain,
                                state.broken ? *state.broken : none);
    sample.strain = static_cast<double>(probe.stress->strains(objects).front());
    if (state.relaxed)
        sample.stress = static_cast<double>(
            probe.stress->stresses(objects, loadedObjects(snapshot, probe.id), false).vonMises.front());
}

/// The displacement goes as the skin does: that of the objects, each with its share.
ProbeSample sampleHere(const ProbePlace& probe, const Snapshot& snapshot, bool withStrains)
{
    ProbeSample sample{.time = snapshot.time};
    const Snapshot::BodyState& state = snapshot.bodies[probe.id];
    Vec3 displacement = probe.carried;
    for (const auto& [object, share] : probe.shares)
        displacement += share * state.displacement(object);
    sample.displacement = displacement.norm();
    for (const ToolState& tool : snapshot.tools)
        sample.force += tool.force.norm();
    if (withStrains)
        readMaterial(probe, snapshot, sample);
    return sample;
}

/// The normal of the triangle that a place is on, when its body was filled.
FreeSurface freeSurfaceAt(const SkinPlace& place, const FilledBody& body)
{
    const Vec3 area = crossOf(body.skin->points(), body.mesh.triangles[place.triangle]);
    if (!(area.norm() > 0))
        return {};
    return {FreeSurface::Kind::face, area.normalized()};
}

ProbePlace probePlace(const SkinPlace& place, const std::shared_ptr<const FilledBody>& body)
{
    const std::span<const Vec3> whenFilled = body->skin->points();
    const std::vector<Vec3> point{placeOf(place, *body, {whenFilled.begin(), whenFilled.end()})};
    return {.body = body,
            .id = place.body,
            .shares = objectShares(place, *body),
            .stress =
                std::make_shared<const SkinStress>(*body->aggregate, point, std::vector{freeSurfaceAt(place, *body)}),
            .place = place,
            .carried = point.front() - placeOf(place, *body, body->mesh.vertices)};
}

/// Of the filling that the body has in a snapshot.
ProbeSample sampleOf(const ProbePlace& probe, const Snapshot& snapshot, bool withStrains)
{
    const auto& filling = snapshot.bodies[probe.id].aggregate;
    if (filling == probe.body->aggregate)
        return sampleHere(probe, snapshot, withStrains);
    const std::shared_ptr<const FilledBody> then = filledAs(probe.body, filling);
    FilledBodies before(probe.id + 1, probe.body);
    const auto place = haveSameSurface(*then, *probe.body) ? probe.place : carriedOver(probe.place, before, {then});
    if (!place)
        return {.time = snapshot.time};
    SkinPlace there = *place;
    there.body = probe.id;
    return sampleHere(probePlace(there, then), snapshot, withStrains);
}

} // namespace

ProbePlace probePlace(const SkinPlace& place, const FilledBodies& bodies)
{
    return probePlace(place, bodies[place.body]);
}

std::vector<ProbeSample> readProbes(const std::vector<ProbePlace>& probes, const Snapshot& snapshot, bool withStrains)
{
    std::vector<ProbeSample> samples;
    samples.reserve(probes.size());
    for (const ProbePlace& probe : probes)
        samples.push_back(sampleOf(probe, snapshot, withStrains));
    return samples;
}

/// Only bodies with probes get their positions, in a snapshot that lives as long as this.
std::vector<ProbeSample> readProbes(const std::vector<ProbePlace>& probes, const PlaybackFrame& frame, bool withStrains)
{
    Snapshot snapshot;
    snapshot.time = frame.time;
    snapshot.tools = frame.tools;
    snapshot.bodies.resize(frame.objects.size());
    for (const ProbePlace& probe : probes) {
        Snapshot::BodyState& state = snapshot.bodies[probe.id];
        state.aggregate = frame.fillings[probe.id];
        state.positions = frame.places(probe.id);
        state.broken = frame.broken.empty() ? nullptr : frame.broken[probe.id];
        state.relaxed = frame.relaxed.empty() ? nullptr : frame.relaxed[probe.id];
    }
    return readProbes(probes, snapshot, withStrains);
}

} // namespace knead
