#include "core/geometry/surface_distance.h"

#include "core/geometry/triangle_tree.h"
#include "core/task/parallel.h"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace knead {

namespace {

using Corners = std::array<Vec3, 3>;

constexpr std::uint32_t none = 0xffffffffU;

/// The part of a triangle on which a nearest point lies.
enum class Feature { Face, Corner, Edge };

struct Nearest {
    Vec3 point = Vec3::Zero();
    double squaredDistance = std::numeric_limits<double>::infinity();
    Feature feature = Feature::Face;
    std::uint32_t which = 0; // corner i, or edge i from corner i to corner i + 1
};

Nearest nearestOnEdge(const Corners& t, std::uint32_t i, const Vec3& p)
{
    const Vec3& a = t[i];
    const Vec3 ab = t[(i + 1) % 3] - a;
    const double along = (p - a).dot(ab);
    const double length = ab.squaredNorm();
    if (along <= 0)
        return {a, (p - a).squaredNorm(), Feature::Corner, i};
    if (along >= length)
        return {t[(i + 1) % 3], (p - t[(i + 1) % 3]).squaredNorm(), Feature::Corner, (i + 1) % 3};
    const Vec3 point = a + (along / length) * ab;
    return {point, (p - point).squaredNorm(), Feature::Edge, i};
}

/// When the foot of the perpendicular is inside the triangle it is the nearest point, else the best of the edges is.
/// Barycentric coordinates of the foot as in Ericson 2005, 5.1.5. Of a triangle thinner than a millionth of its length
/// they would be mostly rounding; its edges are as near.
Nearest nearestOnTriangle(const Corners& t, const Vec3& p)
{
    const Vec3 ab = t[1] - t[0];
    const Vec3 ac = t[2] - t[0];
    const Vec3 ap = p - t[0];
    const double abab = ab.squaredNorm();
    const double abac = ab.dot(ac);
    const double acac = ac.squaredNorm();
    const double abap = ab.dot(ap);
    const double acap = ac.dot(ap);
    const double atB = acac * abap - abac * acap;
    const double atC = abab * acap - abac * abap;
    const double squaredArea = abab * acac - abac * abac;
    const bool isSliver = squaredArea <= 1e-12 * abab * acac;
    if (!isSliver && atB > 0 && atC > 0 && atB + atC < squaredArea) {
        const Vec3 point = t[0] + (atB / squaredArea) * ab + (atC / squaredArea) * ac;
        return {point, (p - point).squaredNorm(), Feature::Face, 0};
    }
    const std::array<bool, 3> beyond{isSliver || atC <= 0, isSliver || atB + atC >= squaredArea, isSliver || atB <= 0};
    Nearest best;
    for (std::uint32_t i = 0; i < 3; ++i) {
        if (!beyond[i])
            continue;
        const Nearest candidate = nearestOnEdge(t, i, p);
        if (candidate.squaredDistance < best.squaredDistance)
            best = candidate;
    }
    return best;
}

Vec3 unitNormal(const TriangleMesh& mesh, std::size_t triangle)
{
    return crossOf(mesh.vertices, mesh.triangles[triangle]).stableNormalized();
}

} // namespace

/// What nearest() looks into.
struct SurfaceDistance::Search {
    const TriangleMesh& mesh;
    TriangleTree tree;
    std::vector<Corners> corners; // of the triangles in the tree's order
    HalfEdges halfEdges;

    Search(const TriangleMesh& surface, HalfEdges edges);

    std::optional<Hit> nearest(const Vec3& point, double reach, std::uint32_t guess) const;
    Vec3 pseudoNormal(std::uint32_t triangle, const Nearest& nearest) const;
    Vec3 angleWeightedNormal(std::uint32_t vertex) const;
};

SurfaceDistance::Search::Search(const TriangleMesh& surface, HalfEdges edges)
    : mesh(surface)
    , tree(surface)
    , corners(surface.triangles.size())
    , halfEdges(std::move(edges))
{
    forEachBlock(corners.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            corners[i] = cornersOf(mesh.vertices, mesh.triangles[tree.order()[i]]);
    });
}

/// Of triangles that are equally near, the first in the mesh counts, whatever the order in which they are looked at.
std::optional<SurfaceDistance::Hit> SurfaceDistance::Search::nearest(const Vec3& point, double reach,
                                                                     std::uint32_t guess) const
{
    Nearest best;
    best.squaredDistance = reach * reach;
    std::uint32_t triangle = none;
    const auto examine = [&](std::uint32_t which, const Corners& at) {
        const Nearest candidate = nearestOnTriangle(at, point);
        const bool tie = candidate.squaredDistance == best.squaredDistance && which < triangle;
        if (candidate.squaredDistance < best.squaredDistance || tie) {
            best = candidate;
            triangle = which;
        }
    };
    examine(guess, cornersOf(mesh.vertices, mesh.triangles[guess]));
    tree.forEachNear(point, best.squaredDistance, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            examine(tree.order()[i], corners[i]);
        return best.squaredDistance;
    });
    if (triangle == none)
        return std::nullopt;
    Hit hit{best.point, std::sqrt(best.squaredDistance), 0, triangle};
    const bool inside = pseudoNormal(triangle, best).dot(point - best.point) < 0;
    hit.signedDistance = inside ? -hit.distance : hit.distance;
    return hit;
}

/// A normal whose side tells inside from outside even at edges and corners (Baerentzen and Aanaes 2005).
Vec3 SurfaceDistance::Search::pseudoNormal(std::uint32_t triangle, const Nearest& nearest) const
{
    if (nearest.feature == Feature::Corner)
        return angleWeightedNormal(mesh.triangles[triangle][nearest.which]);
    if (nearest.feature == Feature::Face)
        return crossOf(mesh.vertices, mesh.triangles[triangle]);
    const Vec3 normal = unitNormal(mesh, triangle);
    const std::uint32_t other = halfEdges.twin[3 * triangle + nearest.which];
    return other == HalfEdges::none ? normal : Vec3(normal + unitNormal(mesh, other / 3));
}

/// The normals of the triangles around a vertex, weighted by their angles there.
Vec3 SurfaceDistance::Search::angleWeightedNormal(std::uint32_t vertex) const
{
    Vec3 sum = Vec3::Zero();
    for (const std::uint32_t halfEdge : halfEdges.leaving(vertex)) {
        const Corners t = cornersOf(mesh.vertices, mesh.triangles[halfEdge / 3]);
        const std::uint32_t i = halfEdge % 3;
        const Vec3 to = t[(i + 1) % 3] - t[i];
        const Vec3 from = t[(i + 2) % 3] - t[i];
        sum += std::atan2(to.cross(from).norm(), to.dot(from)) * unitNormal(mesh, halfEdge / 3);
    }
    return sum;
}

SurfaceDistance::SurfaceDistance(const TriangleMesh& mesh)
    : SurfaceDistance(mesh, findHalfEdges(mesh))
{
}

SurfaceDistance::SurfaceDistance(const TriangleMesh& mesh, HalfEdges halfEdges)
{
    if (mesh.empty())
        throw std::invalid_argument("SurfaceDistance: the mesh has no triangles");
    m_search = std::make_unique<const Search>(mesh, std::move(halfEdges));
}

SurfaceDistance::~SurfaceDistance() = default;
SurfaceDistance::SurfaceDistance(SurfaceDistance&&) noexcept = default;
SurfaceDistance& SurfaceDistance::operator=(SurfaceDistance&&) noexcept = default;

SurfaceDistance::Hit SurfaceDistance::nearest(const Vec3& point) const
{
    const std::optional<Hit> hit = m_search->nearest(point, std::numeric_limits<double>::infinity(), 0);
    return hit.value_or(Hit{});
}

std::optional<SurfaceDistance::Hit> SurfaceDistance::nearestWithin(double reach, const Vec3& point,
                                                                   std::uint32_t guess) const
{
    return m_search->nearest(point, reach, guess);
}

} // namespace knead
