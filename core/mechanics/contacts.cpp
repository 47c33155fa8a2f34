#include "core/mechanics/contacts.h"

#include <algorithm>
#include <cmath>

namespace knead {

Contacts::Contacts(std::vector<BodyView> bodies, VicinityMethod method)
    : m_objects(std::move(bodies))
    , m_surfaceContacts(m_objects.bodies())
    , m_listing(m_objects.bodies())
    , m_vicinity(makeVicinity(method))
    , m_brokenSeen(m_objects.bodies().size(), 0)
{
    for (std::uint32_t b = 0; b < m_objects.bodies().size(); ++b)
        m_objects.findSlits(b);
    updateParameters(0);
    keepDistances();
}

double Contacts::setScheme(std::span<const RigidSurface> surfaces, bool isImplicit)
{
    m_listing.setScheme(m_objects.bodies(), isImplicit);
    const double before = m_surfaceContacts.energy(m_objects.bodies(), surfaces);
    m_isImplicit = isImplicit;
    m_surfaceContacts.updateParameters(m_objects.bodies(), m_frequency, m_isImplicit);
    return m_surfaceContacts.energy(m_objects.bodies(), surfaces) - before;
}

void Contacts::updateParameters(double frequency)
{
    m_frequency = frequency > 0 ? frequency : m_frequency > 0 ? m_frequency : 1e4;
    m_objects.updateParameters(m_surfaceContacts, m_frequency);
    m_surfaceContacts.updateParameters(m_objects.bodies(), m_frequency, m_isImplicit);
    m_listing.invalidate();
}

void Contacts::setFrequency(double frequency)
{
    const auto& bodies = m_objects.bodies();
    const bool allDeform = std::all_of(bodies.begin(), bodies.end(),
                                       [](const ContactBody& body) { return body.kind == BodyKind::deformable; });
    if (!allDeform)
        updateParameters(frequency);
    else
        m_frequency = frequency;
}

void Contacts::setKind(std::uint32_t body, BodyKind kind)
{
    m_objects.setKind(body, kind);
    m_objects.findSlits(body);
    updateParameters(0);
}

void Contacts::glueTouching()
{
    m_joining.makeNew(m_objects, m_pairs, gluedJoints(m_objects));
    m_listing.invalidate();
}

/// Pairs that overlap now get a nominal length that leaves their force as it is: that of the contact they had, else
/// their distance.
void Contacts::keepDistances()
{
    std::vector<ContactPair> overlapping = findPairs(m_objects, joints(), *m_vicinity, 0);
    m_statistics = m_vicinity->statistics();
    for (ContactPair& pair : overlapping) {
        const double distance = m_objects.distance(pair.objects);
        const auto known = findPair(m_pairs, pair.objects);
        const bool touched = known != m_pairs.end() && distance < known->nominalLength;
        pair.nominalLength = touched ? known->nominalLength : distance;
    }
    m_kept.forgetThoseApart(m_objects);
    m_kept.keep(overlapping);
}

void Contacts::keepDistancesOf(std::uint32_t body)
{
    std::vector<ContactPair> overlapping = findPairs(m_objects, joints(), *m_vicinity, 0);
    std::erase_if(overlapping, [&](const ContactPair& pair) {
        return m_objects[pair.objects.first].ref.body != body && m_objects[pair.objects.second].ref.body != body;
    });
    for (ContactPair& pair : overlapping)
        pair.nominalLength = m_objects.distance(pair.objects);
    m_kept.keep(overlapping);
}

void Contacts::connectionsBroke(std::span<const RigidSurface> surfaces)
{
    bool any = false;
    for (std::uint32_t b = 0; b < m_objects.bodies().size(); ++b) {
        const StructuralConnections& connections = *m_objects.bodies()[b].connections;
        const std::vector<BrokenConnection>& broken = connections.changes().broken;
        if (m_brokenSeen[b] < broken.size())
            m_released += m_surfaceContacts.connectionsBroke(m_objects.bodies(), surfaces, b, m_brokenSeen[b]);
        for (; m_brokenSeen[b] < broken.size(); ++m_brokenSeen[b]) {
            for (const ObjectIndex end : connections.endsOf(broken[m_brokenSeen[b]]))
                m_objects.loosen({b, end});
            any = true;
        }
    }
    if (!any)
        return;
    updateParameters(0);
    keepDistances();
}

void Contacts::listPairs(std::span<const RigidSurface> surfaces)
{
    connectionsBroke(surfaces); // or pairs that may touch since then would begin with an overlap
    std::vector<ContactPair> before = std::move(m_pairs);
    m_pairs = findPairs(m_objects, joints(), *m_vicinity, m_listing.reach());
    m_statistics = m_vicinity->statistics();
    m_kept.forgetThoseApart(m_objects);
    m_kept.giveTo(m_pairs, m_objects);
    auto old = before.begin();
    for (ContactPair& pair : m_pairs) { // all lists are sorted
        while (old != before.end() && old->objects < pair.objects)
            ++old;
        if (old != before.end() && old->objects == pair.objects) {
            pair.pressed = old->pressed;
            pair.friction = old->friction;
        }
    }
    m_listing.listedPairs(m_objects);
}

void Contacts::updateVicinity(std::span<const RigidSurface> surfaces, double travel, double surfaceTravel)
{
    m_listing.move(travel, surfaceTravel);
    if (m_listing.arePairsDue(m_objects, m_kept))
        listPairs(surfaces);
    if (m_listing.areSurfacesDue(surfaces.size())) {
        m_listing.lookAhead(std::all_of(surfaces.begin(), surfaces.end(), ContactBatch::takesLittle));
        m_surfaceContacts.list(m_objects.bodies(), surfaces, m_listing.reachOfSurfaces());
        m_edges.list(m_objects.bodies(), surfaces, m_listing.reachOfSurfaces());
        m_listing.listedSurfaces(surfaces.size());
    }
    m_listing.end();
}

void Contacts::pushApart(ContactPair& pair, std::span<const RigidSurface> surfaces, const ContactStep& step,
                         Report& report)
{
    if (pair.healed)
        return;
    const ContactObject& first = m_objects[pair.objects.first];
    const ContactObject& second = m_objects[pair.objects.second];
    ObjectState& a = m_objects.stateOf(first);
    ObjectState& b = m_objects.stateOf(second);
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
        if (!step.isTrial && m_joining.healIfPressed(pair, m_objects, state, step.duration)) {
            const double stretch = distance - m_joining.joints().find(first.ref, second.ref)->nominalLength;
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
        report.frictions.push_back({.object = first.ref, .force = result.friction, .velocity = Vec3::Zero()});
        report.frictions.push_back({.object = second.ref, .force = -result.friction, .velocity = Vec3::Zero()});
    }
    ++report.count;
    report.steepness = std::max(report.steepness, result.steepness);
    for (const ObjectRef& object : {first.ref, second.ref})
        m_crowd.add(m_objects.bodies()[object.body], object.body, object.object, 2 * pair.parameters.stiffness);
    if (step.isTrial) {
        report.tangents.push_back({.first = first.ref,
                                   .second = second.ref,
                                   .force = result.force(),
                                   .normal = state.normal,
                                   .resistance = result.resistance,
                                   .drag = result.drag});
        return;
    }
    if (isToolBetween(pair, m_objects, surfaces)) {
        pair.pressed = 0;
        return;
    }
    m_joining.joinIfSticky(pair, m_objects, distance, result.energy);
    // What was pressed in stays: the joint begins without stress.
    if (m_joining.healIfPressed(pair, m_objects, state, step.duration)) {
        report.energy -= result.energy;
        report.plastic += result.energy;
    }
}

Contacts::Report Contacts::computeForces(std::span<const RigidSurface> surfaces, const ContactStep& step)
{
    const std::vector<BodyView>& bodies = m_objects.bodies();
    Report report;
    report.loads.resize(surfaces.size());
    if (!joints().all().empty()) {
        std::vector<ObjectState*> states;
        for (const BodyView& body : bodies)
            states.push_back(body.state);
        const Joints::Report joined = m_joining.joints().computeForces(states, step);
        report.energy += joined.energy;
        report.jointFrictionPower += joined.frictionPower;
        report.plastic += joined.plastic;
        report.fracture += joined.fracture;
        report.tangents = joined.tangents;
        if (joined.ended > 0)
            for (ContactPair& pair : m_pairs)
                if (pair.joined)
                    noteJoint(pair, m_objects, joints());
    }
    for (ContactPair& pair : m_pairs)
        pushApart(pair, surfaces, step, report);
    m_surfaceContacts.computeForces(bodies, surfaces, step, m_crowd, report);
    if (!step.isImplicit() && !step.isTrial)
        m_edges.begin(bodies, surfaces, step.duration);
    m_edges.computeForces(bodies, surfaces, step, m_crowd, report);
    m_joining.makeNew(m_objects, m_pairs);
    report.crowding = m_crowd.take(bodies);
    return report;
}

std::vector<std::vector<Vec3>> Contacts::pressingForces(std::span<const RigidSurface> surfaces,
                                                        const ContactStep& step) const
{
    std::vector<std::vector<Vec3>> forces;
    for (const BodyView& body : m_objects.bodies())
        forces.emplace_back(body.connections->aggregate().size(), Vec3::Zero());
    const auto add = [&](const ContactObject& object, const Vec3& force) {
        forces[object.ref.body][object.ref.object] += force;
    };

    // Lists of its own: those of the steps stay as they are, and may not be there, as after going to a moment.
    const std::unique_ptr<Vicinity> vicinity = makeVicinity(VicinityMethod::uniformGrid);
    std::vector<ContactPair> pairs = findPairs(m_objects, joints(), *vicinity, 0);
    m_kept.giveTo(pairs, m_objects);
    for (const ContactPair& pair : pairs) {
        const ContactObject& first = m_objects[pair.objects.first];
        const ContactObject& second = m_objects[pair.objects.second];
        const Vec3 between = m_objects.placeOf(first) - m_objects.placeOf(second);
        const double distance = between.norm();
        if (pair.joined || pair.healed || distance >= pair.nominalLength || distance == 0)
            continue;
        const ContactState state{.overlap = pair.nominalLength - distance, .normal = between / distance};
        const Vec3 force = contactForce(state, pair.parameters, step).spring;
        add(first, force);
        add(second, -force);
    }
    m_surfaceContacts.addPressing(m_objects.bodies(), surfaces, forces);
    return forces;
}

bool Contacts::isWaiting() const
{
    return m_surfaceContacts.isWaiting() ||
           std::any_of(m_pairs.begin(), m_pairs.end(), [](const ContactPair& pair) { return pair.pressed > 0; });
}

void Contacts::keepInside(std::span<const RigidSurface> surfaces)
{
    updateVicinity(surfaces, 0, 0);
    m_surfaceContacts.keepInside(m_objects.bodies(), surfaces);
}

std::vector<double> Contacts::addedStiffness(std::uint32_t body, double crowding) const
{
    const StructuralConnections& connections = *m_objects.bodies()[body].connections;
    std::vector<double> added(connections.aggregate().size());
    for (ObjectIndex i = 0; i < added.size(); ++i) {
        const bool mayTouch = m_objects.numberOf({body, i}) != ContactObjects::none;
        added[i] = (mayTouch ? std::max(1.0, crowding) : 1) * connections.contactStiffness(i);
    }
    joints().addStiffness(body, added);
    return added;
}

} // namespace knead
