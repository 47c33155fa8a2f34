#include "core/geometry/triangle_crossing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace knead {

namespace {

using Corners = std::array<Vec3, 3>;

/// The corner of the neighbor beyond the edge from corner `edge` to the next.
std::optional<Vec3> cornerBeyond(const SurfaceTriangle& t, std::size_t edge)
{
    const std::uint32_t twin = t.halfEdges.twin[std::size_t{3} * t.triangle + edge];
    if (twin == HalfEdges::none)
        return std::nullopt;
    return t.mesh.vertices[t.mesh.triangles[twin / 3][(twin + 2) % 3]];
}

/// The plane of a triangle, thick by twice the tolerance.
struct Plane {
    Vec3 place;
    Vec3 normal; ///< of unit length
    double tolerance;

    /// [m]; 0 within the tolerance
    double distanceTo(const Vec3& point) const
    {
        const double distance = normal.dot(point - place);
        return std::abs(distance) <= tolerance ? 0 : distance;
    }
};

/// Nothing when the triangle is too thin to have one.
std::optional<Plane> planeOf(const Corners& t, double tolerance)
{
    const Vec3 normal = crossOf(t);
    const double area = normal.norm();
    const double longestEdge = std::max({(t[1] - t[0]).norm(), (t[2] - t[1]).norm(), (t[0] - t[2]).norm()});
    if (area <= tolerance * longestEdge)
        return std::nullopt;
    return Plane{t[0], normal / area, tolerance};
}

/// Whether corner i + 2 alone is out of a plane, and the neighbor beyond the opposite edge is on its other side.
bool endsInPlane(const SurfaceTriangle& t, const std::array<double, 3>& distances, std::size_t i, const Plane& plane)
{
    const double distance = distances[(i + 2) % 3];
    if (distances[i] != 0 || distances[(i + 1) % 3] != 0 || distance == 0)
        return false;
    const std::optional<Vec3> beyond = cornerBeyond(t, i);
    return beyond && distance * plane.distanceTo(*beyond) < 0;
}

/// The ends of the line in which a triangle goes through a plane; nothing when it does not.
std::optional<std::array<Vec3, 2>> lineThrough(const SurfaceTriangle& t, const Corners& corners, const Plane& plane)
{
    std::array<double, 3> distances;
    for (std::size_t i = 0; i < 3; ++i)
        distances[i] = plane.distanceTo(corners[i]);
    for (std::size_t i = 0; i < 3; ++i)
        if (endsInPlane(t, distances, i, plane))
            return std::array{corners[i], corners[(i + 1) % 3]};
    const auto [least, most] = std::ranges::minmax_element(distances);
    if (*least >= 0 || *most <= 0)
        return std::nullopt;
    std::array<Vec3, 2> line;
    std::size_t found = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        if (distances[i] == 0)
            line[found++] = corners[i];
        else if (distances[i] * distances[j] < 0)
            line[found++] = corners[i] + distances[i] / (distances[i] - distances[j]) * (corners[j] - corners[i]);
    }
    return line;
}

} // namespace

std::optional<CrossingLine> crossingOf(const SurfaceTriangle& a, const SurfaceTriangle& b, double tolerance)
{
    const Corners cornersOfA = cornersOf(a.mesh.vertices, a.mesh.triangles[a.triangle]);
    const Corners cornersOfB = cornersOf(b.mesh.vertices, b.mesh.triangles[b.triangle]);
    const std::optional<Plane> planeOfB = planeOf(cornersOfB, tolerance);
    const auto inA = planeOfB ? lineThrough(a, cornersOfA, *planeOfB) : std::nullopt;
    if (!inA)
        return std::nullopt;
    const std::optional<Plane> planeOfA = planeOf(cornersOfA, tolerance);
    const auto inB = planeOfA ? lineThrough(b, cornersOfB, *planeOfA) : std::nullopt;
    if (!inB)
        return std::nullopt;
    const Vec3 along = (*inA)[1] - (*inA)[0];
    const double length = along.norm();
    if (length <= tolerance)
        return std::nullopt;
    const Vec3 direction = along / length;
    std::array<double, 2> places{direction.dot((*inB)[0] - (*inA)[0]), direction.dot((*inB)[1] - (*inA)[0])};
    if (places[0] > places[1])
        std::swap(places[0], places[1]);
    const double begin = std::max(places[0], 0.0);
    const double end = std::min(places[1], length);
    if (end - begin <= tolerance)
        return std::nullopt;
    return CrossingLine{(*inA)[0] + begin * direction, (*inA)[0] + end * direction};
}

} // namespace knead
