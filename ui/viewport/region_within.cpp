// What lies within a shape on the screen.
#include "core/session/region_contents.h"
#include "core/task/parallel.h"
#include "ui/viewport/region_view.h"

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

constexpr double objectTolerance = 1.2; // [a]: objects this deep under the skin are seen
constexpr std::size_t seenSamples = 16; // places at which a face or an edge is looked for
constexpr std::size_t seenBlock = 256;  // objects that are looked for at a time
constexpr double probesAcross = 24;     // rays along each side of a shape, at least 2 pixels apart

Eigen::AlignedBox2d boxOf(const ScreenShape& shape)
{
    Eigen::AlignedBox2d box;
    for (const Pixel& corner : shape)
        box.extend(Eigen::Vector2d(corner.x, corner.y));
    return box;
}

/// A few of many, evenly.
template <class Item>
std::vector<Item> someOf(const std::vector<Item>& all)
{
    std::vector<Item> some;
    const std::size_t count = std::min(all.size(), seenSamples);
    for (std::size_t i = 0; i < count; ++i)
        some.push_back(all[i * all.size() / count]);
    return some;
}

/// How many pieces of something there are, and how many lie within a shape.
struct Tally {
    std::uint32_t all = 0;
    std::uint32_t within = 0;
    bool isChosen(bool isWhole) const { return within > 0 && (!isWhole || within == all); }
};

} // namespace

Region RegionView::within(const ScreenShape& shape, const Query& query)
{
    Region region;
    region.level = query.level;
    for (BodyId b = 0; b < m_document.content().bodies.size(); ++b) {
        if (!isShown(b))
            continue;
        Region::Items items = query.level == Level::Part     ? partWithin(b, shape, query)
                              : query.level == Level::Face   ? facesWithin(b, shape, query)
                              : query.level == Level::Edge   ? edgesWithin(b, shape, query)
                              : query.level == Level::Object ? objectsWithin(b, shape, query)
                                                             : connectionsWithin(b, shape, query);
        region = united(region, regionOf(query.level, b, std::move(items)));
    }
    return query.level == Level::Face && !query.isWhole ? united(region, facesUnder(shape)) : region;
}

bool RegionView::isWithin(const Vec3& place, const ScreenShape& shape) const
{
    const std::optional<Pixel> pixel = projector()(place);
    return pixel && contains(shape, *pixel);
}

/// Per render vertex.
std::vector<bool> RegionView::verticesWithin(BodyId body, const ScreenShape& shape) const
{
    const BodyFrame& frame = *m_document.frame()->bodies[body];
    const Projector project = projector();
    const Eigen::AlignedBox2d box = boxOf(shape); // most vertices are far from a brush
    std::vector<bool> result(frame.points.size() / 3);
    for (std::uint32_t v = 0; v < result.size(); ++v)
        if (const std::optional<Pixel> pixel = project(frame.point(v)))
            result[v] = box.contains(Eigen::Vector2d(pixel->x, pixel->y)) && contains(shape, *pixel);
    return result;
}

Region::Items RegionView::partWithin(BodyId body, const ScreenShape& shape, const Query& query) const
{
    const std::vector<bool> within = verticesWithin(body, shape);
    const auto isIn = [](bool is) { return is; };
    const bool isChosen = query.isWhole ? std::all_of(within.begin(), within.end(), isIn)
                                        : std::any_of(within.begin(), within.end(), isIn);
    return isChosen ? Region::Items{0} : Region::Items{};
}

Region::Items RegionView::facesWithin(BodyId body, const ScreenShape& shape, const Query& query)
{
    if (!hasFaces(m_document.content(), body))
        return {};
    const RenderMesh& mesh = m_document.content().bodies[body]->render;
    const BodyFrame& frame = *m_document.frame()->bodies[body];
    const std::vector<bool> within = verticesWithin(body, shape);
    std::map<std::uint32_t, Tally> tallies;
    for (std::uint32_t v = 0; v < within.size(); ++v) {
        if (isCutOff(frame.point(v)))
            continue;
        Tally& tally = tallies[mesh.face[v]];
        ++tally.all;
        tally.within += within[v] ? 1 : 0;
    }
    std::map<std::uint32_t, std::vector<std::uint32_t>> chosen; // with the triangles at which they are looked for
    for (const auto& [face, tally] : tallies)
        if (tally.isChosen(query.isWhole))
            chosen[face];
    if (!query.isThrough)
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
            if (const auto found = chosen.find(mesh.faceOfTriangle[t]);
                found != chosen.end() && within[mesh.triangles[t][0]])
                found->second.push_back(t);
    Region::Items faces;
    for (const auto& [face, triangles] : chosen)
        if (query.isThrough || isFaceSeen(body, face, triangles))
            faces.push_back(face);
    return faces;
}

bool RegionView::isFaceSeen(BodyId body, std::uint32_t face, const std::vector<std::uint32_t>& triangles)
{
    const RenderMesh& mesh = m_document.content().bodies[body]->render;
    const BodyFrame& frame = *m_document.frame()->bodies[body];
    const std::vector<std::uint32_t> some = someOf(triangles);
    return std::any_of(some.begin(), some.end(), [&](std::uint32_t triangle) {
        const auto& t = mesh.triangles[triangle];
        const Vec3 center = (frame.point(t[0]) + frame.point(t[1]) + frame.point(t[2])) / 3;
        const std::optional<Pixel> pixel = projector()(center);
        if (!pixel)
            return false;
        const PickHit hit = m_picker.pick(m_camera.ray(*pixel, m_window), true);
        return hit.kind == PickHit::Kind::Body && hit.id == body && hit.face == face;
    });
}

/// What rays through the shape meet first: a small shape on a large face has none of its vertices in it.
Region RegionView::facesUnder(const ScreenShape& shape)
{
    const Eigen::AlignedBox2d box = boxOf(shape);
    Region region;
    region.level = Level::Face;
    if (box.isEmpty())
        return region;
    const Eigen::Vector2d step = (box.sizes() / probesAcross).cwiseMax(2.0);
    for (double x = box.min().x() + step.x() / 2; x < box.max().x(); x += step.x())
        for (double y = box.min().y() + step.y() / 2; y < box.max().y(); y += step.y())
            if (contains(shape, {x, y}))
                for (const auto& [body, items] : at(Level::Face, {x, y}).items)
                    region.add(body, items.front());
    return region;
}

Region RegionView::along(Level level, const Pixel& from, const Pixel& to, double step)
{
    const int steps = std::max(1, static_cast<int>(std::ceil(std::hypot(to.x - from.x, to.y - from.y) / step)));
    Region region;
    region.level = level;
    for (int i = 0; i <= steps; ++i) {
        const double share = static_cast<double>(i) / steps;
        region = united(region, at(level, {from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)}));
    }
    return region;
}

Region::Items RegionView::edgesWithin(BodyId body, const ScreenShape& shape, const Query& query)
{
    const RenderMesh& mesh = m_document.content().bodies[body]->render;
    const BodyFrame& frame = *m_document.frame()->bodies[body];
    const std::vector<bool> within = verticesWithin(body, shape);
    std::vector<Tally> tallies(mesh.chains);
    std::vector<std::vector<std::uint32_t>> places(mesh.chains);
    for (std::size_t e = 0; e < mesh.edges.size(); ++e)
        for (const std::uint32_t end : mesh.edges[e]) {
            const std::uint32_t chain = mesh.chainOfEdge[e];
            if (isCutOff(frame.point(end)))
                continue;
            ++tallies[chain].all;
            if (!within[end])
                continue;
            ++tallies[chain].within;
            places[chain].push_back(end);
        }
    Region::Items edges;
    for (std::uint32_t chain = 0; chain < mesh.chains; ++chain) {
        if (!tallies[chain].isChosen(query.isWhole))
            continue;
        const auto some = someOf(places[chain]);
        if (query.isThrough || std::any_of(some.begin(), some.end(), [&](std::uint32_t vertex) {
                return isSeen(frame.point(vertex), tolerance());
            }))
            edges.push_back(chain);
    }
    return edges;
}

Region::Items RegionView::objectsWithin(BodyId body, const ScreenShape& shape, const Query& query)
{
    const FilledBody& content = *m_document.content().bodies[body];
    const std::vector<Vec3>& places = m_document.frame()->snapshot->bodies[body].positions;
    const Projector project = projector();
    Region::Items objects;
    const auto addIfWithin = [&](ObjectIndex object) {
        const std::optional<Pixel> pixel = project(places[object]);
        if (pixel && contains(shape, *pixel) && !isCutOff(places[object]))
            objects.push_back(object);
    };
    if (query.isThrough) {
        for (ObjectIndex object = 0; object < places.size(); ++object)
            addIfWithin(object);
        return objects;
    }
    for (const ObjectIndex object : content.surfaceObjects)
        addIfWithin(object);
    m_picker.follow();
    std::vector<std::uint8_t> seen(objects.size());
    forEachBlock(objects.size(), seenBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            seen[i] = isSeenNow(places[objects[i]], objectTolerance * content.aggregate->lattice.spacing) ? 1 : 0;
    });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < objects.size(); ++i)
        if (seen[i] != 0)
            objects[kept++] = objects[i];
    objects.resize(kept);
    return objects;
}

/// By their middles, or by both ends. Those inside are no more than clutter when one looks at the skin.
Region::Items RegionView::connectionsWithin(BodyId body, const ScreenShape& shape, const Query& query)
{
    const Aggregate& aggregate = *m_document.content().bodies[body]->aggregate;
    const std::vector<Vec3>& places = m_document.frame()->snapshot->bodies[body].positions;
    std::vector<bool> within(places.size());
    for (ObjectIndex object = 0; object < places.size(); ++object)
        within[object] = !isCutOff(places[object]) && isWithin(places[object], shape);
    const auto addFrom = [&](const std::vector<ConnectionId>& all) {
        Region::Items connections;
        for (const ConnectionId& connection : all) {
            const auto [lower, upper] = endsOf(aggregate, connection);
            const Vec3 middle = (places[lower] + places[upper]) / 2;
            if (query.isWhole ? within[lower] && within[upper] : !isCutOff(middle) && isWithin(middle, shape))
                connections.push_back(connectionItem(connection));
        }
        return connections;
    };
    return addFrom(query.isThrough ? allConnections(aggregate) : connectionsOf(body));
}

} // namespace knead
