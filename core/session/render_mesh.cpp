#include "core/session/render_mesh.h"

#include "core/geometry/disjoint_sets.h"
#include "core/session/edge_chains.h"

#include <algorithm>

namespace knead {

namespace {

constexpr double creaseCosine = 0.82; // about 35 degrees

/// A directed edge of a triangle; both directions sort together.
struct HalfEdge {
    std::uint64_t key; ///< the two vertices, lower first
    std::uint32_t triangle;
    std::uint8_t corner; ///< the edge runs from this corner to the next
};

std::vector<HalfEdge> sortedHalfEdges(const TriangleMesh& mesh)
{
    std::vector<HalfEdge> halfEdges;
    halfEdges.reserve(mesh.triangles.size() * 3);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::uint8_t i = 0; i < 3; ++i)
            halfEdges.push_back({pairKey(mesh.triangles[t][i], mesh.triangles[t][(i + 1) % 3]), t, i});
    std::ranges::sort(halfEdges, [](const HalfEdge& a, const HalfEdge& b) {
        return a.key != b.key ? a.key < b.key : a.triangle < b.triangle;
    });
    return halfEdges;
}

Vec3 unitNormal(const TriangleMesh& mesh, std::uint32_t t)
{
    return crossOf(mesh.vertices, mesh.triangles[t]).stableNormalized();
}

bool isSmooth(const TriangleMesh& mesh, std::uint32_t t, std::uint32_t u)
{
    if (!mesh.faceOfTriangle.empty())
        return mesh.faceOfTriangle[t] == mesh.faceOfTriangle[u];
    return unitNormal(mesh, t).dot(unitNormal(mesh, u)) > creaseCosine;
}

/// The corner of a triangle at a vertex, numbered through the mesh.
std::uint32_t cornerAt(const TriangleMesh& mesh, std::uint32_t t, std::uint32_t vertex)
{
    const auto& v = mesh.triangles[t];
    return 3 * t + static_cast<std::uint32_t>(std::ranges::find(v, vertex) - v.begin());
}

struct Seam {
    std::uint32_t triangle;
    std::uint8_t corner;
};

/// Joins corners across smooth edges and returns the others, which are the feature edges.
std::vector<Seam> joinSmoothCorners(const TriangleMesh& mesh, DisjointSets& sets)
{
    std::vector<Seam> seams;
    const std::vector<HalfEdge> halfEdges = sortedHalfEdges(mesh);
    for (std::size_t first = 0, last = 0; first < halfEdges.size(); first = last) {
        last = first + 1;
        while (last < halfEdges.size() && halfEdges[last].key == halfEdges[first].key)
            ++last;
        const HalfEdge& edge = halfEdges[first];
        const bool joined = last == first + 2 && isSmooth(mesh, edge.triangle, halfEdges[first + 1].triangle);
        if (!joined) {
            seams.push_back({edge.triangle, edge.corner});
            continue;
        }
        for (const auto vertex : {static_cast<std::uint32_t>(edge.key >> 32U), static_cast<std::uint32_t>(edge.key)})
            sets.join(cornerAt(mesh, edge.triangle, vertex), cornerAt(mesh, halfEdges[first + 1].triangle, vertex));
    }
    return seams;
}

} // namespace

RenderMesh renderMesh(const TriangleMesh& mesh)
{
    DisjointSets sets(mesh.triangles.size() * 3); // of corners that share a normal
    const std::vector<Seam> seams = joinSmoothCorners(mesh, sets);

    RenderMesh result;
    result.faceOfTriangle = mesh.faceOfTriangle;
    result.faceOfTriangle.resize(mesh.triangles.size(), 0);
    result.triangles.resize(mesh.triangles.size());
    constexpr std::uint32_t unset = 0xffffffffU;
    std::vector<std::uint32_t> vertexOfSet(mesh.triangles.size() * 3, unset);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::uint32_t i = 0; i < 3; ++i) {
            std::uint32_t& vertex = vertexOfSet[sets.find(3 * t + i)];
            if (vertex == unset) {
                vertex = static_cast<std::uint32_t>(result.source.size());
                result.source.push_back(mesh.triangles[t][i]);
                result.face.push_back(result.faceOfTriangle[t]);
            }
            result.triangles[t][i] = vertex;
        }
    for (const Seam& seam : seams) {
        const auto& triangle = result.triangles[seam.triangle];
        result.edges.push_back({triangle[seam.corner], triangle[(seam.corner + 1U) % 3]});
    }
    result.chainOfEdge = chainsOf(mesh, result);
    for (const std::uint32_t chain : result.chainOfEdge)
        result.chains = std::max(result.chains, chain + 1);
    return result;
}

std::vector<float> renderPoints(const RenderMesh& mesh, std::span<const Vec3> places)
{
    std::vector<float> points(mesh.source.size() * 3);
    for (std::size_t v = 0; v < mesh.source.size(); ++v)
        Eigen::Map<Eigen::Vector3f>(points.data() + 3 * v) = places[mesh.source[v]].cast<float>();
    return points;
}

std::vector<float> renderNormals(const RenderMesh& mesh, std::span<const float> points)
{
    std::vector<float> normals(points.size(), 0.0F);
    const auto at = [](auto& values, std::uint32_t v) { return Eigen::Map<Eigen::Vector3f>(values.data() + 3 * v); };
    const auto point = [&](std::uint32_t v) { return Eigen::Map<const Eigen::Vector3f>(points.data() + 3 * v); };
    for (const auto& t : mesh.triangles) {
        const Eigen::Vector3f twiceArea = (point(t[1]) - point(t[0])).cross(point(t[2]) - point(t[0]));
        for (const std::uint32_t v : t)
            at(normals, v) += twiceArea;
    }
    for (std::uint32_t v = 0; v < mesh.source.size(); ++v)
        at(normals, v).stableNormalize();
    return normals;
}

} // namespace knead
