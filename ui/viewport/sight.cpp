#include "ui/viewport/sight.h"

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
    auto sight = std::make_shared<Sight>();
    sight->frame = frame;
    sight->wish = wish;
    findValues(*sight);
    findCaps(*sight);
    m_last = sight;
    return sight;
}

void SightMaker::findValues(Sight& sight)
{
    if (!sight.wish.quantity)
        return;
    const SurfaceQuantity quantity = *sight.wish.quantity;
    if (m_last && m_last->wish.quantity == quantity && areOfOneMoment(m_last->frame, sight.frame)) {
        sight.isKnown = m_last->isKnown;
        sight.values = m_last->values;
        return;
    }
    m_originals.resize(m_bodies.size());
    for (std::size_t b = 0; b < m_bodies.size(); ++b) {
        const ContentBody& body = *m_bodies[b];
        const Snapshot::BodyState& now = sight.frame->snapshot->bodies[b];
        if (quantity == SurfaceQuantity::distance && !m_originals[b])
            m_originals[b] = std::make_unique<SurfaceDistance>(body.mesh);
        const std::vector<Vec3> displacements = now.displacements();
        SurfaceState state{.aggregate = *body.aggregate,
                           .skin = *body.skin,
                           .displacements = displacements,
                           .relaxed = now.relaxed.get(),
                           .pressing = now.pressing.get(),
                           .original = m_originals[b].get(),
                           .places = sight.frame->bodies[b]->places};
        if (now.broken)
            state.broken = *now.broken;
        sight.isKnown = sight.isKnown && isKnown(quantity, state);
        sight.values.push_back(sight.isKnown ? surfaceValues(quantity, state) : std::vector<float>());
    }
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
