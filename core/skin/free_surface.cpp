#include "core/skin/free_surface.h"

#include "core/geometry/half_edges.h"
#include "core/geometry/shape_fit.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace knead {

namespace {

constexpr double flatSpread = 0.22;   // second eigenvalue of the normals by the first: tan^2 of 25 degrees
constexpr double flatMean = 0.7;      // length of their mean: those of a knife's edge point away from each other
constexpr double cornerSpread = 0.08; // third by the first: normals no longer lie in a plane across an edge
constexpr double flatCosine = 0.64;   // of the normals of two triangles that are of one face: 50 degrees
constexpr int rings = 4;              // of neighbors over which a curvature is a mean, so that facets are round

/// What the triangles at a vertex say.
struct Fan {
    Mat3 normals = Mat3::Zero(); ///< sum of angle n n^T
    Vec3 mean = Vec3::Zero();    ///< sum of angle n
    Vec3 away = Vec3::Zero();    ///< sum of angle times the way to the middle of the opposite side
};

std::vector<Fan> fansOf(const TriangleMesh& mesh)
{
    std::vector<Fan> fans(mesh.vertices.size());
    for (const TriangleMesh::Triangle& triangle : mesh.triangles)
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const Vec3& here = mesh.vertices[triangle[corner]];
            const Vec3 a = mesh.vertices[triangle[(corner + 1) % 3]] - here;
            const Vec3 b = mesh.vertices[triangle[(corner + 2) % 3]] - here;
            const Vec3 area = a.cross(b);
            const double twice = area.norm();
            if (!(twice > 0))
                continue;
            const double angle = std::atan2(twice, a.dot(b));
            const Vec3 normal = area / twice;
            Fan& fan = fans[triangle[corner]];
            fan.normals += angle * normal * normal.transpose();
            fan.mean += angle * normal;
            fan.away += angle * (a + b).normalized();
        }
    return fans;
}

FreeSurface surfaceOf(const Fan& fan)
{
    const double mean = fan.mean.norm();
    const Eigen::SelfAdjointEigenSolver<Mat3> spread(fan.normals);
    const Vec3& shares = spread.eigenvalues();
    if (!(mean > 0) || !(shares[2] > 0))
        return {};
    if (shares[1] < flatSpread * shares[2] && mean > flatMean * fan.normals.trace())
        return {FreeSurface::Kind::face, fan.mean / mean};
    const bool isOutward = fan.away.dot(fan.mean) < 0;
    if (!isOutward)
        return {.hollow = std::numeric_limits<double>::infinity()};
    if (shares[0] < cornerSpread * shares[2])
        return {FreeSurface::Kind::edge, spread.eigenvectors().col(0)};
    return {};
}

/// Largest curvature inwards at the faces' vertices. Each edge bends the surface across itself by its angle: over an area, the mean of
/// angle times length times e e^T (Cohen-Steiner and Morvan, 2003), whose largest eigenvalue is the curvature across e. The area is
/// that of some rings of neighbors around a vertex.
void findHollows(const TriangleMesh& mesh, std::vector<FreeSurface>& surfaces)
{
    struct Bend {
        Mat3 inwards = Mat3::Zero(); ///< sum of angle times length e e^T
        double area = 0;
    };
    const HalfEdges edges = findHalfEdges(mesh);
    const auto areaOf = [&](std::size_t triangle) -> Vec3 {
        return 0.5 * crossOf(mesh.vertices, mesh.triangles[triangle]);
    };
    const auto endsOf = [&](std::size_t edge) {
        return std::pair(mesh.triangles[edge / 3][edge % 3], mesh.triangles[edge / 3][(edge + 1) % 3]);
    };
    const auto isFace = [&](std::uint32_t vertex) { return surfaces[vertex].kind == FreeSurface::Kind::face; };
    std::vector<Bend> own(mesh.vertices.size());
    for (std::size_t edge = 0; edge < edges.twin.size(); ++edge) {
        const auto [from, to] = endsOf(edge);
        const Vec3 here = areaOf(edge / 3);
        own[from].area += here.norm() / 3;
        if (edges.twin[edge] == HalfEdges::none || !isFace(from) || !isFace(to))
            continue;
        const Vec3 there = areaOf(edges.twin[edge] / 3);
        const Vec3 way = mesh.vertices[to] - mesh.vertices[from];
        const double length = way.norm();
        if (!(length > 0))
            continue;
        // Outwards the normals turn about the edge as it runs. Both of its half-edges add, each to both ends: a quarter.
        const double angle = std::atan2(-here.cross(there).dot(way) / length, here.dot(there));
        const Mat3 bend = 0.25 * angle / length * way * way.transpose();
        own[from].inwards += bend;
        own[to].inwards += bend;
    }
    // Each passes on half of what it has, so that nothing counts more for having many neighbors.
    for (int ring = 0; ring < rings; ++ring) {
        std::vector<Bend> around(own.size());
        for (std::uint32_t v = 0; v < own.size(); ++v) {
            around[v].inwards += 0.5 * own[v].inwards;
            around[v].area += 0.5 * own[v].area;
            const std::span<const std::uint32_t> leaving = edges.leaving(v);
            const double share = leaving.empty() ? 0 : 0.5 / static_cast<double>(leaving.size());
            for (const std::uint32_t edge : leaving) {
                Bend& neighbor = around[endsOf(edge).second];
                neighbor.inwards += share * own[v].inwards;
                neighbor.area += share * own[v].area;
            }
        }
        own = std::move(around);
    }
    for (std::uint32_t v = 0; v < own.size(); ++v)
        if (isFace(v) && own[v].area > 0) {
            const Eigen::SelfAdjointEigenSolver<Mat3> bend(own[v].inwards / own[v].area, Eigen::EigenvaluesOnly);
            surfaces[v].hollow = std::max(0.0, bend.eigenvalues()[2]);
        }
}

} // namespace

std::vector<FreeSurface> freeSurfaces(const TriangleMesh& mesh)
{
    const std::vector<Fan> fans = fansOf(mesh);
    std::vector<FreeSurface> surfaces(fans.size());
    std::transform(fans.begin(), fans.end(), surfaces.begin(), surfaceOf);
    findHollows(mesh, surfaces);
    return surfaces;
}

FreeSurfaceFinder::FreeSurfaceFinder(const TriangleMesh& mesh)
    : m_mesh(mesh)
    , m_ofVertices(freeSurfaces(mesh))
    , m_edges(findHalfEdges(mesh))
{
}

FreeSurface FreeSurfaceFinder::at(const Vec3& place, std::uint32_t triangle, double reach) const
{
    const TriangleMesh::Triangle& corners = m_mesh.triangles[triangle];
    const std::array<Vec3, 3> places = cornersOf(m_mesh.vertices, corners);
    const Vec3 cross = crossOf(places);
    const double twice = cross.norm();
    if (!(twice > 0))
        return {};
    const Vec3 shares = nearestShares(places, place);
    for (std::size_t i = 0; i < 3; ++i)
        if ((places[i] - place).norm() < reach)
            return m_ofVertices[corners[i]];
    for (std::size_t i = 0; i < 3; ++i) {
        const double length = (places[(i + 1) % 3] - places[i]).norm();
        if (shares[static_cast<Eigen::Index>((i + 2) % 3)] * twice < reach * length)
            return onEdge(3 * std::size_t{triangle} + i);
    }
    // Facets of a round face: between the normals of the corners that are of it.
    const Vec3 normal = cross / twice;
    FreeSurface surface{FreeSurface::Kind::face, Vec3::Zero()};
    for (std::size_t i = 0; i < 3; ++i) {
        const FreeSurface& corner = m_ofVertices[corners[i]];
        const double share = shares[static_cast<Eigen::Index>(i)];
        const bool isSameFace = corner.kind == FreeSurface::Kind::face && corner.direction.dot(normal) > flatCosine;
        surface.direction += share * (isSameFace ? corner.direction : normal);
        surface.hollow += isSameFace ? share * corner.hollow : 0;
    }
    surface.direction.normalize();
    return surface;
}

FreeSurface FreeSurfaceFinder::onEdge(std::size_t halfEdge) const
{
    const TriangleMesh::Triangle& here = m_mesh.triangles[halfEdge / 3];
    const Vec3 normal = crossOf(m_mesh.vertices, here).normalized();
    const std::uint32_t twin = m_edges.twin[halfEdge];
    if (twin == HalfEdges::none)
        return {FreeSurface::Kind::face, normal};
    const Vec3 other = crossOf(m_mesh.vertices, m_mesh.triangles[twin / 3]).normalized();
    if (normal.dot(other) > flatCosine)
        return {FreeSurface::Kind::face, (normal + other).normalized()};
    const Vec3 way = m_mesh.vertices[here[(halfEdge + 1) % 3]] - m_mesh.vertices[here[halfEdge % 3]];
    if (normal.cross(other).dot(way) < 0) // inwards
        return {.hollow = std::numeric_limits<double>::infinity()};
    return {FreeSurface::Kind::edge, way.normalized()};
}

FreeSurface moved(const FreeSurface& surface, const Mat3& gradient)
{
    if (surface.kind == FreeSurface::Kind::none)
        return surface;
    Vec3 direction = gradient * surface.direction;
    if (surface.kind == FreeSurface::Kind::face) {
        Mat3 cofactors; // det F F^-T, which is finite for flat material, too
        cofactors << gradient.col(1).cross(gradient.col(2)), gradient.col(2).cross(gradient.col(0)),
            gradient.col(0).cross(gradient.col(1));
        direction = cofactors * surface.direction;
    }
    const double length = direction.norm();
    return length > 0 ? FreeSurface{surface.kind, direction / length} : FreeSurface{};
}

Mat3 withoutTraction(const Mat3& stress, const FreeSurface& surface, double poissonRatio, double share)
{
    if (surface.kind == FreeSurface::Kind::none || share <= 0)
        return stress;
    const Vec3& n = surface.direction;
    const Mat3 across = n * n.transpose();
    const Vec3 t = stress * n;
    const double normal = n.dot(t);
    if (surface.kind == FreeSurface::Kind::edge)
        return (1 - share) * stress + share * (normal - poissonRatio * (stress.trace() - normal)) * across;
    const Mat3 traction = n * t.transpose() + t * n.transpose() - normal * across;
    const Mat3 squeezed = poissonRatio / (1 - poissonRatio) * normal * (Mat3::Identity() - across);
    return stress - share * (traction + squeezed);
}

} // namespace knead
