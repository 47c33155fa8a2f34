#include "core/mechanics/contacts.h"

#include "core/task/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace knead {

namespace {

constexpr std::uint32_t none = 0xffffffffU;

// Candidates are listed this far ahead, in spacings: more means fewer lists, but longer ones.
constexpr double marginShare = 0.5;
// So much further for steps of the implicit scheme.
constexpr double aheadShare = 1;
// Radii of objects that meet each other, in spacings.
constexpr double smallestRadius = 0.5;
constexpr double largestRadius = 1.5;
// Rounding must not take part of the next layer of objects.
constexpr double belowLayer = 1 - 1e-6;
constexpr double largestOverlapShare = 2;
// An object that is pressed against others touches several at a time; they share what one contact is worth.
constexpr double pairShare = 0.25;

// Contacts of rigid bodies may reach this share of what the deformable ones' time step allows.
constexpr double rigidShare = 0.1;

template <typename Pair>
auto findPair(std::vector<Pair>& sorted, const VicinityPair& wanted)
{
    const auto found = std::lower_bound(sorted.begin(), sorted.end(), wanted,
                                        [](const Pair& pair, const VicinityPair& key) { return pair.objects < key; });
    return found != sorted.end() && found->objects == wanted ? found : sorted.end();
}

} // namespace

Contacts::Contacts(std::vector<BodyView> bodies, VicinityMethod method)
    : m_bodies(std::move(bodies))
    , m_brokenSeen(m_bodies.size(), 0)
    , m_vicinity(makeVicinity(method))
    , m_surfaceContacts(m_bodies)
{
    addSkins();
    for (std::uint32_t b = 0; b < m_bodies.size(); ++b)
        findSlits(b);
    updateParameters(0);
    keepDistances();
}

void Contacts::addSkins()
{
    for (std::uint32_t b = 0; b < m_bodies.size(); ++b) {
        m_margin = std::max(m_margin, marginShare * m_bodies[b].connections->aggregate().lattice.spacing);
        m_indexOf.emplace_back(m_bodies[b].connections->aggregate().size(), none);
        addSkin(b);
    }
}

double Contacts::setScheme(std::span<const RigidSurface> surfaces, bool isImplicit)
{
    m_ahead = 0;
    for (const BodyView& body : m_bodies)
        if (isImplicit)
            m_ahead = std::max(m_ahead, aheadShare * body.connections->aggregate().lattice.spacing);
    m_valid = false;
    const double before = m_surfaceContacts.energy(m_bodies, surfaces);
    m_isImplicit = isImplicit;
    m_surfaceContacts.updateParameters(m_bodies, m_frequency, m_isImplicit);
    return m_surfaceContacts.energy(m_bodies, surfaces) - before;
}

void Contacts::addObject(const ContactObject& object)
{
    m_indexOf[object.ref.body][object.ref.object] = static_cast<std::uint32_t>(m_objects.size());
    m_objects.push_back(object);
}

void Contacts::addSkin(std::uint32_t body)
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
        object.radius = isDeep(i) ? depth : isThin(i) ? smallestRadius * a : 0;
        addObject(object);
    }
}

/// The end of a broken connection: from now on it may touch things on its own.
void Contacts::loosen(std::uint32_t body, ObjectIndex object)
{
    const double a = m_bodies[body].connections->aggregate().lattice.spacing;
    if (m_indexOf[body][object] == none)
        addObject({.ref = {body, object}, .parameters = {}});
    ContactObject& contact = m_objects[m_indexOf[body][object]];
    contact.isCut = true;
    contact.radius = smallestRadius * a;
}

/// Objects within two nodes of each other with no way of at most two connections between them face each other across a
/// slit: they may touch.
void Contacts::findSlits(std::uint32_t body)
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
                    if (other < lattice.size() && m_indexOf[body][other] != none &&
                        !areNeighbors(object, m_objects[m_indexOf[body][other]]))
                        facing[i] = 1;
                }
        }
    });
    for (std::size_t i = 0; i < m_objects.size(); ++i)
        m_objects[i].facesSlit = m_objects[i].facesSlit || facing[i] != 0;
}

void Contacts::updateParameters(double frequency)
{
    m_frequency = frequency > 0 ? frequency : m_frequency > 0 ? m_frequency : 1e4;
    for (ContactObject& object : m_objects) {
        const BodyView& body = m_bodies[object.ref.body];
        const Material& material = materialOf(object.ref);
        const bool deforms = body.kind == BodyKind::deformable;
        const double own = body.state->mass[object.ref.object];
        const double stiffness = deforms ? body.connections->contactStiffness(object.ref.object)
                                         : std::min(body.connections->contactStiffness(object.ref.object),
                                                    rigidShare * own * m_frequency * m_frequency);
        object.parameters = {.stiffness = stiffness,
                             .damping = 2 * material.dampingRatio * std::sqrt(stiffness * own),
                             .friction = material.friction,
                             .frictionDelay = m_surfaceContacts.crossingTime(body, object.ref.body, material),
                             .largestOverlap = largestOverlapShare * spacingOf(object.ref)};
    }
    m_surfaceContacts.updateParameters(m_bodies, m_frequency, m_isImplicit);
    m_valid = false;
}

void Contacts::setKind(std::uint32_t body, BodyKind kind)
{
    m_bodies[body].kind = kind;
    findSlits(body);
    updateParameters(0);
}

ContactParameters Contacts::between(const ContactObject& a, const ContactObject& b) const
{
    ContactParameters parameters = combine(a.parameters, b.parameters);
    parameters.stiffness *= pairShare;
    parameters.damping *= std::sqrt(pairShare);
    for (const ContactObject* object : {&a, &b})
        if (m_bodies[object->ref.body].kind == BodyKind::glue)
            parameters.friction = object->parameters.friction;
    return parameters;
}

bool Contacts::areNeighbors(const ContactObject& a, const ContactObject& b) const
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

double Contacts::lengthOf(const ContactPair& pair) const
{
    return (placeOf(m_objects[pair.objects.first]) - placeOf(m_objects[pair.objects.second])).norm();
}

/// What was kept is forgotten once two are as far apart as contacts are. @return whether there was any
bool Contacts::forgetThoseApart()
{
    return std::erase_if(m_keptDistances, [&](const ContactPair& pair) {
               return lengthOf(pair) >= m_objects[pair.objects.first].radius + m_objects[pair.objects.second].radius;
           }) > 0;
}

/// Pairs that overlap now get a nominal length that leaves their force as it is: that of the contact they had, else their
/// distance.
void Contacts::keepDistances()
{
    std::vector<ContactPair> overlapping = findPairs(*m_vicinity, 0);
    m_statistics = m_vicinity->statistics();
    for (ContactPair& pair : overlapping) {
        const double distance = lengthOf(pair);
        const auto known = findPair(m_pairs, pair.objects);
        const bool touched = known != m_pairs.end() && distance < known->nominalLength;
        pair.nominalLength = touched ? known->nominalLength : distance;
    }
    forgetThoseApart();
    std::vector<ContactPair> all;
    std::set_union(overlapping.begin(), overlapping.end(), m_keptDistances.begin(), m_keptDistances.end(),
                   std::back_inserter(all),
                   [](const ContactPair& a, const ContactPair& b) { return a.objects < b.objects; });
    m_keptDistances = std::move(all);
}

void Contacts::keepDistancesOf(std::uint32_t body)
{
    std::vector<ContactPair> overlapping = findPairs(*m_vicinity, 0);
    std::erase_if(overlapping, [&](const ContactPair& pair) {
        return m_objects[pair.objects.first].ref.body != body && m_objects[pair.objects.second].ref.body != body;
    });
    for (ContactPair& pair : overlapping)
        pair.nominalLength = lengthOf(pair);
    std::vector<ContactPair> all;
    std::set_union(overlapping.begin(), overlapping.end(), m_keptDistances.begin(), m_keptDistances.end(),
                   std::back_inserter(all),
                   [](const ContactPair& a, const ContactPair& b) { return a.objects < b.objects; });
    m_keptDistances = std::move(all);
}

void Contacts::connectionsBroke(std::span<const RigidSurface> surfaces)
{
    bool any = false;
    for (std::uint32_t b = 0; b < m_bodies.size(); ++b) {
        const std::vector<BrokenConnection>& broken = m_bodies[b].connections->changes().broken;
        if (m_brokenSeen[b] < broken.size())
            m_released += m_surfaceContacts.connectionsBroke(m_bodies, surfaces, b, m_brokenSeen[b]);
        for (; m_brokenSeen[b] < broken.size(); ++m_brokenSeen[b]) {
            const ConnectionId& connection = broken[m_brokenSeen[b]];
            for (const ObjectIndex end : m_bodies[b].connections->endsOf(connection))
                loosen(b, end);
            any = true;
        }
    }
    if (!any)
        return;
    updateParameters(0);
    keepDistances();
}

void Contacts::pushApart(ContactPair& pair, std::span<const RigidSurface> surfaces, const ContactStep& step,
                         Report& report)
{
    if (pair.healed)
        return;
    const ContactObject& first = m_objects[pair.objects.first];
    const ContactObject& second = m_objects[pair.objects.second];
    ObjectState& a = stateOf(first);
    ObjectState& b = stateOf(second);
    const Vec3 between = a.position.at(first.ref.object) - b.position.at(second.ref.object);
    const double squared = between.squaredNorm();
    if (squared >= pair.nominalLength * pair.nominalLength || squared == 0) {
        if (!step.isTrial)
            pair.pressed = 0;
        if (step.remembers())
            pair.friction = parted(pair.friction, pair.parameters, step);
        return;
    }
    const double distance = std::sqrt(squared);
    const ContactState state{.overlap = pair.nominalLength - distance,
                             .normal = between / distance,
                             .relativeVelocity = a.velocity.at(first.ref.object) - b.velocity.at(second.ref.object),
                             .memory = pair.friction};
    if (pair.joined) { // its joint pushes; pressed for long enough, it heals
        if (step.remembers())
            pair.friction = {};
        if (!step.isTrial && healIfPressed(pair, state, step.duration)) {
            const double stretch = distance - m_joints.find(first.ref, second.ref)->nominalLength;
            report.plastic += 0.5 * pair.parameters.stiffness * stretch * stretch;
            report.energy -= 0.5 * pair.parameters.stiffness * stretch * stretch;
        }
        return;
    }
    const ContactResult result = contactForce(state, pair.parameters, step);
    if (step.remembers())
        pair.friction = result.memory;
    a.force.add(first.ref.object, result.spring);
    a.damping.add(first.ref.object, result.damping);
    b.force.add(second.ref.object, -result.spring);
    b.damping.add(second.ref.object, -result.damping);
    report.energy += result.energy;
    if (!result.friction.isZero(0)) {
        report.frictions.push_back({first.ref, result.friction, Vec3::Zero()});
        report.frictions.push_back({second.ref, -result.friction, Vec3::Zero()});
    }
    ++report.count;
    report.steepness = std::max(report.steepness, result.steepness);
    for (const ObjectRef& object : {first.ref, second.ref})
        m_crowd.add(m_bodies[object.body], object.body, object.object, 2 * pair.parameters.stiffness);
    if (step.isTrial) {
        report.tangents.push_back({.first = first.ref,
                                   .second = second.ref,
                                   .force = result.force(),
                                   .normal = state.normal,
                                   .resistance = result.resistance});
        return;
    }
    if (isToolBetween(pair, surfaces)) {
        pair.pressed = 0;
        return;
    }
    joinIfSticky(pair, distance, result.energy);
    if (healIfPressed(pair, state, step.duration)) { // what was pressed in stays: the joint begins without stress
        report.energy -= result.energy;
        report.plastic += result.energy;
    }
}

bool Contacts::isWaiting() const
{
    return m_surfaceContacts.isWaiting() ||
           std::any_of(m_pairs.begin(), m_pairs.end(), [](const ContactPair& pair) { return pair.pressed > 0; });
}

Contacts::Report Contacts::computeForces(std::span<const RigidSurface> surfaces, const ContactStep& step)
{
    Report report;
    report.loads.resize(surfaces.size());
    if (!m_joints.all().empty()) {
        std::vector<ObjectState*> states;
        for (const BodyView& body : m_bodies)
            states.push_back(body.state);
        const Joints::Report joints = m_joints.computeForces(states, step);
        report.energy += joints.energy;
        report.jointFrictionPower += joints.frictionPower;
        report.plastic += joints.plastic;
        report.fracture += joints.fracture;
        report.tangents = joints.tangents;
        if (joints.ended > 0)
            for (ContactPair& pair : m_pairs)
                if (pair.joined)
                    noteJoint(pair);
    }
    for (ContactPair& pair : m_pairs)
        pushApart(pair, surfaces, step, report);
    m_surfaceContacts.computeForces(m_bodies, surfaces, step, m_crowd, report);
    if (!step.isImplicit() && !step.isTrial)
        m_edges.begin(m_bodies, surfaces, step.duration);
    m_edges.computeForces(m_bodies, surfaces, step, m_crowd, report);
    makeNewJoints();
    report.crowding = m_crowd.take(m_bodies);
    return report;
}

void Contacts::keepInside(std::span<const RigidSurface> surfaces)
{
    updateVicinity(surfaces, 0, 0);
    m_surfaceContacts.keepInside(m_bodies, surfaces);
}

std::vector<double> Contacts::addedStiffness(std::uint32_t body, double crowding) const
{
    const StructuralConnections& connections = *m_bodies[body].connections;
    std::vector<double> added(connections.aggregate().size());
    for (ObjectIndex i = 0; i < added.size(); ++i)
        added[i] = (m_indexOf[body][i] != none ? std::max(1.0, crowding) : 1) * connections.contactStiffness(i);
    m_joints.addStiffness(body, added);
    return added;
}

} // namespace knead
