#include "core/mechanics/contact_objects.h"

#include "core/mechanics/surface_contacts.h"
#include "core/task/parallel.h"

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

// Radii of objects that meet each other, in spacings.
constexpr double smallestRadius = 0.5;
constexpr double largestRadius = 1.5;
// Rounding must not take part of the next layer of objects.
constexpr double belowLayer = 1 - 1e-6;
constexpr double largestOverlapShare = 2;
// An object that is pressed against others touches several at a time; they share what one contact is worth.
constexpr double pairShare = 0.25;

// Contacts of rigid bodies may reach this share of what the deformable ones' time step allows.
constexpr double rigidPairShare = 0.1;

// Objects of one body meet where their outward directions point at each other, by at least so much of the way between
// them: what is stacked below the skin comes nearer too when material is squashed, and is no contact.
constexpr double leastFacing = 0.2;

} // namespace

ContactObjects::ContactObjects(std::vector<ContactBody> bodies)
    : m_bodies(std::move(bodies))
{
    for (std::uint32_t b = 0; b < m_bodies.size(); ++b) {
        m_numberOf.emplace_back(m_bodies[b].connections->aggregate().size(), none);
        addSkin(b);
    }
}

void ContactObjects::add(const ContactObject& object)
{
    m_numberOf[object.ref.body][object.ref.object] = static_cast<std::uint32_t>(m_objects.size());
    m_objects.push_back(object);
}

void ContactObjects::addSkin(std::uint32_t body)
{
    const Aggregate& aggregate = m_bodies[body].connections->aggregate();
    const double a = aggregate.lattice.spacing;
    const auto isDeep = [&](ObjectIndex i) { return aggregate.depth[i] >= smallestRadius * belowLayer * a; };
    const auto isThin = [&](ObjectIndex i) { // no deeper object around
        for (const Lattice::Node& step : Lattice::directions)
            for (const std::int32_t way : {-1, 1}) {
                Lattice::Node node = aggregate.lattice.nodes[i];
                for (std::size_t axis = 0; axis < 3; ++axis)
                    node[axis] += way * step[axis];
                if (const ObjectIndex other = aggregate.lattice.find(node); other < aggregate.size() && isDeep(other))
                    return false;
            }
        return true;
    };
    for (ObjectIndex i = 0; i < aggregate.size(); ++i) {
        const double depth = aggregate.depth[i];
        if (depth >= largestRadius * belowLayer * a)
            continue;
        ContactObject object{.ref = {body, i}, .parameters = {}};
        const bool isFarOutside =
            depth < -smallestRadius * a; // corner of a thin layer: it would touch long before the skin
        object.radius = isDeep(i) ? depth : !isFarOutside && isThin(i) ? smallestRadius * a : 0;
        add(object);
    }
}

void ContactObjects::loosen(const ObjectRef& end)
{
    if (numberOf(end) == none)
        add({.ref = end, .parameters = {}});
    ContactObject& contact = m_objects[numberOf(end)];
    contact.isCut = true;
    contact.radius = smallestRadius * spacingOf(end);
}

void ContactObjects::findSlits(std::uint32_t body)
{
    if (m_bodies[body].kind != BodyKind::deformable)
        return;
    const Lattice& lattice = m_bodies[body].connections->aggregate().lattice;
    std::vector<std::uint8_t> facing(m_objects.size(), 0);
    forEachBlock(m_objects.size(), 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const ContactObject& object = m_objects[i];
            if (object.ref.body != body || object.radius == 0)
                continue;
            // Along the axes is enough: what faces across a slit of any slope has such a pair nearby.
            for (std::size_t axis = 0; axis < 3; ++axis)
                for (const std::int32_t way : {-2, 2}) {
                    Lattice::Node node = lattice.nodes[object.ref.object];
                    node[axis] += way;
                    const ObjectIndex other = lattice.find(node);
                    if (other < lattice.size() && m_numberOf[body][other] != none &&
                        !areNeighbors(object, m_objects[m_numberOf[body][other]]))
                        facing[i] = 1;
                }
        }
    });
    for (std::size_t i = 0; i < m_objects.size(); ++i)
        m_objects[i].facesSlit = m_objects[i].facesSlit || facing[i] != 0;
}

void ContactObjects::updateParameters(const SurfaceContacts& surfaces, double frequency)
{
    for (ContactObject& object : m_objects) {
        const ContactBody& body = m_bodies[object.ref.body];
        const Material& material = materialOf(object.ref);
        const bool deforms = body.kind == BodyKind::deformable;
        const double own = body.state->mass[object.ref.object];
        const double stiffness = deforms ? body.connections->contactStiffness(object.ref.object)
                                         : std::min(body.connections->contactStiffness(object.ref.object),
                                                    rigidPairShare * own * frequency * frequency);
        object.parameters = {.stiffness = stiffness,
                             .damping = 2 * material.dampingRatio * std::sqrt(stiffness * own),
                             .friction = material.friction,
                             .frictionDelay = surfaces.crossingTime(body, object.ref.body, material),
                             .largestOverlap = largestOverlapShare * spacingOf(object.ref)};
    }
}

ContactParameters ContactObjects::between(const ContactObject& a, const ContactObject& b) const
{
    ContactParameters parameters = combine(a.parameters, b.parameters);
    parameters.stiffness *= pairShare;
    parameters.damping *= std::sqrt(pairShare);
    for (const ContactObject* object : {&a, &b})
        if (kindOf(object->ref) == BodyKind::glue)
            parameters.friction = object->parameters.friction;
    return parameters;
}

bool ContactObjects::areNeighbors(const ContactObject& a, const ContactObject& b) const
{
    const StructuralConnections& connections = *m_bodies[a.ref.body].connections;
    std::array<ObjectIndex, 2 * Lattice::directionCount> around{};
    std::size_t count = 0;
    connections.forEachConnection(a.ref.object,
                                  [&](ObjectIndex neighbor, const ConnectionId&) { around[count++] = neighbor; });
    const auto isAround = [&](ObjectIndex object) {
        return std::find(around.begin(), around.begin() + count, object) != around.begin() + count;
    };
    bool near = isAround(b.ref.object);
    connections.forEachConnection(
        b.ref.object, [&](ObjectIndex neighbor, const ConnectionId&) { near = near || isAround(neighbor); });
    return near;
}

/// Where the skin is nearest, as seen from an object now: against the way to its neighbors, each by how much deeper
/// it lies.
Vec3 ContactObjects::outwardOf(const ContactObject& object) const
{
    const ContactBody& body = m_bodies[object.ref.body];
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
bool ContactObjects::isOpen(const ContactObject& object) const
{
    return object.isCut || object.facesSlit || kindOf(object.ref) != BodyKind::deformable;
}

/// Glue with glue and neighbors never are. @param outward of both, where they are of one body and not open
bool ContactObjects::mayBeInContact(std::uint32_t first, std::uint32_t second, const std::vector<Vec3>& outward) const
{
    const ContactObject& a = m_objects[first];
    const ContactObject& b = m_objects[second];
    if (a.ref.body != b.ref.body)
        return kindOf(a.ref) != BodyKind::glue || kindOf(b.ref) != BodyKind::glue;
    if (kindOf(a.ref) == BodyKind::glue)
        return false;
    if (!isOpen(a) && !isOpen(b)) {
        const Vec3 way = (placeOf(b) - placeOf(a)).stableNormalized();
        if (outward[first].dot(way) <= leastFacing || outward[second].dot(way) >= -leastFacing)
            return false;
    }
    return !areNeighbors(a, b);
}

std::vector<VicinityPair> ContactObjects::findPairs(Vicinity& vicinity, double margin) const
{
    std::vector<VicinitySphere> spheres;
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i < m_objects.size(); ++i) {
        const ContactObject& object = m_objects[i];
        if (object.radius == 0)
            continue;
        indices.push_back(i);
        const ContactBody& body = m_bodies[object.ref.body];
        VicinitySphere sphere{.center = placeOf(object), .radius = object.radius, .group = object.ref.body};
        if (body.kind == BodyKind::deformable) {
            sphere.node = body.connections->aggregate().lattice.nodes[object.ref.object];
            sphere.loose = object.isCut || object.facesSlit;
        }
        spheres.push_back(sphere);
    }
    const PairBlocks& near = vicinity.findPairs(spheres, margin);
    std::vector<std::uint8_t> isAsked(m_objects.size(), 0); // for their outward directions
    for (const PairBlock& block : near.blocks())
        for (const VicinityPair& pair : block.pairs())
            if (spheres[pair.first].group == spheres[pair.second].group)
                isAsked[indices[pair.first]] = isAsked[indices[pair.second]] = 1;
    std::vector<Vec3> outward(m_objects.size(), Vec3::Zero());
    for (const std::uint32_t index : indices)
        if (isAsked[index] != 0 && !isOpen(m_objects[index]))
            outward[index] = outwardOf(m_objects[index]);
    std::vector<VicinityPair> pairs;
    for (const PairBlock& block : near.blocks())
        for (const VicinityPair& pair : block.pairs())
            if (mayBeInContact(indices[pair.first], indices[pair.second], outward))
                pairs.push_back({indices[pair.first], indices[pair.second]});
    sortPairs(pairs, m_objects.size());
    return pairs;
}

double ContactObjects::skinOf(const ObjectRef& object) const
{
    const Aggregate& aggregate = m_bodies[object.body].connections->aggregate();
    const double a = aggregate.lattice.spacing;
    return std::min(2 * aggregate.volume[object.object] / a, a * a);
}

} // namespace knead
