#include "ui/measuring/skin_picker.h"

#include "core/geometry/shape_fit.h"
#include "ui/document/document.h"
#include "ui/viewport/pixel_of.h"
#include "ui/viewport/viewport_widget.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace knead {

namespace {

constexpr double cornerReach = 10;    // [pixels]
constexpr double leastKink = 0.6;     // between edges that meet in a corner [rad]
constexpr std::size_t mostTries = 4;  // corners that may be hidden behind the part
constexpr double hiddenBehind = 2e-3; // of the way to a corner: what is nearer hides it

/// Per vertex of the mesh, the vertices that feature edges lead to.
std::map<std::uint32_t, std::set<std::uint32_t>> featureNeighbors(const RenderMesh& mesh)
{
    std::map<std::uint32_t, std::set<std::uint32_t>> neighbors;
    for (const auto& [a, b] : mesh.edges) {
        neighbors[mesh.source[a]].insert(mesh.source[b]);
        neighbors[mesh.source[b]].insert(mesh.source[a]);
    }
    return neighbors;
}

bool isCorner(const std::vector<Vec3>& vertices, std::uint32_t vertex, const std::set<std::uint32_t>& neighbors)
{
    if (neighbors.size() != 2)
        return true;
    const Vec3& at = vertices[vertex];
    return angleBetween(at - vertices[*neighbors.begin()], vertices[*neighbors.rbegin()] - at) > leastKink;
}

} // namespace

void SkinPicker::forget()
{
    m_pickers.clear();
    m_bodies.clear();
    m_frame = nullptr;
}

std::vector<SkinPicker::Corner> SkinPicker::cornersOf(BodyId id, const FilledBody& body, const FilledModel& content)
{
    std::map<std::uint32_t, Corner> corners;
    const std::size_t isTrue = trueVertices(content, body);
    for (const auto& [vertex, neighbors] : featureNeighbors(body.render))
        if (vertex < isTrue && isCorner(body.mesh.vertices, vertex, neighbors))
            corners[vertex].vertex = vertex;
    for (std::uint32_t t = 0; t < body.mesh.triangles.size(); ++t)
        for (int k = 0; k < 3; ++k)
            if (const auto found = corners.find(body.mesh.triangles[t][static_cast<std::size_t>(k)]);
                found != corners.end())
                found->second.place = {id, t, Vec3::Unit(k)};
    std::vector<Corner> result;
    for (const auto& [vertex, corner] : corners)
        result.push_back(corner);
    return result;
}

void SkinPicker::follow()
{
    const FramePointer& frame = m_view.shownFrame();
    if (frame == m_frame)
        return;
    const bool isNew = m_pickers.empty();
    if (isNew) {
        m_bodies = frame->filled;
        m_pickers.resize(m_bodies.size());
    }
    for (BodyId b = 0; b < m_pickers.size(); ++b) {
        const FilledBody& body = *frame->filled[b];
        if (!isNew && haveSameSurface(*m_bodies[b], body)) {
            m_pickers[b].picker->refit(frame->bodies[b]->points);
            continue;
        }
        m_bodies[b] = frame->filled[b];
        m_pickers[b] = {std::make_unique<SurfacePicker>(body.render, frame->bodies[b]->points),
                        cornersOf(b, body, m_document.content())};
    }
    m_frame = frame;
}

bool SkinPicker::isHidden(std::size_t body) const
{
    return m_view.options().hiddenParts.contains(m_bodies[body]->part);
}

std::optional<SkinPicker::Hit> SkinPicker::pick(const Eye& eye, const QPointF& position, bool snaps)
{
    if (m_document.isEmpty() || m_document.content().bodies.empty())
        return std::nullopt;
    follow();
    if (snaps)
        if (const auto corner = cornerNear(eye, position))
            return corner;
    const auto hit = surfaceAlong(eye.camera.ray(pixelOf(position), eye.window));
    return hit && !hit->isCut ? hit : std::nullopt;
}

std::optional<SkinPicker::Hit> SkinPicker::surfaceAlong(const Ray& ray) const
{
    const RayReach reach = reachOf(ray, m_view.options().section.plane);
    std::optional<SurfaceHit> nearest;
    BodyId body = 0;
    for (BodyId b = 0; b < m_pickers.size(); ++b)
        if (!isHidden(b))
            if (const auto found = m_pickers[b].picker->pick(ray, reach);
                found && (!nearest || found->distance < nearest->distance)) {
                nearest = found;
                body = b;
            }
    if (!nearest)
        return std::nullopt;
    const auto& t = m_bodies[body]->mesh.triangles[nearest->triangle];
    const auto& places = m_frame->bodies[body]->places;
    const Vec3 at = ray.origin + nearest->distance * ray.direction;
    Hit hit{{body, nearest->triangle, nearestShares({places[t[0]], places[t[1]], places[t[2]]}, at)}};
    hit.at = placeOf(hit.place, *m_bodies[body], places);
    const bool isFromWithin = (places[t[1]] - places[t[0]]).cross(places[t[2]] - places[t[0]]).dot(ray.direction) > 0;
    if (isFromWithin && reach.from > 0) { // the plane has opened the body there
        hit.at = ray.origin + reach.from * ray.direction;
        hit.isCut = true;
    }
    return hit;
}

/// The nearest corner on the screen that nothing hides.
std::optional<SkinPicker::Hit> SkinPicker::cornerNear(const Eye& eye, const QPointF& position) const
{
    const std::optional<CutPlane>& cut = m_view.options().section.plane;
    std::map<double, Hit> candidates; // by distance [pixels]
    for (BodyId b = 0; b < m_pickers.size(); ++b) {
        if (isHidden(b))
            continue;
        for (const Corner& corner : m_pickers[b].corners) {
            const Vec3& at = m_frame->bodies[b]->places[corner.vertex];
            const std::optional<Pixel> seen = eye.camera.project(at, eye.window);
            if (!seen || (cut && cut->distance(at) > 0))
                continue;
            if (const double distance = std::hypot(seen->x - position.x(), seen->y - position.y());
                distance <= cornerReach)
                candidates.try_emplace(distance, Hit{corner.place, at, true});
        }
    }
    std::size_t tries = 0;
    for (const auto& [distance, hit] : candidates) {
        const Ray ray = eye.camera.ray(*eye.camera.project(hit.at, eye.window), eye.window);
        const auto first = surfaceAlong(ray);
        const double way = (hit.at - ray.origin).norm();
        if (!first || (first->at - ray.origin).norm() >= (1 - hiddenBehind) * way)
            return hit;
        if (++tries == mostTries)
            break;
    }
    return std::nullopt;
}

} // namespace knead
