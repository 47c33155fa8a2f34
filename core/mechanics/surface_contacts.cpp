#include "core/mechanics/surface_contacts.h"

#include "core/mechanics/blade.h"
#include "core/task/parallel.h"

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

constexpr std::size_t blockSize = 4096;

// Normals of one side of a surface differ by less [cosine].
constexpr double sameSide = 0.7;

// What is deeper than this did not get there by touching [spacings].
constexpr double mostTouching = 0.2;

// Once more than this part of the points that were special is so no longer, they are sorted anew.
constexpr std::size_t resortShare = 8;

// In a long step no more of what is kept is let out than this share, or this much, by the width of what the point stands for.
constexpr double mostAtOnce = 0.25;
constexpr double leastAtOnce = 0.03;

} // namespace

/// Of the contacts of some points, as they are now [J].
double SurfaceContacts::energyOf(std::span<const ContactBody> bodies, std::span<const RigidSurface> surfaces,
                                 const std::vector<std::uint8_t>& ofPoint) const
{
    double energy = 0;
    for (std::size_t s = 0; s < m_near.size(); ++s) {
        const auto surface = std::find_if(surfaces.begin(), surfaces.end(),
                                          [&](const RigidSurface& each) { return each.id == m_listed[s]; });
        if (surface == surfaces.end())
            continue;
        const PlacedSurface placed(*surface);
        for (const Near& near : m_near[s]) {
            if (ofPoint[near.point] == 0)
                continue;
            const Point& point = m_points[near.point];
            const Vec3 place = point.spread.at(bodies[point.body].state->position);
            const double overlap = point.reach - nearest(near, placed, place).distance - near.kept;
            energy += contactSpring(overlap, parametersOf(point, *surface), near.friction.sticks).energy;
        }
    }
    return energy;
}

/// Only skins stick.
ContactParameters SurfaceContacts::parametersOf(const Point& point, const RigidSurface& surface)
{
    ContactParameters parameters = point.parameters;
    parameters.friction = std::sqrt(parameters.friction * surface.friction);
    parameters.adhesion = point.isSkin ? surface.adhesion * point.area : 0;
    parameters.adhesionReach = point.adhesionReach;
    return parameters;
}

double SurfaceContacts::energy(std::span<const ContactBody> bodies, std::span<const RigidSurface> surfaces) const
{
    return energyOf(bodies, surfaces, std::vector<std::uint8_t>(m_points.size(), 1));
}

/// What lies ahead of the edge of a knife that cuts it touches nothing, and is as deep in its flank then as it is when the edge comes
/// by.
bool SurfaceContacts::waitsForEdge(Near& near, const Point& point, const PlacedSurface& surface, const Vec3& place)
{
    if (near.side == 0)
        return false;
    const auto flank = flankOf(surface->shape, near.side, surface.placeIn(place));
    if (!flank || !flank->isAhead)
        return false;
    near.kept = std::max(0.0, point.reach - flank->plane.distance);
    near.friction = {};
    return true;
}

void SurfaceContacts::beginStep(std::span<const ContactBody> bodies, std::span<const RigidSurface> surfaces,
                                double duration)
{
    forgetSorting();
    for (std::size_t s = 0; s < surfaces.size(); ++s) {
        RigidSurface moved = surfaces[s];
        moved.pose = surfaces[s].poseBefore(duration);
        const PlacedSurface before(moved);
        for (Near& near : m_near[s]) {
            const Point& point = m_points[near.point];
            const Vec3 place = point.spread.at(bodies[point.body].state->position);
            waitsForEdge(near, point, before, place);
            const SurfacePoint nearest = before.nearest(place);
            near.foot = before.placeIn(place - nearest.distance * nearest.normal);
            near.normal = before.toLocal(nearest.normal);
        }
    }
}

/// Of a surface; of what went past its edge within the step, of the plane that it came in through; of what a knife cut, of its flank.
SurfacePoint SurfaceContacts::nearest(const Near& near, const PlacedSurface& surface, const Vec3& place)
{
    if (near.side != 0)
        if (const auto flank = flankOf(surface->shape, near.side, surface.placeIn(place)))
            return {flank->plane.distance, surface.toWorld(flank->plane.normal)};
    const SurfacePoint nearest = surface.nearest(place);
    if (nearest.distance >= 0 || near.normal.isZero(0))
        return nearest;
    const Vec3 normal = surface.toWorld(near.normal);
    const double distance = (surface.placeIn(place) - near.foot).dot(near.normal);
    return normal.dot(nearest.normal) < sameSide && distance < 0 ? SurfacePoint{distance, normal} : nearest;
}

void SurfaceContacts::keepInside(std::span<const ContactBody> bodies, std::span<const RigidSurface> surfaces)
{
    forgetSorting();
    for (std::size_t s = 0; s < surfaces.size(); ++s) {
        const PlacedSurface surface(surfaces[s]);
        for (Near& near : m_near[s]) {
            const Point& point = m_points[near.point];
            const Vec3 place = point.spread.at(bodies[point.body].state->position);
            const double depth = std::max(0.0, point.reach - nearest(near, surface, place).distance);
            // What touches goes on, unless the tool was put further in than contacts ever let it.
            if (near.friction.isEmpty() || depth - near.kept > mostTouching * bodies[point.body].spacing()) {
                near.kept = depth;
                near.friction = {};
            }
        }
    }
}

/// Ends of broken connections keep how deep they are and wait for nothing, and neither does what is held in a tool.
bool SurfaceContacts::isWaiting() const
{
    return std::any_of(m_near.begin(), m_near.end(), [this](const std::vector<Near>& ofSurface) {
        return std::any_of(ofSurface.begin(), ofSurface.end(), [this](const Near& near) {
            return near.kept > 0 && !near.isHeld && !m_points[near.point].isLoose;
        });
    });
}

/// Less of what is kept, by the time that has passed, but what does not come out for that is not pressed ever harder: in the middle of
/// a tool it would be held, and shot out in the end. @param spacing of the body [m] @return energy that comes in with that [J]
double SurfaceContacts::letOut(Near& near, const Point& point, double overlap, double spacing,
                               const ContactStep& step) const
{
    const double stored = contactSpring(overlap - near.kept, point.parameters).energy;
    const double atOnce = std::max(leastAtOnce * std::sqrt(point.area), mostAtOnce * near.kept);
    const double wanted = std::min({near.kept, point.pushSpeed * step.duration, atOnce});
    const double pushed = std::clamp(mostTouching * spacing - (overlap - near.kept), 0.0, wanted);
    near.isHeld = pushed < wanted;
    near.kept = std::min(near.kept - pushed, std::max(0.0, overlap)); // what comes out by itself is not pushed
    const ContactSpring spring = contactSpring(overlap - near.kept, point.parameters);
    const double last = near.pressed;
    near.pressed = near.kept > 0 ? spring.force : 0;
    // In an explicit scheme both ends move at once: the mean force does the work.
    return step.isImplicit() ? spring.energy - stored : 0.5 * (last + spring.force) * pushed;
}

/// @param index of the surface
void SurfaceContacts::press(const ContactBody& body, Near& near, const PlacedSurface& surface, std::uint32_t index,
                            const ContactStep& step, ContactCrowd& crowd, ContactReport& report)
{
    SurfaceLoad& load = report.loads[index];
    const Point& point = m_points[near.point];
    ObjectState& state = *body.state;
    const Vec3 place = point.spread.at(state.position);
    if (!step.isTrial && waitsForEdge(near, point, surface, place))
        return;
    const SurfacePoint nearest = SurfaceContacts::nearest(near, surface, place);
    const double depth = point.reach - nearest.distance;
    if (near.kept > 0 && !step.isTrial)
        report.placed += letOut(near, point, depth, body.spacing(), step);
    if (step.isBalance)
        near.kept = near.pressed = 0;
    const double kept = step.isStatic ? 0 : near.kept;
    const bool isApart = !(depth > kept);
    if (isApart && !near.friction.sticks && !(step.clings && !near.friction.isEmpty())) {
        if (step.remembers())
            near.friction = parted(near.friction, point.parameters, step);
        return;
    }
    const Vec3 surfaceVelocity = surface->velocityAt(place);
    const ContactParameters parameters = parametersOf(point, *surface);
    const bool stuck = near.friction.sticks && parameters.adhesion > 0;
    const ContactResult result =
        contactForce({.overlap = depth - kept,
                      .normal = nearest.normal,
                      .relativeVelocity = point.spread.at(state.velocity) - surfaceVelocity,
                      .memory = {surface.toWorld(near.friction.hold), near.friction.pressure, near.friction.sticks}},
                     parameters, step);
    report.fracture += result.released;
    point.spread.add(result.spring, state.force);
    point.spread.add(result.damping, state.damping);
    if (step.remembers())
        near.friction = {surface.toLocal(result.memory.hold), result.memory.pressure, result.memory.sticks};
    if (isApart && stuck && !result.memory.sticks)
        return;
    const Vec3 force = result.force();
    load.force -= force;
    load.torque -= (place - surface->pose.position).cross(force);
    load.power += force.dot(surfaceVelocity);
    report.energy += result.energy;
    report.brakingPower -= result.damping.dot(surfaceVelocity);
    if (!result.friction.isZero(0))
        report.frictions.push_back({.object = {point.body, point.spread.objects[0]},
                                    .spread = &point.spread,
                                    .force = result.friction,
                                    .velocity = surfaceVelocity});
    ++report.count;
    report.clinging += isApart && !stuck ? 1 : 0;
    report.steepness = std::max(report.steepness, result.steepness);
    crowd.add(body, point.body, point.spread, result.slope);
    if (step.isTrial)
        report.tangents.push_back({.first = {point.body, point.spread.main()},
                                   .second = std::nullopt,
                                   .surface = index,
                                   .spread = &point.spread,
                                   .force = force,
                                   .normal = nearest.normal,
                                   .resistance = result.resistance,
                                   .drag = result.drag});
}

/// Whether the law of a point is that of ContactBatch.
bool SurfaceContacts::isPlain(const Near& near, const RigidSurface& surface) const
{
    const bool sticks = near.friction.sticks || (surface.adhesion > 0 && m_points[near.point].isSkin);
    return !sticks && near.kept == 0 && near.side == 0 && near.normal.isZero(0);
}

/// And what friction remembers is with the points again.
void SurfaceContacts::forgetSorting()
{
    for (Sorted& sorted : m_sorted) {
        sorted.batch.writeBack();
        sorted = {};
    }
}

void SurfaceContacts::sortOut(std::span<const ContactBody> bodies, std::uint32_t index, const RigidSurface& surface)
{
    Sorted& sorted = m_sorted[index];
    sorted.batch.writeBack();
    sorted = {.isCurrent = true, .friction = surface.friction, .adhesion = surface.adhesion, .batch = {}, .others = {}};
    std::vector<ContactBatch::Point> plain;
    for (std::uint32_t n = 0; n < m_near[index].size(); ++n) {
        Near& near = m_near[index][n];
        const Point& point = m_points[near.point];
        if (!point.isActive)
            continue;
        if (isPlain(near, surface))
            plain.push_back({.body = point.body,
                             .spread = &point.spread,
                             .reach = point.reach,
                             .parameters = parametersOf(point, surface),
                             .friction = &near.friction});
        else
            sorted.others.push_back(n);
    }
    sorted.batch = ContactBatch(bodies, plain);
}

void SurfaceContacts::computeForces(std::span<const ContactBody> bodies, std::span<const RigidSurface> surfaces,
                                    const ContactStep& step, ContactCrowd& crowd, ContactReport& report)
{
    const bool isExplicit = !step.isTrial && !step.isImplicit();
    if (!isExplicit)
        forgetSorting();
    for (std::uint32_t s = 0; s < surfaces.size(); ++s) {
        const PlacedSurface surface(surfaces[s]);
        const auto pressAlone = [&](Near& near) {
            if (m_points[near.point].isActive)
                press(bodies[m_points[near.point].body], near, surface, s, step, crowd, report);
        };
        if (!isExplicit) {
            std::for_each(m_near[s].begin(), m_near[s].end(), pressAlone);
            continue;
        }
        Sorted& sorted = m_sorted[s];
        if (!sorted.isCurrent || sorted.friction != surface->friction || sorted.adhesion != surface->adhesion)
            sortOut(bodies, s, surfaces[s]);
        sorted.batch.press(bodies, surface, step, crowd, report.loads[s], report);
        std::size_t plain = 0;
        for (const std::uint32_t n : sorted.others) {
            Near& near = m_near[s][n];
            pressAlone(near);
            plain += isPlain(near, surfaces[s]) ? 1 : 0;
        }
        if (plain * resortShare > sorted.others.size()) // they have come out
            sorted.isCurrent = false;
    }
}

void SurfaceContacts::addPressing(std::span<const ContactBody> bodies, std::span<const RigidSurface> surfaces,
                                  std::vector<std::vector<Vec3>>& forces) const
{
    double largestSpacing = 0;
    for (const ContactBody& body : bodies)
        largestSpacing = std::max(largestSpacing, body.spacing());
    std::vector<double> kept(m_points.size());
    for (const RigidSurface& surface : surfaces) {
        const Box box = surface.reach(largestSpacing);
        const PlacedSurface placed(surface);
        std::fill(kept.begin(), kept.end(), 0);
        const auto listed = std::find(m_listed.begin(), m_listed.end(), surface.id);
        if (listed != m_listed.end())
            for (const Near& near : m_near[static_cast<std::size_t>(listed - m_listed.begin())])
                kept[near.point] = near.kept;
        for (std::size_t p = 0; p < m_points.size(); ++p) {
            const Point& point = m_points[p];
            const ContactBody& body = bodies[point.body];
            if (!point.isActive || body.kind == BodyKind::glue)
                continue;
            const Vec3 place = point.spread.at(body.state->position);
            if (!box.contains(place))
                continue;
            const SurfacePoint nearest = placed.nearest(place);
            const double force = contactSpring(point.reach - nearest.distance - kept[p], point.parameters).force;
            for (std::uint32_t n = 0; force > 0 && n < point.spread.count; ++n)
                forces[point.body][point.spread.objects[n]] += point.spread.weights[n] * force * nearest.normal;
        }
    }
}

double SurfaceContacts::deepest(const ContactBody& body, std::uint32_t index, const RigidSurface& surface) const
{
    const double a = body.spacing();
    const Box box = surface.reach(a);
    const PlacedSurface placed(surface);
    std::vector<double> deepest((m_points.size() + blockSize - 1) / blockSize, -a);
    forEachBlock(m_points.size(), blockSize, [&](std::size_t begin, std::size_t end) {
        double& most = deepest[begin / blockSize];
        for (std::size_t p = begin; p < end; ++p) {
            const Point& point = m_points[p];
            if (point.body != index || !point.isActive || point.isLoose)
                continue;
            const Vec3 place = point.spread.at(body.state->position);
            if (box.contains(place))
                most = std::max(most, point.reach - placed.nearest(place).distance);
        }
    });
    return deepest.empty() ? -a : *std::max_element(deepest.begin(), deepest.end());
}

} // namespace knead
