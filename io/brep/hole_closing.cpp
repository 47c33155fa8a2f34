#include "io/brep/hole_closing.h"

#include "core/geometry/mass_properties.h"
#include "io/mesh/open_borders.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace knead {

namespace {

constexpr double largestBump = 0.1; // of the width of the hole, off its plane
constexpr std::size_t longestHoleBorder = 2000;

using Point2 = Eigen::Vector2d;
using Triangle = TriangleMesh::Triangle;

/// Half the sum of cross products along the border: its length is the area, its direction the normal (Newell).
Vec3 areaVector(const TriangleMesh& mesh, const std::vector<std::uint32_t>& loop)
{
    Vec3 sum = Vec3::Zero();
    const Vec3 origin = mesh.vertices[loop.front()];
    for (std::size_t i = 0; i < loop.size(); ++i)
        sum += (mesh.vertices[loop[i]] - origin).cross(mesh.vertices[loop[(i + 1) % loop.size()]] - origin);
    return 0.5 * sum;
}

bool isNearlyFlat(const TriangleMesh& mesh, const std::vector<std::uint32_t>& loop, const Vec3& normal)
{
    Vec3 middle = Vec3::Zero();
    Box box;
    for (const std::uint32_t vertex : loop) {
        middle += mesh.vertices[vertex] / static_cast<double>(loop.size());
        box.extend(mesh.vertices[vertex]);
    }
    return std::all_of(loop.begin(), loop.end(), [&](std::uint32_t vertex) {
        return std::abs((mesh.vertices[vertex] - middle).dot(normal)) <= largestBump * box.diagonal().norm();
    });
}

double cross(const Point2& a, const Point2& b, const Point2& c)
{
    return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

bool isInTriangle(const Point2& p, const Point2& a, const Point2& b, const Point2& c)
{
    return cross(a, b, p) >= 0 && cross(b, c, p) >= 0 && cross(c, a, p) >= 0;
}

/// Cuts ears off a polygon in the plane of its normal.
/// @return nothing when the border crosses itself
std::optional<std::vector<Triangle>> earsOf(const TriangleMesh& mesh, std::vector<std::uint32_t> loop,
                                            const Vec3& normal)
{
    const Vec3 u = normal.unitOrthogonal();
    const Vec3 v = normal.cross(u);
    const auto at = [&](std::uint32_t vertex) {
        return Point2(mesh.vertices[vertex].dot(u), mesh.vertices[vertex].dot(v));
    };
    const auto isEar = [&](const Triangle& corner) {
        const Point2 a = at(corner[0]);
        const Point2 b = at(corner[1]);
        const Point2 c = at(corner[2]);
        return cross(a, b, c) > 0 && std::none_of(loop.begin(), loop.end(), [&](std::uint32_t other) {
                   const bool isCorner = other == corner[0] || other == corner[1] || other == corner[2];
                   return !isCorner && isInTriangle(at(other), a, b, c);
               });
    };
    std::vector<Triangle> triangles;
    while (loop.size() > 3) {
        const std::size_t count = loop.size();
        std::size_t i = 0;
        const auto corner = [&] { return Triangle{loop[(i + count - 1) % count], loop[i], loop[(i + 1) % count]}; };
        while (i < count && !isEar(corner()))
            ++i;
        if (i == count)
            return std::nullopt;
        triangles.push_back(corner());
        loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(i));
    }
    triangles.push_back({loop[0], loop[1], loop[2]});
    return triangles;
}

} // namespace

HoleClosing closeHoles(TriangleMesh mesh, double largestShare)
{
    const std::vector<OpenLoop> loops = openLoopsOf(mesh);
    HoleClosing result{std::move(mesh)};
    if (loops.empty())
        return result;
    const double area = massProperties(result.mesh).area;
    for (const OpenLoop& loop : loops) {
        if (loop.vertices.size() < 3 || loop.vertices.size() > longestHoleBorder)
            continue;
        const Vec3 hole = areaVector(result.mesh, loop.vertices);
        const Vec3 normal = hole.normalized();
        if (!(hole.norm() > 0) || hole.norm() > largestShare * area ||
            !isNearlyFlat(result.mesh, loop.vertices, normal))
            continue;
        const auto triangles = earsOf(result.mesh, loop.vertices, normal);
        if (!triangles)
            continue;
        for (const Triangle& triangle : *triangles) {
            result.mesh.triangles.push_back(triangle);
            if (!result.mesh.faceOfTriangle.empty())
                result.mesh.faceOfTriangle.push_back(loop.face);
        }
        ++result.holes;
        result.addedShare += hole.norm() / area;
    }
    return result;
}

} // namespace knead
