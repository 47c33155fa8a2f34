#include "io/slit_closing.h"

#include "core/geometry/half_edges.h"
#include "core/geometry/mass_properties.h"

#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace knead {

namespace {

constexpr double largestShare = 1e-4; // of the area of the mesh, for all slits together
constexpr std::size_t longestLoop = 200;

struct OpenEdge {
    std::uint32_t end;
    std::uint32_t face;
};

struct Loop {
    std::vector<std::uint32_t> vertices; // in the order of the missing triangles
    std::uint32_t face = 0;              // a neighbor's
};

/// Where the triangles end, run through against their direction. As many open edges start at a vertex as end there, so
/// every walk comes back to its start.
std::vector<Loop> findLoops(const TriangleMesh& mesh, const HalfEdges& halfEdges)
{
    std::unordered_multimap<std::uint32_t, OpenEdge> openEdges;
    std::vector<std::uint32_t> starts;
    for (std::size_t h = 0; h < halfEdges.twin.size(); ++h) {
        const TriangleMesh::Triangle& t = mesh.triangles[h / 3];
        const bool isCollapsed = t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
        if (halfEdges.twin[h] != HalfEdges::none || isCollapsed)
            continue;
        const std::uint32_t start = t[(h + 1) % 3];
        openEdges.insert({start, {t[h % 3], mesh.faceOfTriangle.empty() ? 0 : mesh.faceOfTriangle[h / 3]}});
        starts.push_back(start);
    }
    std::vector<Loop> loops;
    for (const std::uint32_t start : starts) {
        Loop loop;
        for (auto edge = openEdges.find(start); edge != openEdges.end(); edge = openEdges.find(loop.vertices.back())) {
            loop.face = edge->second.face;
            loop.vertices.push_back(edge->second.end);
            openEdges.erase(edge);
            if (loop.vertices.back() == start)
                break;
        }
        if (loop.vertices.size() >= 3)
            loops.push_back(std::move(loop));
    }
    return loops;
}

double areaOf(const TriangleMesh& mesh, const TriangleMesh::Triangle& t)
{
    const Vec3 a = mesh.vertices[t[1]] - mesh.vertices[t[0]];
    return 0.5 * a.cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]).norm();
}

/// Cuts off the smallest corner again and again.
std::vector<TriangleMesh::Triangle> triangulated(const TriangleMesh& mesh, std::vector<std::uint32_t> loop)
{
    std::vector<TriangleMesh::Triangle> triangles;
    while (loop.size() >= 3) {
        const std::size_t count = loop.size();
        const auto corner = [&](std::size_t i) {
            return TriangleMesh::Triangle{loop[(i + count - 1) % count], loop[i], loop[(i + 1) % count]};
        };
        std::size_t best = 0;
        double smallest = std::numeric_limits<double>::max();
        for (std::size_t i = 0; i < count; ++i)
            if (const double area = areaOf(mesh, corner(i)); area < smallest) {
                smallest = area;
                best = i;
            }
        triangles.push_back(corner(best));
        if (count == 3)
            break;
        loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(best));
    }
    return triangles;
}

} // namespace

TriangleMesh closeSlits(TriangleMesh mesh)
{
    const HalfEdges halfEdges = findHalfEdges(mesh);
    if (halfEdges.unpaired == 0)
        return mesh;
    TriangleMesh closed = mesh;
    double area = 0;
    for (const Loop& loop : findLoops(mesh, halfEdges)) {
        if (loop.vertices.size() > longestLoop)
            return mesh;
        for (const TriangleMesh::Triangle& triangle : triangulated(mesh, loop.vertices)) {
            area += areaOf(mesh, triangle);
            closed.triangles.push_back(triangle);
            if (!mesh.faceOfTriangle.empty())
                closed.faceOfTriangle.push_back(loop.face);
        }
    }
    return area <= largestShare * massProperties(mesh).area ? closed : mesh;
}

} // namespace knead
