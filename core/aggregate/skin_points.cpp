#include "core/aggregate/skin_points.h"

#include "core/geometry/refine.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <tuple>

namespace knead {

namespace {

// Edges of triangles are halved down to this, which leaves points about half a spacing apart [spacings].
constexpr double longestEdge = 0.7;
// Of points of a finer surface, one is taken in each box so large [spacings].
constexpr double boxSize = 0.25;
constexpr std::size_t mostTriangles = 8'000'000;
// Sides of a thin sheet that lie in one box are told apart: normals of one side differ by less [cosine].
constexpr double sameSide = 0.3;

struct Vertex {
    std::array<std::int32_t, 3> box{};
    std::uint32_t index = 0;
    Vec3 normal = Vec3::Zero(); ///< times its area
    double area = 0;
};

std::vector<Vertex> verticesOf(const TriangleMesh& mesh, const Lattice& lattice, double orientation)
{
    std::vector<Vertex> vertices(mesh.vertices.size());
    for (const TriangleMesh::Triangle& triangle : mesh.triangles) {
        const Vec3 normal = 0.5 * orientation * crossOf(mesh.vertices, triangle);
        for (const std::uint32_t corner : triangle) {
            vertices[corner].normal += normal / 3;
            vertices[corner].area += normal.norm() / 3;
        }
    }
    for (std::uint32_t v = 0; v < vertices.size(); ++v) {
        const Vec3 local = lattice.coordinates(mesh.vertices[v]) / boxSize;
        vertices[v].index = v;
        for (std::size_t axis = 0; axis < 3; ++axis)
            vertices[v].box[axis] = static_cast<std::int32_t>(std::floor(local[static_cast<Eigen::Index>(axis)]));
    }
    std::erase_if(vertices, [](const Vertex& vertex) { return vertex.area == 0; });
    std::ranges::sort(
        vertices, [](const Vertex& a, const Vertex& b) { return std::tie(a.box, a.index) < std::tie(b.box, b.index); });
    return vertices;
}

/// Of the vertices of one side in a box, the one that reaches out farthest stands for all of them.
SkinPoint pointFor(const std::vector<Vertex>& side, const TriangleMesh& mesh)
{
    Vec3 outward = Vec3::Zero();
    double area = 0;
    for (const Vertex& vertex : side) {
        outward += vertex.normal;
        area += vertex.area;
    }
    const auto farthest = std::ranges::max_element(side, [&](const Vertex& a, const Vertex& b) {
        return mesh.vertices[a.index].dot(outward) < mesh.vertices[b.index].dot(outward);
    });
    return {mesh.vertices[farthest->index], area};
}

} // namespace

std::vector<SkinPoint> skinPoints(const TriangleMesh& mesh, const Lattice& lattice, double orientation)
{
    const TriangleMesh fine = refine(mesh, longestEdge * lattice.spacing, mostTriangles);
    const std::vector<Vertex> vertices = verticesOf(fine, lattice, orientation);
    std::vector<SkinPoint> points;
    for (auto begin = vertices.begin(); begin != vertices.end();) {
        const auto end =
            std::find_if(begin, vertices.end(), [&](const Vertex& vertex) { return vertex.box != begin->box; });
        std::vector<Vertex> rest(begin, end);
        while (!rest.empty()) {
            const Vec3 normal = rest.front().normal.stableNormalized();
            const auto other = std::stable_partition(rest.begin(), rest.end(), [&](const Vertex& vertex) {
                return vertex.index == rest.front().index || vertex.normal.stableNormalized().dot(normal) > sameSide;
            });
            std::vector<Vertex> next(other, rest.end());
            rest.erase(other, rest.end());
            points.push_back(pointFor(rest, fine));
            rest = std::move(next);
        }
        begin = end;
    }
    return points;
}

} // namespace knead
