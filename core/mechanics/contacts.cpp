#include "core/mechanics/contacts.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace knead {

namespace {

// Candidates are listed this far ahead, in spacings: more means fewer lists, but longer ones.
constexpr double marginShare = 0.5;
constexpr double smallestRadiusShare = 0.25;
constexpr double largestOverlapShare = 2;

} // namespace

SurfacePoint RigidSurface::nearest(const Vec3& place) const
{
    if (shape == Shape::floor)
        return {place.z() - pose.position.z(), Vec3::UnitZ()};
    SurfacePoint point = boxSurface(size, pose.toLocal(place));
    point.normal = pose.rotation * point.normal;
    return point;
}

Box RigidSurface::reach(double margin) const
{
    if (shape == Shape::floor) {
        const double infinite = std::numeric_limits<double>::max();
        return {Vec3(-infinite, -infinite, -infinite), Vec3(infinite, infinite, pose.position.z() + margin)};
    }
    const Vec3 extent = pose.rotation.toRotationMatrix().cwiseAbs() * (0.5 * size) + Vec3::Constant(margin);
    return {pose.position - extent, pose.position + extent};
}

Contacts::Contacts(std::vector<BodyView> bodies)
    : m_bodies(std::move(bodies))
{
    for (std::uint32_t b = 0; b < m_bodies.size(); ++b) {
        const Aggregate& aggregate = *m_bodies[b].aggregate;
        const double a = aggregate.lattice.spacing;
        m_margin = std::max(m_margin, marginShare * a);
        for (ObjectIndex i = 0; i < aggregate.size(); ++i)
            if (aggregate.depth[i] < a * (1 - 1e-6)) // one layer; rounding must not take part of the next
                m_objects.push_back({.body = b,
                                     .object = i,
                                     .reach = std::max(aggregate.depth[i], -a),
                                     .radius = std::max(aggregate.depth[i], smallestRadiusShare * a),
                                     .parameters = {}});
    }
    updateParameters();
    for (ContactPair& pair : findPairs(0)) {
        const ContactObject& first = m_objects[pair.objects.first];
        const ContactObject& second = m_objects[pair.objects.second];
        pair.nominalLength =
            (stateOf(first).position.at(first.object) - stateOf(second).position.at(second.object)).norm();
        m_touchingAtStart.push_back(pair);
    }
}

void Contacts::updateParameters()
{
    for (ContactObject& object : m_objects) {
        const BodyView& body = m_bodies[object.body];
        const double mass = body.state->mass[object.object];
        const double stiffness = body.connections->contactStiffness(object.object);
        object.parameters = {.stiffness = stiffness,
                             .damping = 2 * body.material->dampingRatio * std::sqrt(stiffness * mass),
                             .friction = body.material->friction,
                             .reducedMass = mass,
                             .largestOverlap = largestOverlapShare * body.aggregate->lattice.spacing};
    }
}

std::vector<Contacts::ContactPair> Contacts::findPairs(double margin)
{
    std::vector<VicinitySphere> spheres;
    spheres.reserve(m_objects.size());
    for (const ContactObject& object : m_objects)
        spheres.push_back({stateOf(object).position.at(object.object), object.radius, object.body});
    m_grid.build(spheres, margin);
    if (m_bodies.size() < 2)
        return {};
    std::vector<ContactPair> pairs;
    for (const VicinityPair& pair : m_grid.pairs())
        pairs.push_back({pair, m_objects[pair.first].radius + m_objects[pair.second].radius});
    return pairs;
}

void Contacts::rebuild(std::span<const RigidSurface> surfaces)
{
    m_pairs = findPairs(m_margin);
    auto known = m_touchingAtStart.begin();
    for (ContactPair& pair : m_pairs) { // both lists are sorted
        while (known != m_touchingAtStart.end() && known->objects < pair.objects)
            ++known;
        if (known != m_touchingAtStart.end() && known->objects == pair.objects)
            pair.nominalLength = known->nominalLength;
    }
    double largestReach = 0;
    for (const BodyView& body : m_bodies)
        largestReach = std::max(largestReach, body.aggregate->lattice.spacing);
    m_nearSurface.clear();
    for (const RigidSurface& surface : surfaces)
        m_nearSurface.push_back(m_grid.inBox(surface.reach(largestReach + m_margin)));
    m_travel = 0;
    m_surfaceTravel = 0;
    m_valid = true;
}

void Contacts::updateVicinity(std::span<const RigidSurface> surfaces, double travel, double surfaceTravel)
{
    m_travel += travel;
    m_surfaceTravel += surfaceTravel;
    const bool tooFar = 2 * m_travel > m_margin || m_travel + m_surfaceTravel > m_margin;
    if (!m_valid || tooFar || surfaces.size() != m_nearSurface.size())
        rebuild(surfaces);
}

void Contacts::pushApart(const ContactPair& pair, double dt, Report& report) const
{
    const ContactObject& first = m_objects[pair.objects.first];
    const ContactObject& second = m_objects[pair.objects.second];
    ObjectState& a = stateOf(first);
    ObjectState& b = stateOf(second);
    const Vec3 between = a.position.at(first.object) - b.position.at(second.object);
    const double distance = between.norm();
    if (distance >= pair.nominalLength || distance == 0)
        return;
    const ContactResult result =
        contactForce({.overlap = pair.nominalLength - distance,
                      .normal = between / distance,
                      .relativeVelocity = a.velocity.at(first.object) - b.velocity.at(second.object)},
                     combine(first.parameters, second.parameters), dt);
    a.force.add(first.object, result.spring);
    a.damping.add(first.object, result.damping);
    b.force.add(second.object, -result.spring);
    b.damping.add(second.object, -result.damping);
    report.energy += result.energy;
    ++report.count;
}

void Contacts::pushOff(const ContactObject& object, const RigidSurface& surface, double dt, SurfaceLoad& load,
                       Report& report) const
{
    ObjectState& state = stateOf(object);
    const Vec3 place = state.position.at(object.object);
    const SurfacePoint point = surface.nearest(place);
    if (point.distance >= object.reach)
        return;
    const Vec3 surfaceVelocity = surface.velocityAt(place);
    ContactParameters parameters = object.parameters;
    parameters.friction = std::sqrt(parameters.friction * surface.friction);
    const ContactResult result = contactForce({.overlap = object.reach - point.distance,
                                               .normal = point.normal,
                                               .relativeVelocity = state.velocity.at(object.object) - surfaceVelocity},
                                              parameters, dt);
    state.force.add(object.object, result.spring);
    state.damping.add(object.object, result.damping);
    load.force -= result.force();
    load.torque -= (place - surface.pose.position).cross(result.force());
    load.power += result.force().dot(surfaceVelocity);
    report.energy += result.energy;
    report.brakingPower -= result.damping.dot(surfaceVelocity);
    ++report.count;
}

Contacts::Report Contacts::computeForces(std::span<const RigidSurface> surfaces, double dt)
{
    Report report;
    report.loads.resize(surfaces.size());
    for (const ContactPair& pair : m_pairs)
        pushApart(pair, dt, report);
    for (std::size_t s = 0; s < surfaces.size(); ++s)
        for (const std::uint32_t candidate : m_nearSurface[s])
            pushOff(m_objects[candidate], surfaces[s], dt, report.loads[s], report);
    return report;
}

} // namespace knead
