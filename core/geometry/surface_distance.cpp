#include "core/geometry/surface_distance.h"

#include "core/geometry/half_edges.h"
#include "core/task/parallel.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace knead {

namespace {

using Corners = std::array<Vec3, 3>;

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

Corners cornersOf(const TriangleMesh& mesh, std::size_t triangle)
{
    const TriangleMesh::Triangle& t = mesh.triangles[triangle];
    return {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
}

Vec3 unitNormal(const TriangleMesh& mesh, std::size_t triangle)
{
    const Corners t = cornersOf(mesh, triangle);
    return (t[1] - t[0]).cross(t[2] - t[0]).stableNormalized();
}

double squaredDistance(const Box& box, const Vec3& p)
{
    return (box.min() - p).cwiseMax(p - box.max()).cwiseMax(0).squaredNorm();
}

/// Normals of the triangles around each vertex, weighted by their angles there.
std::vector<Vec3> angleWeightedNormals(const TriangleMesh& mesh)
{
    std::vector<Vec3> normals(mesh.vertices.size(), Vec3::Zero());
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        const Corners t = cornersOf(mesh, triangle);
        const Vec3 normal = unitNormal(mesh, triangle);
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3 to = t[(i + 1) % 3] - t[i];
            const Vec3 from = t[(i + 2) % 3] - t[i];
            normals[mesh.triangles[triangle][i]] += std::atan2(to.cross(from).norm(), to.dot(from)) * normal;
        }
    }
    return normals;
}

} // namespace

/// A perfectly balanced tree in heap order: node n has children 2 n + 1 and 2 n + 2, and node j of level l holds the
/// triangles j count / 2^l .. (j + 1) count / 2^l of the order, so that neither children nor ranges are stored.
struct SurfaceDistance::Tree {
    const TriangleMesh& mesh;
    unsigned depth = 0; // levels above the leaves
    std::vector<Box> boxes;
    std::vector<std::uint32_t> order; // triangles, leaf by leaf
    std::vector<Corners> corners;     // in that order
    std::vector<std::uint32_t> twin;  // half-edges
    std::vector<Vec3> vertexNormals;

    static constexpr std::size_t trianglesPerLeaf = 4; // at most

    explicit Tree(const TriangleMesh& surface);

    std::size_t levelBegin(unsigned level) const { return (std::size_t{1} << level) - 1; }
    std::size_t firstTriangle(unsigned level, std::size_t node) const { return node * order.size() >> level; }

    void sortTriangles();
    void splitNode(unsigned level, std::size_t node, const std::vector<Vec3>& centers);
    void findBoxes();
    Hit nearest(const Vec3& point) const;
    void examineLeaf(std::size_t leaf, const Vec3& point, Nearest& best, std::uint32_t& triangle) const;
    Vec3 pseudoNormal(std::uint32_t triangle, const Nearest& nearest) const;
};

SurfaceDistance::Tree::Tree(const TriangleMesh& surface)
    : mesh(surface)
    , order(surface.triangles.size())
    , corners(surface.triangles.size())
    , twin(findHalfEdges(surface).twin)
    , vertexNormals(angleWeightedNormals(surface))
{
    const std::size_t leaves = (order.size() + trianglesPerLeaf - 1) / trianglesPerLeaf;
    depth = static_cast<unsigned>(std::bit_width(std::bit_ceil(leaves)) - 1);
    boxes.resize(levelBegin(depth + 1));
    std::iota(order.begin(), order.end(), 0U);
    sortTriangles();
    for (std::size_t i = 0; i < order.size(); ++i)
        corners[i] = cornersOf(mesh, order[i]);
    findBoxes();
}

void SurfaceDistance::Tree::sortTriangles()
{
    std::vector<Vec3> centers(mesh.triangles.size());
    for (std::size_t t = 0; t < centers.size(); ++t) {
        const Corners c = cornersOf(mesh, t);
        centers[t] = (c[0] + c[1] + c[2]) / 3;
    }
    for (unsigned level = 0; level < depth; ++level)
        forEachBlock(std::size_t{1} << level, 1 + (std::size_t{1} << level) / 64,
                     [&](std::size_t begin, std::size_t end) {
                         for (std::size_t node = begin; node < end; ++node)
                             splitNode(level, node, centers);
                     });
}

/// Puts the lower half of a node's triangles first, along the side in which their centers spread most.
void SurfaceDistance::Tree::splitNode(unsigned level, std::size_t node, const std::vector<Vec3>& centers)
{
    const auto begin = order.begin() + static_cast<std::ptrdiff_t>(firstTriangle(level, node));
    const auto end = order.begin() + static_cast<std::ptrdiff_t>(firstTriangle(level, node + 1));
    const auto middle = order.begin() + static_cast<std::ptrdiff_t>(firstTriangle(level + 1, 2 * node + 1));
    Box spread;
    std::for_each(begin, end, [&](std::uint32_t t) { spread.extend(centers[t]); });
    Eigen::Index side = 0;
    spread.sizes().maxCoeff(&side);
    std::nth_element(begin, middle, end, [&](std::uint32_t s, std::uint32_t t) {
        return centers[s][side] != centers[t][side] ? centers[s][side] < centers[t][side] : s < t;
    });
}

void SurfaceDistance::Tree::findBoxes()
{
    for (std::size_t leaf = 0; leaf < std::size_t{1} << depth; ++leaf)
        for (std::size_t i = firstTriangle(depth, leaf); i < firstTriangle(depth, leaf + 1); ++i)
            for (const Vec3& corner : corners[i])
                boxes[levelBegin(depth) + leaf].extend(corner);
    for (std::size_t node = levelBegin(depth); node-- > 0;)
        boxes[node] = boxes[2 * node + 1].merged(boxes[2 * node + 2]);
}

void SurfaceDistance::Tree::examineLeaf(std::size_t leaf, const Vec3& point, Nearest& best,
                                        std::uint32_t& triangle) const
{
    for (std::size_t i = firstTriangle(depth, leaf); i < firstTriangle(depth, leaf + 1); ++i) {
        const Nearest candidate = nearestOnTriangle(corners[i], point);
        const bool tie = candidate.squaredDistance == best.squaredDistance && order[i] < triangle;
        if (candidate.squaredDistance < best.squaredDistance || tie) {
            best = candidate;
            triangle = order[i];
        }
    }
}

SurfaceDistance::Hit SurfaceDistance::Tree::nearest(const Vec3& point) const
{
    struct Pending {
        std::size_t node;
        double distance; // squared, as all here
    };
    std::array<Pending, 64> stack; // one per level
    std::size_t pending = 0;
    stack[pending++] = {0, squaredDistance(boxes[0], point)};
    Nearest best;
    std::uint32_t triangle = 0;
    while (pending > 0) {
        auto [node, distance] = stack[--pending];
        while (distance <= best.squaredDistance) {
            if (node >= levelBegin(depth)) {
                examineLeaf(node - levelBegin(depth), point, best, triangle);
                break;
            }
            const double left = squaredDistance(boxes[2 * node + 1], point);
            const double right = squaredDistance(boxes[2 * node + 2], point);
            const bool leftFirst = left <= right;
            stack[pending++] = {leftFirst ? 2 * node + 2 : 2 * node + 1, std::max(left, right)};
            node = leftFirst ? 2 * node + 1 : 2 * node + 2;
            distance = std::min(left, right);
        }
    }
    Hit hit{best.point, std::sqrt(best.squaredDistance), 0, triangle};
    const bool inside = pseudoNormal(triangle, best).dot(point - best.point) < 0;
    hit.signedDistance = inside ? -hit.distance : hit.distance;
    return hit;
}

/// A normal whose side tells inside from outside even at edges and corners (Baerentzen and Aanaes 2005).
Vec3 SurfaceDistance::Tree::pseudoNormal(std::uint32_t triangle, const Nearest& nearest) const
{
    if (nearest.feature == Feature::Corner)
        return vertexNormals[mesh.triangles[triangle][nearest.which]];
    const Vec3 normal = unitNormal(mesh, triangle);
    if (nearest.feature == Feature::Face)
        return normal;
    const std::uint32_t other = twin[3 * triangle + nearest.which];
    return other == HalfEdges::none ? normal : Vec3(normal + unitNormal(mesh, other / 3));
}

SurfaceDistance::SurfaceDistance(const TriangleMesh& mesh)
{
    if (mesh.empty())
        throw std::invalid_argument("SurfaceDistance: the mesh has no triangles");
    m_tree = std::make_unique<const Tree>(mesh);
}

SurfaceDistance::~SurfaceDistance() = default;
SurfaceDistance::SurfaceDistance(SurfaceDistance&&) noexcept = default;
SurfaceDistance& SurfaceDistance::operator=(SurfaceDistance&&) noexcept = default;

SurfaceDistance::Hit SurfaceDistance::nearest(const Vec3& point) const
{
    return m_tree->nearest(point);
}

} // namespace knead
