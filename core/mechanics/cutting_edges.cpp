// Where edges are in the material, and what they press on it with.
#include "core/mechanics/cutting_edges.h"

#include "core/mechanics/cutting_frame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace knead {

namespace {

// Points of an edge are so far apart [spacings], and there are no more than this.
constexpr double pointDistance = 0.5;
constexpr double mostPoints = 4000;
// The material at a point is that of objects so near [spacings].
constexpr double reach = 1.5;
// What moves further than this in a step takes a shorter one [spacings].
constexpr double farthestStep = 1.25;
// Stiffness of the spring of a point by the shear modulus times its length. In implicit steps it gives at its limit within so much
// at most [spacings].
constexpr double stiffnessShare = 4;
constexpr double implicitShare = 16;
constexpr double mostGive = 0.1;
// An edge that goes on does not answer to how fast it goes. The rest of what its spring would answer stays, so that Newton's method
// does not go far beyond where it stops.
constexpr double slipShare = 0.9;
// Weights of objects that lie to one side are no larger than this; else they are those of distances alone.
constexpr double largestWeight = 1.5;

bool isCuttable(const ContactBody& body)
{
    return body.kind == BodyKind::deformable &&
           body.materials->largest([](const Material& material) { return material.toughness; }) > 0;
}

/// Weights of objects that reproduce what is linear in their places [spacings, from the point]: moving least squares; where they lie
/// too much to one side, those of their distances.
std::array<double, 8> weightsOf(std::span<const Vec3> places)
{
    using Vec4 = Eigen::Vector4d;
    std::array<double, 8> weights{};
    Eigen::Matrix4d moment = Eigen::Matrix4d::Zero();
    double sum = 0;
    for (std::size_t n = 0; n < places.size(); ++n) {
        const double near = 1 - places[n].squaredNorm() / (reach * reach);
        weights[n] = near * near;
        sum += weights[n];
        const Vec4 row(1, places[n].x(), places[n].y(), places[n].z());
        moment += weights[n] * row * row.transpose();
    }
    const Eigen::LDLT<Eigen::Matrix4d> factor(moment);
    const Vec4 shape = factor.solve(Vec4::UnitX());
    std::array<double, 8> linear{};
    double largest = 0;
    double total = 0;
    for (std::size_t n = 0; n < places.size(); ++n) {
        linear[n] = weights[n] * shape.dot(Vec4(1, places[n].x(), places[n].y(), places[n].z()));
        largest = std::max(largest, std::abs(linear[n]));
        total += linear[n];
    }
    const bool isSound = places.size() >= 4 && largest < largestWeight && std::abs(total - 1) < 1e-6;
    if (isSound)
        return linear;
    for (double& weight : weights)
        weight /= sum;
    return weights;
}

/// How deep a place is below the skin, by the object nearest to it: as deep as that, less the way outwards, which is where its
/// neighbors are less deep [m].
double depthOf(const ContactBody& body, ObjectIndex nearest, const Vec3& place)
{
    const std::vector<double>& depth = body.connections->aggregate().depth;
    const Vec3 here = body.state->position.at(nearest);
    Vec3 outward = Vec3::Zero();
    body.connections->forEachConnection(nearest, [&](ObjectIndex neighbor, const ConnectionId&) {
        outward -= (depth[neighbor] - depth[nearest]) * (body.state->position.at(neighbor) - here);
    });
    return depth[nearest] - (place - here).dot(outward.stableNormalized());
}

/// What a point of an edge does to the material.
struct EdgeForce {
    Vec3 force = Vec3::Zero();      ///< [N]
    Mat3 resistance = Mat3::Zero(); ///< see ContactResult
};

/// @param way of the edge in the material within the step [m] @param stiffness per step, dt k
EdgeForce forceOf(const CuttingFrame& frame, bool isWire, const Vec3& hold, const Vec3& way, double k, double limit,
                  double dt)
{
    EdgeForce result;
    if (!isWire) {
        const double wanted = hold.dot(frame.forward) + k * way.dot(frame.forward);
        const double held = std::clamp(wanted, 0.0, limit);
        result.force = held * frame.forward;
        const double answer = wanted <= 0 ? 0 : wanted > limit ? 1 - slipShare : 1;
        result.resistance = answer * dt * k * frame.forward * frame.forward.transpose();
        return result;
    }
    const Mat3 across = Mat3::Identity() - frame.edge * frame.edge.transpose();
    const Vec3 wanted = across * (hold + k * way);
    const double size = wanted.norm();
    const double grip = size > limit ? limit / size : 1;
    result.force = grip * wanted;
    result.resistance = grip * dt * k * across;
    if (grip < 1)
        result.resistance -= slipShare * grip * dt * k / (size * size) * wanted * wanted.transpose();
    return result;
}

} // namespace

std::vector<CuttingEdges::Hold> CuttingEdges::memory() const
{
    std::vector<Hold> holds = m_remembered;
    for (const Edge& edge : m_edges)
        for (std::uint32_t p = 0; p < edge.points.size(); ++p)
            if (!edge.points[p].hold.isZero(0))
                holds.push_back({.surface = edge.id, .point = p, .force = edge.points[p].hold});
    return holds;
}

void CuttingEdges::list(std::span<const ContactBody> bodies, std::span<const RigidSurface> surfaces, double margin)
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, Vec3> before;
    for (const Hold& hold : memory())
        before[{hold.surface, hold.point}] = hold.force;
    m_remembered.clear();
    m_edges.clear();
    double spacing = std::numeric_limits<double>::infinity();
    for (const ContactBody& body : bodies)
        if (isCuttable(body))
            spacing = std::min(spacing, body.spacing());
    if (!std::isfinite(spacing))
        return;
    for (std::uint32_t s = 0; s < surfaces.size(); ++s) {
        const auto blade = surfaces[s].isFloor ? std::nullopt : bladeOf(surfaces[s].shape);
        if (!blade)
            continue;
        Edge edge{.id = surfaces[s].id, .surface = s, .blade = *blade, .nearby = {}, .points = {}};
        for (std::uint32_t b = 0; b < bodies.size(); ++b)
            if (isCuttable(bodies[b]))
                addNearby(edge, bodies[b], b, surfaces[s], margin);
        const double count = std::clamp(std::ceil(blade->length() / (pointDistance * spacing)), 1.0, mostPoints);
        const auto stretches = static_cast<std::uint32_t>(count);
        for (std::uint32_t p = 0; p <= stretches; ++p) {
            Point point{.place = blade->from + p / count * (blade->to - blade->from)};
            point.length = (p == 0 || p == stretches ? 0.5 : 1) * blade->length() / count;
            if (const auto hold = before.find({edge.id, p}); hold != before.end())
                point.hold = hold->second;
            edge.points.push_back(point);
        }
        m_edges.push_back(std::move(edge));
    }
}

void CuttingEdges::addNearby(Edge& edge, const ContactBody& body, std::uint32_t index, const RigidSurface& surface,
                             double margin) const
{
    const double far = (reach + farthestStep) * body.spacing() + margin;
    Box box(edge.blade.from.cwiseMin(edge.blade.to), edge.blade.from.cwiseMax(edge.blade.to));
    box.extend(box.min() - edge.blade.height * edge.blade.forward);
    box.extend(box.max() - edge.blade.height * edge.blade.forward);
    box.min().array() -= far;
    box.max().array() += far;
    Nearby nearby{.body = index, .objects = {}, .connections = {}};
    for (ObjectIndex i = 0; i < body.state->size(); ++i)
        if (box.contains(surface.pose.toLocal(body.state->position.at(i))))
            nearby.objects.push_back(i);
    for (const ObjectIndex object : nearby.objects)
        body.connections->forEachConnectionMade(object, [&](ObjectIndex neighbor, const ConnectionId& id) {
            if (id.lower == object)
                nearby.connections.push_back({id, neighbor});
        });
    if (!nearby.objects.empty())
        edge.nearby.push_back(std::move(nearby));
}

void CuttingEdges::begin(std::span<const ContactBody> bodies, std::span<const RigidSurface> surfaces, double duration)
{
    for (Edge& edge : m_edges) {
        RigidSurface surface = surfaces[edge.surface];
        surface.pose = surface.poseBefore(duration);
        Vec3 way = Vec3::Zero();
        for (Point& point : edge.points) {
            point.before = surface.pose.toWorld(point.place);
            findMaterial(edge, point, bodies);
            if (point.spread.count == 0)
                continue;
            const Vec3 material = point.spread.at(bodies[point.body].state->velocity);
            way += duration * (surface.velocityAt(point.before) - material) +
                   surface.pose.rotation * point.hold * (1 / point.stiffness);
        }
        findUncut(edge, CuttingFrame(edge.blade, surface.pose, way), bodies);
    }
}

/// The material that a point of an edge is in: of the objects around it, as they lie now.
void CuttingEdges::findMaterial(const Edge& edge, Point& point, std::span<const ContactBody> bodies) const
{
    struct Found {
        double squared;
        ObjectIndex object;
        bool operator<(const Found& other) const
        {
            return squared < other.squared || (squared == other.squared && object < other.object);
        }
    };
    point.spread = {};
    point.limit = 0;
    double nearest = std::numeric_limits<double>::infinity();
    for (const Nearby& nearby : edge.nearby) {
        const ContactBody& body = bodies[nearby.body];
        const double a = body.spacing();
        std::array<Found, 8> around{};
        std::size_t count = 0;
        for (const ObjectIndex object : nearby.objects) {
            const Found found{(body.state->position.at(object) - point.before).squaredNorm(), object};
            if (found.squared >= reach * reach * a * a || (count == around.size() && !(found < around.back())))
                continue;
            count = std::min(count + 1, around.size());
            std::size_t place = count - 1;
            for (; place > 0 && found < around[place - 1]; --place)
                around[place] = around[place - 1];
            around[place] = found;
        }
        if (count == 0 || around[0].squared >= nearest)
            continue;
        nearest = around[0].squared;
        std::array<Vec3, 8> places;
        for (std::size_t n = 0; n < count; ++n)
            places[n] = (body.state->position.at(around[n].object) - point.before) / a;
        const std::array<double, 8> weights = weightsOf(std::span(places).first(count));
        point.body = nearby.body;
        point.spread = {.weights = weights, .count = static_cast<std::uint32_t>(count)};
        for (std::size_t n = 0; n < count; ++n)
            point.spread.objects[n] = around[n].object;
        const Material& material = body.materialOf(around[0].object);
        const double depth = depthOf(body, around[0].object, point.before);
        const double inside = std::clamp(0.5 + depth / (pointDistance * a), 0.0, 1.0);
        point.limit = inside * material.toughness * point.length;
        point.stiffness = material.shearModulus() * point.length;
    }
}

/// Of what lies ahead, the share that is cut already or never held does not hold.
void CuttingEdges::findUncut(Edge& edge, const CuttingFrame& frame, std::span<const ContactBody> bodies) const
{
    if (frame.forward.isZero(0))
        return;
    std::vector<double> live(edge.points.size(), 0);
    std::vector<double> made(edge.points.size(), 0);
    const double distance =
        edge.points.size() > 1 ? edge.blade.length() / static_cast<double>(edge.points.size() - 1) : 1;
    for (const Nearby& nearby : edge.nearby) {
        const ContactBody& body = bodies[nearby.body];
        const double a = body.spacing();
        for (const Connection& connection : nearby.connections) {
            const auto crossing =
                frame.crossing(body.state->position.at(connection.id.lower), body.state->position.at(connection.upper));
            if (!crossing || crossing->ahead < 0 || crossing->ahead > reach * a)
                continue;
            const double first = std::ceil((crossing->along - reach / 2 * a) / distance);
            const double last = std::floor((crossing->along + reach / 2 * a) / distance);
            const bool holds = body.connections->stiffness()[connection.id.direction][connection.id.lower] > 0;
            for (double p = std::max(first, 0.0); p <= last && p < static_cast<double>(made.size()); ++p) {
                made[static_cast<std::size_t>(p)] += 1;
                live[static_cast<std::size_t>(p)] += holds ? 1 : 0;
            }
        }
    }
    for (std::size_t p = 0; p < edge.points.size(); ++p)
        if (made[p] > 0)
            edge.points[p].limit *= live[p] / made[p];
}

void CuttingEdges::computeForces(std::span<const ContactBody> bodies, std::span<const RigidSurface> surfaces,
                                 const ContactStep& step, ContactCrowd& crowd, ContactReport& report)
{
    if (step.isStatic)
        return;
    for (Edge& edge : m_edges) {
        const RigidSurface& surface = surfaces[edge.surface];
        const CuttingFrame frame(edge.blade, surface.pose, Vec3::Zero());
        SurfaceLoad& load = report.loads[edge.surface];
        for (Point& point : edge.points) {
            if (point.limit == 0 || point.spread.count == 0) {
                if (step.remembers())
                    point.hold.setZero();
                continue;
            }
            const ContactBody& body = bodies[point.body];
            const Vec3 place = surface.pose.toWorld(point.place);
            const Vec3 velocity = surface.velocityAt(place);
            const Vec3 way = step.duration * (velocity - point.spread.at(body.state->velocity));
            const double k = step.isImplicit()
                                 ? std::max(implicitShare * point.stiffness, point.limit / (mostGive * body.spacing()))
                                 : stiffnessShare * point.stiffness;
            const EdgeForce edgeForce = forceOf(frame, edge.blade.isWire(), surface.pose.rotation * point.hold, way, k,
                                                point.limit, step.duration);
            const Vec3& force = edgeForce.force;
            point.spread.add(force, body.state->damping);
            if (step.remembers())
                point.hold = surface.pose.rotation.conjugate() * force;
            load.force -= force;
            load.torque -= (place - surface.pose.position).cross(force);
            load.power += force.dot(velocity);
            report.brakingPower -= force.dot(velocity);
            report.frictions.push_back({.object = {point.body, point.spread.objects[0]},
                                        .spread = &point.spread,
                                        .force = force,
                                        .velocity = velocity,
                                        .cuts = true});
            crowd.add(body, point.body, point.spread, k);
            if (step.isTrial)
                report.tangents.push_back({.first = {point.body, point.spread.main()},
                                           .second = std::nullopt,
                                           .surface = edge.surface,
                                           .spread = &point.spread,
                                           .force = force,
                                           .normal = Vec3::Zero(),
                                           .resistance = edgeForce.resistance});
        }
    }
}

} // namespace knead
