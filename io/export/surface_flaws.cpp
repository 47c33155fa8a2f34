#include "io/export/surface_flaws.h"

#include "core/geometry/refine.h"
#include "core/geometry/self_intersection.h"
#include "io/export/place_words.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace knead {

namespace {

constexpr std::size_t mostCrossings = 50'000; // pairs of triangles that are looked at more closely
constexpr int mostHalvings = 8;

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

/// Whether only chords cross, and not the surface that they stand for: then finer triangles cross less and less.
bool isOfChords(const SmoothMap& map, const TriangleMesh& rest, const Crossings& found)
{
    TriangleMesh mesh = rest;
    Crossings crossings = found;
    for (int round = 0; round < mostHalvings && crossings.count <= crossings.some.size(); ++round) {
        mesh = halveEdges(trianglesOf(mesh, crossings));
        const std::size_t before = crossings.count;
        crossings = findCrossings(carried(map, mesh), TaskControl::none(), mostCrossings);
        if (crossings.count == 0 || crossings.count >= before)
            break;
    }
    return crossings.count == 0;
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
    const Crossings found = findCrossings(now, control, mostCrossings);
    if (found.count == 0 || found.count <= findCrossings(*rest[0], control).count || isOfChords(map, *rest[1], found))
        return;
    report.crossesItself = true;
    report.remarks.push_back("its surface passes through itself near " + placeWords(found.where.center()) +
                             "; other programs may refuse that.");
}

void noteFold(const TriangleMesh& rest, const TriangleMesh& now, PartExportReport& report)
{
    const std::optional<Vec3> fold = foldOf(rest, now);
    if (!fold)
        return;
    const std::string folded = "its material is folded over itself near " + placeWords(*fold);
    if (report.form == PartExportReport::Form::faceted)
        report.reason = folded + "; " + report.reason;
    else
        report.remarks.push_back(folded + ", and so are its faces.");
}

} // namespace knead
