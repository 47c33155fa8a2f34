// How contacts find their candidates: which pairs of objects, and which objects at surfaces. Part of Contacts.
#include "core/geometry/rigid_fit.h"
#include "core/mechanics/contacts.h"

#include <algorithm>

namespace knead {

namespace {

// A closer look at what has moved may find that so much of the margin is used up at most; else it would soon be due again.
constexpr double usedShare = 0.5;

// Objects of one body meet where their outward directions point at each other, by at least so much of the way between them:
// what is stacked below the skin comes nearer too when material is squashed, and is no contact.
constexpr double leastFacing = 0.2;

} // namespace

/// Where the skin is nearest, as seen from an object now: against the way to its neighbors, each by how much deeper it lies.
Vec3 Contacts::outwardOf(const ContactObject& object) const
{
    const BodyView& body = m_bodies[object.ref.body];
    const std::vector<double>& depth = body.connections->aggregate().depth;
    const ObjectIndex self = object.ref.object;
    const Vec3 here = body.state->position.at(self);
    Vec3 outward = Vec3::Zero();
    body.connections->forEachConnection(self, [&](ObjectIndex neighbor, const ConnectionId&) {
        outward -= (depth[neighbor] - depth[self]) * (body.state->position.at(neighbor) - here);
    });
    return outward.stableNormalized();
}

/// Whether the skin of a body does not say where its surface is.
bool Contacts::isOpen(const ContactObject& object) const
{
    return object.isCut || object.facesSlit || m_bodies[object.ref.body].kind != BodyKind::deformable;
}

/// Glue with glue and neighbors never are. @param outward of all contact objects that are not open
bool Contacts::mayBeInContact(std::uint32_t first, std::uint32_t second, const std::vector<Vec3>& outward) const
{
    const ContactObject& a = m_objects[first];
    const ContactObject& b = m_objects[second];
    if (a.ref.body != b.ref.body)
        return m_bodies[a.ref.body].kind != BodyKind::glue || m_bodies[b.ref.body].kind != BodyKind::glue;
    if (m_bodies[a.ref.body].kind == BodyKind::glue)
        return false;
    if (!isOpen(a) && !isOpen(b)) {
        const Vec3 way = (placeOf(b) - placeOf(a)).stableNormalized();
        if (outward[first].dot(way) <= leastFacing || outward[second].dot(way) >= -leastFacing)
            return false;
    }
    return !areNeighbors(a, b);
}

std::vector<Contacts::ContactPair> Contacts::findPairs(Vicinity& vicinity, double margin) const
{
    std::vector<VicinitySphere> spheres;
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i < m_objects.size(); ++i) {
        const ContactObject& object = m_objects[i];
        if (object.radius == 0)
            continue;
        indices.push_back(i);
        const BodyView& body = m_bodies[object.ref.body];
        VicinitySphere sphere{.center = placeOf(object), .radius = object.radius, .group = object.ref.body};
        if (body.kind == BodyKind::deformable) {
            sphere.node = body.connections->aggregate().lattice.nodes[object.ref.object];
            sphere.loose = object.isCut || object.facesSlit;
        }
        spheres.push_back(sphere);
    }
    std::vector<Vec3> outward(m_objects.size(), Vec3::Zero());
    for (const std::uint32_t index : indices)
        if (!isOpen(m_objects[index]))
            outward[index] = outwardOf(m_objects[index]);
    const PairBlocks& near = vicinity.findPairs(spheres, margin);
    std::vector<VicinityPair> objects;
    for (const PairBlock& block : near.blocks())
        for (const VicinityPair& pair : block.pairs())
            if (mayBeInContact(indices[pair.first], indices[pair.second], outward))
                objects.push_back({indices[pair.first], indices[pair.second]});
    sortPairs(objects, m_objects.size());
    std::vector<ContactPair> pairs;
    pairs.reserve(objects.size());
    for (const VicinityPair& pair : objects) {
        const ContactObject& first = m_objects[pair.first];
        const ContactObject& second = m_objects[pair.second];
        pairs.push_back(
            {.objects = pair, .nominalLength = first.radius + second.radius, .parameters = between(first, second)});
        noteJoint(pairs.back());
    }
    return pairs;
}

/// @param pairs sorted
void Contacts::takeOverLengths(std::vector<ContactPair>& pairs) const
{
    auto kept = m_keptDistances.begin();
    for (ContactPair& pair : pairs) {
        while (kept != m_keptDistances.end() && kept->objects < pair.objects)
            ++kept;
        // Radii may have become smaller since: what is apart now meets again where its spheres do.
        if (kept != m_keptDistances.end() && kept->objects == pair.objects)
            pair.nominalLength = lengthOf(pair) < pair.nominalLength
                                     ? kept->nominalLength
                                     : std::min(kept->nominalLength, pair.nominalLength);
    }
}

void Contacts::listPairs(std::span<const RigidSurface> surfaces)
{
    connectionsBroke(surfaces); // or pairs that may touch since then would begin with an overlap
    std::vector<ContactPair> before = std::move(m_pairs);
    m_pairs = findPairs(*m_vicinity, m_margin + m_ahead);
    m_statistics = m_vicinity->statistics();
    forgetThoseApart();
    takeOverLengths(m_pairs);
    auto old = before.begin();
    for (ContactPair& pair : m_pairs) { // all lists are sorted
        while (old != before.end() && old->objects < pair.objects)
            ++old;
        if (old != before.end() && old->objects == pair.objects) {
            pair.pressed = old->pressed;
            pair.friction = old->friction;
        }
    }
    m_listedAt.clear();
    for (const ContactObject& object : m_objects)
        m_listedAt.push_back(placeOf(object));
    m_travel = 0;
    ++m_listings;
}

/// How far objects may have moved towards each other since pairs were listed: where a body is alone, only what is no rigid
/// motion of all of it.
double Contacts::travelTowardsOthers() const
{
    struct Moved {
        std::vector<Vec3> before;
        std::vector<Vec3> after;
        Box reach;
        double farthest = 0;
    };
    std::vector<Moved> bodies(m_bodies.size());
    for (std::size_t i = 0; i < m_objects.size(); ++i) {
        const ContactObject& object = m_objects[i];
        if (object.radius == 0)
            continue;
        Moved& body = bodies[object.ref.body];
        body.before.push_back(m_listedAt[i]);
        body.after.push_back(placeOf(object));
        const Vec3 reach = Vec3::Constant(object.radius + m_margin + m_ahead);
        body.reach.extend(body.after.back() - reach);
        body.reach.extend(body.after.back() + reach);
        body.farthest = std::max(body.farthest, (body.after.back() - m_listedAt[i]).norm());
    }
    double travel = 0;
    for (const Moved& body : bodies) {
        const bool alone = std::none_of(bodies.begin(), bodies.end(), [&](const Moved& other) {
            return &other != &body && other.reach.intersects(body.reach);
        });
        travel = std::max(travel, alone ? deviationFromRigidMotion(body.before, body.after) : body.farthest);
    }
    return travel;
}

void Contacts::updateVicinity(std::span<const RigidSurface> surfaces, double travel, double surfaceTravel)
{
    m_travel += travel;
    m_travelToSurfaces += travel + surfaceTravel;
    bool tooFar = 2 * m_travel > m_margin;
    if (m_valid && tooFar) {
        // A body that has flown off and back within one listing meets the others anew.
        const bool forgot = forgetThoseApart();
        m_travel = std::min(m_travel, travelTowardsOthers());
        tooFar = forgot || 2 * m_travel > usedShare * m_margin;
    }
    if (!m_valid || tooFar)
        listPairs(surfaces);
    if (!m_valid || m_travelToSurfaces > m_margin || surfaces.size() != m_surfaceCount) {
        m_surfaceContacts.list(m_bodies, surfaces, m_margin + m_ahead);
        m_edges.list(m_bodies, surfaces, m_margin + m_ahead);
        m_surfaceCount = surfaces.size();
        m_travelToSurfaces = 0;
    }
    m_valid = true;
}

} // namespace knead
