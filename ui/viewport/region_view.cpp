#include "ui/viewport/region_view.h"

#include "core/session/region_contents.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace knead {

namespace {

constexpr double edgeReach = 7;          // [pixels]
constexpr double connectionReach = 5;    // [pixels]
constexpr double ballRadius = 0.5;       // [a], as drawn
constexpr std::size_t nearestEdges = 12; // that are looked at under the cursor

Eigen::Vector2d vec(const Pixel& pixel)
{
    return {pixel.x, pixel.y};
}

/// Where on a segment the pixel is nearest, 0..1, and how far that is.
std::pair<double, double> nearest(const Pixel& pixel, const Pixel& a, const Pixel& b)
{
    const Eigen::Vector2d along = vec(b) - vec(a);
    const double length = along.squaredNorm();
    const double s = length > 0 ? std::clamp((vec(pixel) - vec(a)).dot(along) / length, 0.0, 1.0) : 0.0;
    return {s, (vec(pixel) - vec(a) - s * along).norm()};
}

} // namespace

ScreenShape boxShape(const Pixel& a, const Pixel& b)
{
    return {a, {b.x, a.y}, b, {a.x, b.y}};
}

/// Half a circle around each end.
ScreenShape strokeShape(const Pixel& a, const Pixel& b, double radius)
{
    constexpr int corners = 12; // of each half
    const double way = std::atan2(b.y - a.y, b.x - a.x);
    ScreenShape shape;
    for (const auto& [center, start] :
         {std::pair(b, way - std::numbers::pi / 2), std::pair(a, way + std::numbers::pi / 2)})
        for (int i = 0; i <= corners; ++i) {
            const double angle = start + std::numbers::pi * i / corners;
            shape.push_back({center.x + radius * std::cos(angle), center.y + radius * std::sin(angle)});
        }
    return shape;
}

bool contains(const ScreenShape& shape, const Pixel& pixel)
{
    bool isInside = false;
    for (std::size_t i = 0, j = shape.size() - 1; i < shape.size(); j = i++) {
        const Pixel& a = shape[i];
        const Pixel& b = shape[j];
        if ((a.y > pixel.y) != (b.y > pixel.y) && pixel.x < (b.x - a.x) * (pixel.y - a.y) / (b.y - a.y) + a.x)
            isInside = !isInside;
    }
    return isInside;
}

Projector RegionView::projector() const
{
    return {m_camera, m_window};
}

bool RegionView::isShown(BodyId body) const
{
    return !m_hiddenParts.contains(m_document.content().bodies[body]->part);
}

double RegionView::tolerance() const
{
    return std::max(0.3 * m_document.content().spacing, 0.004 * m_document.size());
}

bool RegionView::isCutOff(const Vec3& place) const
{
    return m_cut && m_cut->distance(place) > 0;
}

/// Nothing lies before a place.
bool RegionView::isSeen(const Vec3& place, double tolerance)
{
    m_picker.follow();
    return isSeenNow(place, tolerance);
}

/// After m_picker.follow(). Any thread.
bool RegionView::isSeenNow(const Vec3& place, double tolerance) const
{
    const std::optional<Pixel> pixel = projector()(place);
    if (!pixel || isCutOff(place))
        return false;
    const Ray ray = m_camera.ray(*pixel, m_window);
    const PickHit hit = m_picker.pickNow(ray, true);
    return hit.kind == PickHit::Kind::Nothing ||
           (hit.place - ray.origin).dot(ray.direction) >= (place - ray.origin).dot(ray.direction) - tolerance;
}

const std::vector<ConnectionId>& RegionView::connectionsOf(BodyId body)
{
    const auto [found, isNew] = m_connections.try_emplace(body);
    if (isNew)
        found->second = surfaceConnections(*m_document.content().bodies[body]);
    return found->second;
}

// --- under a pixel --------------------------------------------------------------------------------------------------------

Region RegionView::at(Level level, const Pixel& pixel)
{
    if (m_document.content().bodies.empty())
        return {};
    switch (level) {
    case Level::Edge:
        return edgeAt(pixel);
    case Level::Object:
        return objectAt(pixel);
    case Level::Connection:
        return connectionAt(pixel);
    case Level::Part:
    case Level::Face:
        break;
    }
    const PickHit hit = m_picker.pick(m_camera.ray(pixel, m_window), true);
    Region region;
    region.level = level;
    const bool isFace = hit.kind == PickHit::Kind::Body && hasFaces(m_document.content(), hit.id);
    if (isFace || (level == Level::Part && (hit.kind == PickHit::Kind::Body || hit.kind == PickHit::Kind::Cut)))
        region.add(hit.id, level == Level::Part ? 0 : hit.face);
    return region;
}

Region RegionView::edgeAt(const Pixel& pixel)
{
    struct Candidate {
        double distance;
        BodyId body;
        std::uint32_t chain;
        Vec3 place;
    };
    std::vector<Candidate> candidates;
    const Projector project = projector();
    for (BodyId b = 0; b < m_document.content().bodies.size(); ++b) {
        if (!isShown(b))
            continue;
        const RenderMesh& mesh = m_document.content().bodies[b]->render;
        const BodyFrame& frame = *m_document.frame()->bodies[b];
        for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
            const Vec3 a = frame.point(mesh.edges[e][0]);
            const Vec3 z = frame.point(mesh.edges[e][1]);
            const std::optional<Pixel> first = project(a);
            const std::optional<Pixel> second = project(z);
            if (!first || !second)
                continue;
            const auto [s, distance] = nearest(pixel, *first, *second);
            if (distance <= edgeReach)
                candidates.push_back({distance, b, mesh.chainOfEdge[e], a + s * (z - a)});
        }
    }
    std::sort(candidates.begin(), candidates.end(),
              [](const Candidate& a, const Candidate& b) { return a.distance < b.distance; });
    for (std::size_t i = 0; i < std::min(candidates.size(), nearestEdges); ++i)
        if (isSeen(candidates[i].place, tolerance()))
            return regionOf(Level::Edge, candidates[i].body, {candidates[i].chain});
    return regionOf(Level::Edge, 0, {});
}

Region RegionView::objectAt(const Pixel& pixel) const
{
    const Ray ray = m_camera.ray(pixel, m_window);
    double best = std::numeric_limits<double>::max();
    Region region = regionOf(Level::Object, 0, {});
    for (BodyId b = 0; b < m_document.content().bodies.size(); ++b) {
        if (!isShown(b))
            continue;
        const FilledBody& body = *m_document.content().bodies[b];
        const double radius = ballRadius * body.aggregate->lattice.spacing;
        const std::vector<Vec3>& places = m_document.frame()->snapshot->bodies[b].positions;
        for (const ObjectIndex object : body.surfaceObjects) {
            const Vec3 offset = places[object] - ray.origin;
            const double along = offset.dot(ray.direction);
            const double across = offset.squaredNorm() - along * along;
            const double entry = along - std::sqrt(std::max(0.0, radius * radius - across));
            if (along > 0 && across <= radius * radius && entry < best && !isCutOff(places[object])) {
                best = entry;
                region = regionOf(Level::Object, b, {object});
            }
        }
    }
    return region;
}

/// The nearest to the eye of those near the cursor.
Region RegionView::connectionAt(const Pixel& pixel)
{
    const Projector project = projector();
    double best = std::numeric_limits<double>::max();
    Region region = regionOf(Level::Connection, 0, {});
    for (BodyId b = 0; b < m_document.content().bodies.size(); ++b) {
        if (!isShown(b))
            continue;
        const Aggregate& aggregate = *m_document.content().bodies[b]->aggregate;
        const std::vector<Vec3>& places = m_document.frame()->snapshot->bodies[b].positions;
        std::vector<std::optional<Pixel>> pixels;
        pixels.reserve(places.size());
        for (const Vec3& place : places)
            pixels.push_back(project(place));
        for (const ConnectionId& connection : connectionsOf(b)) {
            const auto [lower, upper] = endsOf(aggregate, connection);
            if (!pixels[lower] || !pixels[upper])
                continue;
            const auto [s, distance] = nearest(pixel, *pixels[lower], *pixels[upper]);
            const Vec3 place = places[lower] + s * (places[upper] - places[lower]);
            const double depth = -(place - m_camera.target).dot(m_camera.towardsEye());
            if (distance <= connectionReach && depth < best && !isCutOff(place)) {
                best = depth;
                region = regionOf(Level::Connection, b, {connectionItem(connection)});
            }
        }
    }
    return region;
}

} // namespace knead
