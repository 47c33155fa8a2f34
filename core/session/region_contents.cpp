#include "core/session/region_contents.h"

#include "core/aggregate/pieces.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>

namespace knead {

namespace {

constexpr double edgeReach = 0.87; // [a]: half the diagonal of a cell, so that no edge passes between objects

double areaOf(const FilledBody& body, const BodyFrame& frame, const Region::Items& faces)
{
    const RenderMesh& mesh = body.render;
    double sum = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (!std::ranges::binary_search(faces, mesh.faceOfTriangle[t]))
            continue;
        const Vec3 a = frame.point(mesh.triangles[t][0]);
        sum += (frame.point(mesh.triangles[t][1]) - a).cross(frame.point(mesh.triangles[t][2]) - a).norm() / 2;
    }
    return sum;
}

double volumeOf(const FilledBody& body, const BodyFrame& frame)
{
    const Vec3 origin = frame.places.front(); // near, for the sake of rounding
    double sum = 0;
    for (const auto& t : body.mesh.triangles)
        sum += (frame.places[t[0]] - origin).dot((frame.places[t[1]] - origin).cross(frame.places[t[2]] - origin)) / 6;
    return sum;
}

double lengthOfEdges(const FilledBody& body, const BodyFrame& frame, const Region::Items& chains)
{
    double sum = 0;
    for (std::size_t e = 0; e < body.render.edges.size(); ++e)
        if (std::ranges::binary_search(chains, body.render.chainOfEdge[e]))
            sum += (frame.point(body.render.edges[e][1]) - frame.point(body.render.edges[e][0])).norm();
    return sum;
}

std::vector<ObjectIndex> allOf(const Aggregate& aggregate)
{
    std::vector<ObjectIndex> all(aggregate.size());
    std::iota(all.begin(), all.end(), ObjectIndex{0});
    return all;
}

double distanceToSegment(const Vec3& place, const Vec3& a, const Vec3& b)
{
    const Vec3 along = b - a;
    const double length = along.squaredNorm();
    const double s = length > 0 ? std::clamp((place - a).dot(along) / length, 0.0, 1.0) : 0.0;
    return (place - a - s * along).norm();
}

/// Only nodes around the short pieces of edges are looked at.
std::vector<ObjectIndex> objectsAtEdges(const FilledBody& body, const Region::Items& chains)
{
    const Lattice& lattice = body.aggregate->lattice;
    std::vector<ObjectIndex> objects;
    for (std::size_t e = 0; e < body.render.edges.size(); ++e) {
        if (!std::ranges::binary_search(chains, body.render.chainOfEdge[e]))
            continue;
        const Vec3& a = body.mesh.vertices[body.render.source[body.render.edges[e][0]]];
        const Vec3& b = body.mesh.vertices[body.render.source[body.render.edges[e][1]]];
        const Vec3 first = lattice.coordinates(a);
        const Vec3 second = lattice.coordinates(b);
        const Eigen::Vector3i low = (first.cwiseMin(second).array() - 1).floor().cast<int>();
        const Eigen::Vector3i high = (first.cwiseMax(second).array() + 1).ceil().cast<int>();
        for (int u = low.x(); u <= high.x(); ++u)
            for (int v = low.y(); v <= high.y(); ++v)
                for (int w = low.z(); w <= high.z(); ++w) {
                    const ObjectIndex object = lattice.find({u, v, w});
                    if (object < lattice.size() &&
                        distanceToSegment(lattice.position(object), a, b) <= edgeReach * lattice.spacing)
                        objects.push_back(object);
                }
    }
    return objects;
}

std::vector<ObjectIndex> objectsOf(const FilledBody& body, const Model& model, Level level, const Region::Items& items)
{
    std::vector<ObjectIndex> objects;
    switch (level) {
    case Level::Part:
        return allOf(*body.aggregate);
    case Level::Face:
        return objectsAtFaces(*body.aggregate, model.parts[body.part].mesh, {items.begin(), items.end()});
    case Level::Edge:
        objects = objectsAtEdges(body, items);
        break;
    case Level::Object:
        objects.assign(items.begin(), items.end());
        break;
    case Level::Connection:
        for (const Region::Item item : items)
            for (const ObjectIndex end : endsOf(*body.aggregate, connectionOf(item)))
                objects.push_back(end);
        break;
    }
    std::ranges::sort(objects);
    objects.erase(std::unique(objects.begin(), objects.end()), objects.end());
    return objects;
}

/// Places in cells as wide as the distance that is asked for.
class Cells {
public:
    explicit Cells(double width)
        : m_width(width)
    {
    }
    void add(const Vec3& place) { m_places[keyOf(cellOf(place))].push_back(place); }
    bool hasWithin(const Vec3& place, double distance) const
    {
        const Eigen::Vector3i cell = cellOf(place);
        for (int x = -1; x <= 1; ++x)
            for (int y = -1; y <= 1; ++y)
                for (int z = -1; z <= 1; ++z) {
                    const auto found = m_places.find(keyOf(cell + Eigen::Vector3i(x, y, z)));
                    if (found == m_places.end())
                        continue;
                    for (const Vec3& other : found->second)
                        if ((other - place).squaredNorm() <= distance * distance)
                            return true;
                }
        return false;
    }

private:
    Eigen::Vector3i cellOf(const Vec3& place) const { return (place / m_width).array().floor().cast<int>(); }
    static std::uint64_t keyOf(const Eigen::Vector3i& cell)
    {
        const auto part = [](int n) { return static_cast<std::uint64_t>(n + (1 << 20)) & 0x1fffffU; };
        return part(cell.x()) | part(cell.y()) << 21U | part(cell.z()) << 42U;
    }
    double m_width;
    std::unordered_map<std::uint64_t, std::vector<Vec3>> m_places;
};

} // namespace

RegionSize sizeOf(const Region& region, const FilledModel& content, const Frame& now)
{
    RegionSize size{.count = region.count()};
    for (const auto& [id, items] : region.items) {
        const FilledBody& body = *content.bodies[id];
        const BodyFrame& frame = *now.bodies[id];
        switch (region.level) {
        case Level::Part:
            size.volume += volumeOf(body, frame);
            break;
        case Level::Face:
            size.area += areaOf(body, frame, items);
            if (size.count == 1)
                size.name = nameOfFace(content, id, static_cast<std::uint32_t>(items.front()));
            break;
        case Level::Edge:
            size.length += lengthOfEdges(body, frame, items);
            break;
        case Level::Object:
            for (const Region::Item object : items)
                size.volume += body.aggregate->volume[object];
            break;
        case Level::Connection:
            for (const Region::Item item : items) {
                const auto [a, b] = endsOf(*body.aggregate, connectionOf(item));
                const std::vector<Vec3>& places = now.snapshot->bodies[id].positions;
                size.length += (places[b] - places[a]).norm();
            }
            break;
        }
    }
    return size;
}

std::map<BodyId, std::vector<ObjectIndex>> objectsOf(const Region& region, const FilledModel& content)
{
    std::map<BodyId, std::vector<ObjectIndex>> result;
    for (const auto& [id, items] : region.items)
        if (auto objects = objectsOf(*content.bodies[id], *content.model, region.level, items); !objects.empty())
            result[id] = std::move(objects);
    return result;
}

Region objectsWithin(const Region& region, double distance, const FilledModel& content, const Frame& now)
{
    Cells cells(std::max(distance, content.spacing / 2));
    for (const auto& [id, objects] : objectsOf(region, content))
        for (const ObjectIndex object : objects)
            cells.add(now.snapshot->bodies[id].positions[object]);
    constexpr double rounding = 1e-9; // [a]: neighbors at just this distance belong to it
    const double reach = distance + rounding * content.spacing;
    Region result;
    result.level = Level::Object;
    for (BodyId id = 0; id < content.bodies.size(); ++id) {
        Region::Items found;
        const std::vector<Vec3>& places = now.snapshot->bodies[id].positions;
        for (ObjectIndex object = 0; object < places.size(); ++object)
            if (cells.hasWithin(places[object], reach))
                found.push_back(object);
        if (!found.empty())
            result.items[id] = std::move(found);
    }
    return result;
}

std::array<ObjectIndex, 2> endsOf(const Aggregate& aggregate, const ConnectionId& connection)
{
    return {connection.lower, upperEnd(aggregate.lattice, connection)};
}

bool isConnection(const Aggregate& aggregate, Region::Item item)
{
    const auto [direction, lower] = connectionOf(item);
    return direction < aggregate.weight.size() && lower < aggregate.weight[direction].size() &&
           aggregate.weight[direction][lower] > 0;
}

std::vector<ConnectionId> allConnections(const Aggregate& aggregate)
{
    std::vector<ConnectionId> connections;
    aggregate.forEachConnection([&](std::uint32_t d, ObjectIndex lower, ObjectIndex) {
        connections.push_back({d, lower});
    });
    return connections;
}

std::vector<ConnectionId> surfaceConnections(const FilledBody& body)
{
    std::vector<bool> isSeen(body.aggregate->size(), false);
    for (const ObjectIndex object : body.surfaceObjects)
        isSeen[object] = true;
    std::vector<ConnectionId> connections = allConnections(*body.aggregate);
    std::erase_if(connections, [&](const ConnectionId& connection) {
        const auto [lower, upper] = endsOf(*body.aggregate, connection);
        return !isSeen[lower] || !isSeen[upper];
    });
    return connections;
}

bool hasFaces(const FilledModel& content, BodyId body)
{
    return !content.model->parts[content.bodies[body]->part].faces.empty();
}

} // namespace knead
