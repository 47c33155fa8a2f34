#include "io/export/surface_flaws.h"

#include "core/geometry/refine.h"
#include "core/geometry/self_intersection.h"
#include "core/message/message.h"
#include "io/export/place_words.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <unordered_map>
#include <vector>

namespace knead {

namespace {

constexpr std::size_t mostCrossings = 50'000; // pairs of triangles that are looked at more closely
constexpr int halvings = 4;                   // that tell what crosses from what seems to
constexpr double touchShare = 0.1;            // of the tolerance: what reaches no deeper touches, as it does at rest

/// A place at which the surface is folded: two triangles that lay nearly in a plane beside each other face opposite ways.
/// @param now where the map takes `rest`
std::optional<Vec3> foldOf(const TriangleMesh& rest, const TriangleMesh& now)
{
    constexpr double flat = 0.8;      // cosine between neighbors at rest
    constexpr double thinnest = 0.02; // of its longest edge: slivers face anywhere
    const auto normalOf = [](const TriangleMesh& mesh, std::size_t t) -> Vec3 {
        const auto& [a, b, c] = mesh.triangles[t];
        const Vec3 first = mesh.vertices[b] - mesh.vertices[a];
        const Vec3 second = mesh.vertices[c] - mesh.vertices[a];
        const Vec3 area = first.cross(second);
        const double longest = std::max({first.squaredNorm(), second.squaredNorm(), (second - first).squaredNorm()});
        return area.norm() > thinnest * longest ? Vec3(area.normalized()) : Vec3(Vec3::Zero());
    };
    std::unordered_map<std::uint64_t, std::size_t> triangleAt; // per edge: the first triangle of it
    for (std::size_t t = 0; t < rest.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(rest.triangles[t][k], rest.triangles[t][(k + 1) % 3]);
            const auto [place, isNew] = triangleAt.try_emplace(std::uint64_t{low} << 32U | high, t);
            if (!isNew && normalOf(rest, t).dot(normalOf(rest, place->second)) > flat &&
                normalOf(now, t).dot(normalOf(now, place->second)) < 0)
                return now.vertices[low];
        }
    return std::nullopt;
}

/// The triangles of some pairs alone.
TriangleMesh trianglesOf(const TriangleMesh& mesh, const Crossings& crossings)
{
    TriangleMesh some;
    std::vector<std::uint32_t> place(mesh.vertices.size(), std::numeric_limits<std::uint32_t>::max());
    std::vector<std::uint32_t> triangles;
    for (const auto& pair : crossings.some)
        triangles.insert(triangles.end(), pair.begin(), pair.end());
    std::sort(triangles.begin(), triangles.end());
    triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
    for (const std::uint32_t triangle : triangles) {
        TriangleMesh::Triangle corners = mesh.triangles[triangle];
        for (std::uint32_t& corner : corners) {
            if (place[corner] == std::numeric_limits<std::uint32_t>::max()) {
                place[corner] = static_cast<std::uint32_t>(some.vertices.size());
                some.vertices.push_back(mesh.vertices[corner]);
            }
            corner = place[corner];
        }
        some.triangles.push_back(corners);
    }
    return some;
}

/// Takes out the pairs that lie beside each other at rest and face one way: the chords of a curved edge between two faces, of which
/// each has triangles of its own, overlap by nothing. What is folded faces other ways, and what runs into itself came from elsewhere.
void keepRealOnes(const TriangleMesh& rest, const TriangleMesh& now, Crossings& crossings)
{
    constexpr double oneWay = 0.9; // cosine
    const auto corners = [](const TriangleMesh& mesh, std::uint32_t t) {
        const auto& [a, b, c] = mesh.triangles[t];
        return std::array<Vec3, 3>{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
    };
    const auto normal = [&](std::uint32_t t) {
        const auto [a, b, c] = corners(now, t);
        return Vec3((b - a).cross(c - a).normalized());
    };
    const auto box = [&](std::uint32_t t) {
        Box around;
        for (const Vec3& corner : corners(rest, t))
            around.extend(corner);
        return around;
    };
    const std::size_t before = crossings.some.size();
    std::erase_if(crossings.some, [&](const std::array<std::uint32_t, 2>& pair) {
        return normal(pair[0]).dot(normal(pair[1])) > oneWay && box(pair[0]).intersects(box(pair[1]));
    });
    crossings.count -= before - crossings.some.size();
    if (crossings.some.empty() || crossings.some.size() == before)
        return;
    crossings.where = Box();
    for (const auto& pair : crossings.some)
        for (const Vec3& corner : corners(now, pair[0]))
            crossings.where.extend(corner);
}

/// Crossings that hang together, each place by itself: coarse triangles at one say nothing of fine ones at another.
std::vector<Crossings> placesOf(const TriangleMesh& mesh, const Crossings& crossings)
{
    std::unordered_map<std::uint32_t, std::uint32_t> above; // of vertices, up to the one that stands for the place
    const auto top = [&](std::uint32_t vertex) {
        for (auto next = above.try_emplace(vertex, vertex).first->second; next != vertex; next = above.at(vertex))
            vertex = next;
        return vertex;
    };
    for (const auto& [a, b] : crossings.some) {
        const std::uint32_t place = top(mesh.triangles[a][0]);
        for (const std::uint32_t triangle : {a, b})
            for (const std::uint32_t vertex : mesh.triangles[triangle])
                above[top(vertex)] = place;
    }
    std::map<std::uint32_t, Crossings> places;
    for (const auto& pair : crossings.some) {
        Crossings& place = places[top(mesh.triangles[pair[0]][0])];
        ++place.count;
        place.some.push_back(pair);
        for (const std::uint32_t vertex : mesh.triangles[pair[0]])
            place.where.extend(mesh.vertices[vertex]);
    }
    std::vector<Crossings> result;
    for (auto& [vertex, place] : places)
        result.push_back(std::move(place));
    return result;
}

/// How far triangles reach through each other at most: what lies on the other side of the other one's plane, of the lesser part [m].
double depthOf(const TriangleMesh& mesh, const Crossings& crossings)
{
    const auto beyond = [&](const TriangleMesh::Triangle& plane, const TriangleMesh::Triangle& other) {
        const Vec3& origin = mesh.vertices[plane[0]];
        const Vec3 normal =
            (mesh.vertices[plane[1]] - origin).cross(mesh.vertices[plane[2]] - origin).stableNormalized();
        double above = 0;
        double below = 0;
        for (const std::uint32_t corner : other) {
            const double height = normal.dot(mesh.vertices[corner] - origin);
            above = std::max(above, height);
            below = std::max(below, -height);
        }
        return std::min(above, below);
    };
    double depth = 0;
    for (const auto& [a, b] : crossings.some)
        depth = std::max(depth, std::min(beyond(mesh.triangles[a], mesh.triangles[b]),
                                         beyond(mesh.triangles[b], mesh.triangles[a])));
    return depth;
}

/// Whether only chords cross at a place, and not the surface that they stand for: then triangles of half the size reach a quarter as far through
/// each other; those of surfaces that cross reach half as far.
bool isOfChords(const SmoothMap& map, const TriangleMesh& rest, const TriangleMesh& bent, const Crossings& found)
{
    TriangleMesh mesh = rest;
    TriangleMesh now = bent;
    Crossings crossings = found;
    const double first = depthOf(now, crossings);
    for (int round = 0; round < halvings && crossings.count <= crossings.some.size(); ++round) {
        mesh = halveEdges(trianglesOf(mesh, crossings));
        now = carried(map, mesh);
        crossings = findCrossings(now, TaskControl::none(), mostCrossings);
        keepRealOnes(mesh, now, crossings);
        if (crossings.count == 0)
            return true;
    }
    // Between a half and a quarter, to the power of the halvings.
    return crossings.count <= crossings.some.size() && depthOf(now, crossings) < std::pow(0.35, halvings) * first;
}

void sayCrossing(const Vec3& place, PartExportReport& report)
{
    report.crossesItself = true;
    report.fold = place;
    report.remarks.push_back(
        Message("Export", "its surface passes through itself near %1; other programs may refuse that.")
            .with(placeWords(place)));
}

} // namespace

TriangleMesh carried(const SmoothMap& map, TriangleMesh mesh)
{
    map.evaluate(std::vector<Vec3>(mesh.vertices), mesh.vertices);
    return mesh;
}

void noteCrossings(const SmoothMap& map, const std::array<const TriangleMesh*, 2>& rest, const TriangleMesh& now,
                   TaskControl& control, PartExportReport& report)
{
    Crossings found = findCrossings(now, control, mostCrossings);
    keepRealOnes(*rest[1], now, found);
    if (found.count == 0)
        return;
    Crossings atRest = findCrossings(*rest[0], control, mostCrossings);
    keepRealOnes(*rest[0], *rest[0], atRest);
    if (found.count <= atRest.count)
        return;
    if (found.count <= found.some.size()) { // else there are more than can be looked at
        const std::vector<Crossings> places = placesOf(now, found);
        const auto real = std::find_if(places.begin(), places.end(), [&](const Crossings& place) {
            return depthOf(now, place) > touchShare * report.tolerance && !isOfChords(map, *rest[1], now, place);
        });
        if (real == places.end())
            return;
        found.where = real->where;
    }
    sayCrossing(found.where.center(), report);
}

void noteCrossings(const TriangleMesh& now, TaskControl& control, PartExportReport& report)
{
    const Crossings found = findCrossings(now, control, mostCrossings);
    for (const Crossings& place : placesOf(now, found))
        if (depthOf(now, place) > report.tolerance)
            return sayCrossing(place.where.center(), report);
}

void noteFold(const TriangleMesh& rest, const TriangleMesh& now, PartExportReport& report)
{
    const std::optional<Vec3> fold = foldOf(rest, now);
    if (!fold)
        return;
    report.fold = *fold;
    const Message folded = Message("Export", "its material is folded over itself near %1").with(placeWords(*fold));
    if (report.form == PartExportReport::Form::faceted)
        report.reason = Message::verbatim("%1; %2").with(folded, report.reason);
    else
        report.remarks.push_back(Message("Export", "%1, and so are its faces.").with(folded));
}

} // namespace knead
