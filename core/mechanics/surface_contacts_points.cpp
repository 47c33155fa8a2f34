// Which points of bodies may touch surfaces: those of skins, those near them, and the ends of broken connections.
#include "core/mechanics/blade.h"
#include "core/mechanics/surface_contacts.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>

namespace knead {

namespace {

// Objects this deep below the skin touch too, with their middles [spacings].
constexpr double shallowest = 0.3;
constexpr double deepestLayer = 1.5;
// Ends of broken connections touch so far from their middles [spacings].
constexpr double looseReach = 0.5;
// Of bodies that were filled without a skin, objects so deep touch [spacings].
constexpr double skinDepth = 1 - 1e-6;

// What friction remembers of a point is kept up to here from a surface, however near points are listed [spacings].
constexpr double rememberedReach = 2.5;

// Explicit steps hardly go further [spacings].
constexpr double stepReach = 0.1;

// So near to the plane of a knife [spacings].
constexpr double nearPlane = 0.5;

double sectionOf(const Aggregate& aggregate, ObjectIndex object)
{
    const double a = aggregate.lattice.spacing;
    return std::min(2 * aggregate.volume[object] / a, a * a);
}

/// A wire has no width that what it cuts could feel: its edge does it all.
bool isCutByWire(const Material& material, const RigidSurface& surface)
{
    if (surface.isFloor || surface.shape.kind != ToolKind::cylinder || !material.isCut())
        return false;
    const auto blade = bladeOf(surface.shape);
    return blade && blade->isWire();
}

} // namespace

SurfaceContacts::SurfaceContacts(std::span<const ContactBody> bodies)
{
    for (std::uint32_t b = 0; b < bodies.size(); ++b) {
        addPoints(bodies[b], b);
        double area = 0;
        for (const Point& point : m_points)
            if (point.body == b && (point.isSkin || bodies[b].connections->aggregate().skin.empty()))
                area += point.area;
        m_widths.push_back(area > 0 ? 4 * bodies[b].connections->aggregate().filledVolume / area : 0);
    }
}

void SurfaceContacts::addPoints(const ContactBody& body, std::uint32_t index)
{
    const Aggregate& aggregate = body.connections->aggregate();
    const double a = aggregate.lattice.spacing;
    const auto count = static_cast<std::uint32_t>(aggregate.skin.size());
    for (std::uint32_t p = 0; p < count; ++p)
        if (const auto spread = spreadOf(aggregate.lattice, aggregate.skin[p].place))
            addPoint({.body = index,
                      .number = p,
                      .spread = *spread,
                      .area = aggregate.skin[p].area,
                      .isSkin = true,
                      .parameters = {}});
    // What the same objects carry stays together.
    const auto first =
        std::find_if(m_points.begin(), m_points.end(), [&](const Point& point) { return point.body == index; });
    std::stable_sort(first, m_points.end(), [](const Point& one, const Point& other) {
        return std::tie(one.spread.count, one.spread.objects) < std::tie(other.spread.count, other.spread.objects);
    });
    const bool hasSkin = first != m_points.end(); // that belongs to its lattice
    for (ObjectIndex i = 0; i < aggregate.size(); ++i) {
        const double depth = aggregate.depth[i];
        const bool touches = hasSkin ? depth > shallowest * a && depth < deepestLayer * a : depth < skinDepth * a;
        if (touches)
            addPoint({.body = index,
                      .number = count + i,
                      .spread = spreadOf(i),
                      .area = sectionOf(aggregate, i),
                      .reach = hasSkin ? 0 : std::max(depth, -a),
                      .parameters = {}});
    }
}

double SurfaceContacts::connectionsBroke(std::span<const ContactBody> bodies, std::span<const RigidSurface> surfaces,
                                         std::uint32_t body, std::size_t firstBroken)
{
    const StructuralConnections& connections = *bodies[body].connections;
    const Aggregate& aggregate = connections.aggregate();
    const std::vector<BrokenConnection>& broken = connections.changes().broken;
    const auto firstLoose = static_cast<std::uint32_t>(aggregate.skin.size() + aggregate.size());
    std::vector<std::vector<ObjectIndex>> apart(aggregate.size()); // from the lower end
    std::vector<ObjectIndex> ends;
    for (std::size_t n = firstBroken; n < broken.size(); ++n) {
        const auto [lower, upper] = connections.endsOf(broken[n]);
        apart[lower].push_back(upper);
        ends.insert(ends.end(), {lower, upper});
    }
    const auto isTorn = [&](const PointSpread& spread) {
        const auto begin = spread.objects.begin();
        const auto end = begin + spread.count;
        return std::any_of(begin, end, [&](ObjectIndex object) {
            return std::any_of(apart[object].begin(), apart[object].end(),
                               [&](ObjectIndex other) { return std::find(begin, end, other) != end; });
        });
    };
    std::vector<std::uint8_t> isThere(aggregate.size(), 0);
    std::vector<std::uint8_t> torn(m_points.size(), 0);
    for (std::size_t p = 0; p < m_points.size(); ++p) {
        Point& point = m_points[p];
        if (point.body != body)
            continue;
        if (point.isLoose)
            isThere[point.number - firstLoose] = 1;
        else if (point.isActive && isTorn(point.spread)) {
            point.isActive = false;
            torn[p] = 1;
        }
    }
    const double released = energyOf(bodies, surfaces, torn);
    forgetSorting();
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    for (const ObjectIndex end : ends)
        if (isThere[end] == 0)
            addPoint({.body = body,
                      .number = firstLoose + end,
                      .spread = spreadOf(end),
                      .area = sectionOf(aggregate, end),
                      .reach = looseReach * aggregate.lattice.spacing,
                      .isLoose = true,
                      .isNew = true,
                      .parameters = {}});
    return released;
}

std::vector<SurfaceContacts::Touch> SurfaceContacts::memory() const
{
    for (const Sorted& sorted : m_sorted)
        sorted.batch.writeBack();
    std::vector<Touch> touches = m_remembered;
    for (std::size_t s = 0; s < m_near.size(); ++s)
        for (const Near& near : m_near[s])
            if (near.kept > 0 || near.side != 0 || !near.friction.isEmpty())
                touches.push_back({.surface = m_listed[s],
                                   .body = m_points[near.point].body,
                                   .point = m_points[near.point].number,
                                   .friction = near.friction,
                                   .kept = near.kept,
                                   .pressed = near.pressed,
                                   .side = near.side});
    return touches;
}

void SurfaceContacts::list(std::span<const ContactBody> bodies, std::span<const RigidSurface> surfaces, double margin)
{
    const auto keyOf = [](const Touch& touch) { return std::tie(touch.surface, touch.body, touch.point); };
    const auto isBefore = [&](const Touch& one, const Touch& other) { return keyOf(one) < keyOf(other); };
    std::vector<Touch> before = memory();
    std::stable_sort(before.begin(), before.end(), isBefore); // the last of equals is the latest
    m_remembered.clear();
    m_near.assign(surfaces.size(), {});
    m_sorted.clear();
    m_sorted.resize(surfaces.size());
    m_listed.clear();
    double largestReach = 0;
    for (const ContactBody& body : bodies)
        largestReach = std::max(largestReach, body.spacing());
    // A single step of the implicit scheme may go far, and one of the explicit one as far again as its speed at the end says.
    const auto reachOf = [&](const Point& point) {
        return m_isImplicit ? largestReach + margin
                            : point.reach + point.spread.weightSum() * margin + stepReach * largestReach;
    };
    for (std::size_t s = 0; s < surfaces.size(); ++s) {
        const bool isByDistance = m_isImplicit || ContactBatch::takesLittle(surfaces[s]);
        const Box box =
            surfaces[s].reach(std::max(largestReach + margin, isByDistance ? rememberedReach * largestReach : 0));
        const PlacedSurface placed(surfaces[s]);
        m_listed.push_back(surfaces[s].id);
        for (std::uint32_t p = 0; p < m_points.size(); ++p) {
            const Point& point = m_points[p];
            const ContactBody& body = bodies[point.body];
            if (!point.isActive || body.kind == BodyKind::glue)
                continue;
            const Vec3 place = point.spread.at(body.state->position);
            if (!box.contains(place) || isCutByWire(body.materialOf(point.spread.main()), surfaces[s]))
                continue;
            Near near{.point = p, .side = sideOf(point, body, surfaces[s])};
            const Touch key{.surface = surfaces[s].id, .body = point.body, .point = point.number, .friction = {}};
            const auto behind = std::upper_bound(before.begin(), before.end(), key, isBefore);
            const Touch* const known =
                behind != before.begin() && keyOf(*std::prev(behind)) == keyOf(key) ? &*std::prev(behind) : nullptr;
            if (known == nullptr && isByDistance && near.side == 0 && placed.nearest(place).distance > reachOf(point))
                continue;
            if (known != nullptr) {
                near.friction = known->friction;
                near.kept = known->kept;
                near.pressed = known->pressed;
            }
            // Seen from its other side a knife is somewhere else: what is pushed stays where it is.
            if (known != nullptr ? known->side != near.side : point.isNew)
                near.kept = std::max(0.0, point.reach - nearest(near, placed, place).distance);
            m_near[s].push_back(near);
        }
    }
    for (auto last = m_points.rbegin(); last != m_points.rend() && last->isNew; ++last)
        last->isNew = false;
}

/// On which side of a knife that cuts its material a point is. An end of a connection that lies in the plane of the cut is opposite to
/// what it was connected to.
std::int8_t SurfaceContacts::sideOf(const Point& point, const ContactBody& body, const RigidSurface& surface)
{
    if (surface.isFloor || surface.shape.kind != ToolKind::wedge || !body.materialOf(point.spread.main()).isCut() ||
        !bladeOf(surface.shape))
        return 0;
    const auto heightOf = [&](const Vec3& place) { return surface.pose.toLocal(place).y() / body.spacing(); };
    double across = heightOf(point.spread.at(body.state->position));
    if (point.isLoose && std::abs(across) < nearPlane) {
        const ObjectIndex object = point.spread.objects[0];
        double lost = 0;
        body.connections->forEachConnectionMade(object, [&](ObjectIndex neighbor, const ConnectionId& id) {
            if (body.connections->stiffness()[id.direction][id.lower] == 0)
                lost += heightOf(body.state->position.at(neighbor));
        });
        if (std::abs(lost) > nearPlane)
            across = -lost;
    }
    return across < 0 ? -1 : 1;
}

} // namespace knead
