#include "ui/viewport/sight.h"

#include <algorithm>
#include <utility>

namespace knead {

namespace {

constexpr double capTolerance = 1e-4; // of the outline, in sizes of the body: less than a pixel

Box boxOf(const std::vector<Vec3>& places)
{
    Box box;
    for (const Vec3& place : places)
        box.extend(place);
    return box;
}

PlaneSection capOf(const ContentBody& body, const std::vector<Vec3>& places, const CutPlane& plane)
{
    if (places.empty())
        return {};
    return planeSection(places, body.mesh.triangles, plane, capTolerance * boxOf(places).sizes().maxCoeff());
}

/// Collects stress of several bodies: the error is that of the most stressed one.
struct StressReading {
    float most = 0;
    double errorShare = 0;

    std::vector<float> take(SkinStresses stresses)
    {
        const auto largest = std::max_element(stresses.vonMises.begin(), stresses.vonMises.end());
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

SightMaker::SightMaker(ContentBodies bodies)
    : m_bodies(std::move(bodies))
{
}

SightMaker::~SightMaker() = default;

SightPointer SightMaker::make(const FramePointer& frame, const SightWish& wish)
{
    if (m_bodies != frame->filled) {
        m_bodies = frame->filled;
        m_stresses.clear();
    }
    auto sight = std::make_shared<Sight>();
    sight->frame = frame;
    sight->wish = wish;
    findValues(*sight);
    findCaps(*sight);
    m_last = sight;
    return sight;
}

void SightMaker::prepareFor(SurfaceQuantity quantity, std::size_t body)
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

void SightMaker::findValues(Sight& sight)
{
    if (!sight.wish.quantity)
        return;
    const SurfaceQuantity quantity = *sight.wish.quantity;
    if (m_last && m_last->wish.quantity == quantity && areOfOneMoment(m_last->frame, sight.frame)) {
        sight.isKnown = m_last->isKnown;
        sight.values = m_last->values;
        sight.errorShare = m_last->errorShare;
        return;
    }
    StressReading reading;
    for (std::size_t b = 0; b < m_bodies.size(); ++b) {
        const ContentBody& body = *m_bodies[b];
        const Snapshot::BodyState& now = sight.frame->snapshot->bodies[b];
        prepareFor(quantity, b);
        const std::vector<ObjectIndex> loaded = loadedObjects(*sight.frame->snapshot, static_cast<BodyId>(b));
        const std::vector<Vec3> displacements = now.displacements();
        SurfaceState state{.aggregate = *body.aggregate,
                           .skin = *body.skin,
                           .displacements = displacements,
                           .stress = m_stresses[b].get(),
                           .loaded = loaded,
                           .relaxed = now.relaxed.get(),
                           .pressing = now.pressing.get(),
                           .original = m_originals[b].get(),
                           .places = sight.frame->bodies[b]->places,
                           .opened = body.mesh.vertices};
        if (now.broken)
            state.broken = *now.broken;
        sight.isKnown = sight.isKnown && isKnown(quantity, state);
        if (sight.isKnown && quantity == SurfaceQuantity::vonMisesStress)
            sight.values.push_back(reading.take(surfaceStresses(state)));
        else
            sight.values.push_back(sight.isKnown ? surfaceValues(quantity, state) : std::vector<float>());
    }
    sight.errorShare = reading.errorShare;
    if (!sight.isKnown)
        sight.values.clear();
}

void SightMaker::findCaps(Sight& sight)
{
    if (!sight.wish.section)
        return;
    const CutPlane& plane = *sight.wish.section;
    const bool isSamePlane = m_last && m_last->wish.section == plane;
    if (isSamePlane && m_last->frame->bodies == sight.frame->bodies)
        sight.caps = m_last->caps;
    else
        for (std::size_t b = 0; b < m_bodies.size(); ++b)
            sight.caps.push_back(capOf(*m_bodies[b], sight.frame->bodies[b]->places, plane));
    if (!sight.wish.capsOriginal)
        return;
    if (isSamePlane && m_last->wish.capsOriginal)
        sight.originalCaps = m_last->originalCaps;
    else
        for (const auto& body : m_bodies)
            sight.originalCaps.push_back(capOf(*body, body->mesh.vertices, plane));
}

} // namespace knead
