#include "core/session/surface_fields.h"

#include <algorithm>
#include <utility>

namespace knead {

namespace {

constexpr double capTolerance = 1e-4; // of the outline, in sizes of the body: less than a pixel

PlaneSection capOf(const FilledBody& body, const std::vector<Vec3>& places, const CutPlane& plane)
{
    if (places.empty())
        return {};
    return planeSection(places, body.mesh.triangles, plane, capTolerance * boxOfPlaces(places).sizes().maxCoeff());
}

/// Collects stress of several bodies: the error is that of the most stressed one.
struct StressReading {
    float most = 0;
    double errorShare = 0;

    std::vector<float> take(SkinStresses stresses)
    {
        const auto largest = std::ranges::max_element(stresses.vonMises);
        if (largest != stresses.vonMises.end() && *largest > most) {
            most = *largest;
            errorShare = stresses.errorShare;
        }
        return std::move(stresses.vonMises);
    }
};

bool areOfOneMoment(const FramePointer& a, const FramePointer& b)
{
    return a->bodies == b->bodies && a->snapshot == b->snapshot;
}

} // namespace

SurfaceFieldsMaker::SurfaceFieldsMaker(FilledBodies bodies)
    : m_bodies(std::move(bodies))
{
}

SurfaceFieldsMaker::~SurfaceFieldsMaker() = default;

SurfaceFieldsPointer SurfaceFieldsMaker::make(const FramePointer& frame, const SurfaceFieldsRequest& request)
{
    if (m_bodies != frame->filled) {
        m_bodies = frame->filled;
        m_stresses.clear();
    }
    auto fields = std::make_shared<SurfaceFields>();
    fields->frame = frame;
    fields->request = request;
    findValues(*fields);
    findCaps(*fields);
    m_last = fields;
    return fields;
}

void SurfaceFieldsMaker::prepareFor(SurfaceQuantity quantity, std::size_t body)
{
    m_originals.resize(m_bodies.size());
    m_stresses.resize(m_bodies.size());
    const TriangleMesh& mesh = m_bodies[body]->mesh;
    const bool isOfMaterial = quantity == SurfaceQuantity::strain || quantity == SurfaceQuantity::vonMisesStress;
    if (quantity == SurfaceQuantity::distance && !m_originals[body])
        m_originals[body] = std::make_unique<SurfaceDistance>(mesh);
    if (isOfMaterial && !m_stresses[body]) {
        TriangleMesh whenFilled = mesh;
        const std::span<const Vec3> places = m_bodies[body]->skin->points();
        whenFilled.vertices.assign(places.begin(), places.end());
        m_stresses[body] = std::make_unique<SkinStress>(*m_bodies[body]->aggregate, whenFilled);
    }
}

void SurfaceFieldsMaker::findValues(SurfaceFields& fields)
{
    if (!fields.request.quantity)
        return;
    const SurfaceQuantity quantity = *fields.request.quantity;
    if (m_last && m_last->request.quantity == quantity && areOfOneMoment(m_last->frame, fields.frame)) {
        fields.isKnown = m_last->isKnown;
        fields.values = m_last->values;
        fields.errorShare = m_last->errorShare;
        return;
    }
    StressReading reading;
    for (std::size_t b = 0; b < m_bodies.size(); ++b) {
        const FilledBody& body = *m_bodies[b];
        const Snapshot::BodyState& now = fields.frame->snapshot->bodies[b];
        prepareFor(quantity, b);
        const std::vector<ObjectIndex> loaded = loadedObjects(*fields.frame->snapshot, static_cast<BodyId>(b));
        const std::vector<Vec3> displacements = now.displacements();
        SurfaceState state{.aggregate = *body.aggregate,
                           .skin = *body.skin,
                           .displacements = displacements,
                           .stress = m_stresses[b].get(),
                           .loaded = loaded,
                           .relaxed = now.relaxed.get(),
                           .pressing = now.pressing.get(),
                           .original = m_originals[b].get(),
                           .places = fields.frame->bodies[b]->places,
                           .opened = body.mesh.vertices};
        if (now.broken)
            state.broken = *now.broken;
        fields.isKnown = fields.isKnown && isKnown(quantity, state);
        if (fields.isKnown && quantity == SurfaceQuantity::vonMisesStress)
            fields.values.push_back(reading.take(surfaceStresses(state)));
        else
            fields.values.push_back(fields.isKnown ? surfaceValues(quantity, state) : std::vector<float>());
    }
    fields.errorShare = reading.errorShare;
    if (!fields.isKnown)
        fields.values.clear();
}

void SurfaceFieldsMaker::findCaps(SurfaceFields& fields)
{
    if (!fields.request.section)
        return;
    const CutPlane& plane = *fields.request.section;
    const bool isSamePlane = m_last && m_last->request.section == plane;
    if (isSamePlane && m_last->frame->bodies == fields.frame->bodies)
        fields.caps = m_last->caps;
    else
        for (std::size_t b = 0; b < m_bodies.size(); ++b)
            fields.caps.push_back(capOf(*m_bodies[b], fields.frame->bodies[b]->places, plane));
    if (!fields.request.capsOriginal)
        return;
    if (isSamePlane && m_last->request.capsOriginal)
        fields.originalCaps = m_last->originalCaps;
    else
        for (const auto& body : m_bodies)
            fields.originalCaps.push_back(capOf(*body, body->mesh.vertices, plane));
}

} // namespace knead
