#include "core/aggregate/skin_points.h"

#include "core/geometry/refine.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <tuple>

namespace knead {

namespace {

// Edges of triangles are halved down to this [spacings].
constexpr double longestEdge = 0.7;
// Of the vertices of one side in a box so large, one is taken: about four for a face of a cell, all cells alike. More is more than the eight
// objects of a cell tell apart; other sizes give some objects more of the surface than others, which makes them softer [spacings].
constexpr double boxSize = 0.5;
constexpr std::size_t mostTriangles = 8'000'000;
// Normals of one side differ by less, so that edges and what lies beside them are told apart, and the sides of a thin sheet [cosine].
constexpr double sameSide = 0.85;
// So does how far they reach out, so that the treads of small steps are told apart: more than surfaces bend in a box [spacings].
constexpr double sameReach = 0.25;
// Faces between two layers of boxes belong to the one inside, whatever rounding does [spacings].
constexpr double inwards = 1e-6;
// What reaches out less than the farthest by this is as far [spacings].
constexpr double asFar = 1e-3;

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
        const Vec3 within = mesh.vertices[v] - inwards * lattice.spacing * vertices[v].normal.stableNormalized();
        const Vec3 local = lattice.coordinates(within) / boxSize;
        vertices[v].index = v;
        for (std::size_t axis = 0; axis < 3; ++axis)
            vertices[v].box[axis] = static_cast<std::int32_t>(std::floor(local[static_cast<Eigen::Index>(axis)]));
    }
    std::erase_if(vertices, [](const Vertex& vertex) { return vertex.area == 0; });
    std::ranges::sort(
        vertices, [](const Vertex& a, const Vertex& b) { return std::tie(a.box, a.index) < std::tie(b.box, b.index); });
    return vertices;
}

/// Of the vertices of one side in a box, the one that reaches out farthest stands for all of them; where several do, as on a flat face,
/// the one in the middle of their area.
SkinPoint pointFor(const std::vector<Vertex>& side, const TriangleMesh& mesh, double spacing)
{
    Vec3 outward = Vec3::Zero();
    Vec3 moment = Vec3::Zero();
    double area = 0;
    for (const Vertex& vertex : side) {
        outward += vertex.normal;
        moment += vertex.area * mesh.vertices[vertex.index];
        area += vertex.area;
    }
    const Vec3 direction = outward.stableNormalized();
    const auto reach = [&](const Vertex& vertex) { return mesh.vertices[vertex.index].dot(direction); };
    const Vec3 middle = moment / area;
    const auto offMiddle = [&](const Vertex& vertex) { return (mesh.vertices[vertex.index] - middle).squaredNorm(); };
    const double farthest = reach(*std::ranges::max_element(side, {}, reach));
    const Vertex* chosen = nullptr;
    for (const Vertex& vertex : side)
        if (reach(vertex) >= farthest - asFar * spacing &&
            (chosen == nullptr || offMiddle(vertex) < offMiddle(*chosen)))
            chosen = &vertex;
    return {mesh.vertices[chosen->index], area};
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
            const Vertex pivot = rest.front();
            const Vec3 normal = pivot.normal.stableNormalized();
            const auto isSameSide = [&](const Vertex& vertex) {
                const double reach = (fine.vertices[vertex.index] - fine.vertices[pivot.index]).dot(normal);
                return std::abs(reach) < sameReach * lattice.spacing &&
                       vertex.normal.stableNormalized().dot(normal) > sameSide;
            };
            const auto other = std::stable_partition(rest.begin(), rest.end(), [&](const Vertex& vertex) {
                return vertex.index == pivot.index || isSameSide(vertex);
            });
            std::vector<Vertex> next(other, rest.end());
            rest.erase(other, rest.end());
            points.push_back(pointFor(rest, fine, lattice.spacing));
            rest = std::move(next);
        }
        begin = end;
    }
    return points;
}

} // namespace knead
