#include "core/geometry/wall_change.h"

#include "core/geometry/mass_properties.h"
#include "core/geometry/surface_ray.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

constexpr std::size_t wallPointCount = 4'000;        // about a point per 2 mm^2 of a bar of 100 x 20 x 20 mm
constexpr std::size_t pointsBetweenLooks = 256;      // whether to stop
constexpr double leastCosineAtRest = 0.939692620786; // of 20 degrees
constexpr double leastCosineNow = 0.707106781187;    // of 45 degrees
constexpr double thinShareOfRest = 0.5;
constexpr double thinShareBelowSpacing = 0.8;
constexpr double leastShareOfSpacing = 0.05; // less is no wall: a surface meets itself there, in a crease
constexpr std::ptrdiff_t witnesses = 3;      // thin places beside each other, itself included

double fractionOf(double value)
{
    return value - std::floor(value);
}

/// Where a ray from a place straight in leaves the wall; none where there is no wall.
std::optional<SurfaceRay::Exit> exitFrom(const SurfaceRay& surface, const Vec3& inwards, const Vec3& place,
                                         std::uint32_t triangle, double leastCosine)
{
    if (inwards.isZero(0))
        return {};
    const auto exit = surface.firstExit(place, inwards, triangle);
    return exit && exit->cosine >= leastCosine ? exit : std::nullopt;
}

Vec3 inwardsFrom(const std::array<Vec3, 3>& corners, double orientation)
{
    return -orientation * crossOf(corners).stableNormalized();
}

Vec3 placeIn(const std::array<Vec3, 3>& corners, double b, double c)
{
    return corners[0] + b * (corners[1] - corners[0]) + c * (corners[2] - corners[0]);
}

} // namespace

WallChange::WallChange(const TriangleMesh& rest, TaskControl& control)
    : m_triangles(rest.triangles)
    , m_rest(rest.vertices)
{
    tbb::task_arena alone(1); // processors are for what a person waits for
    alone.execute([&] { findWalls(rest, control); });
}

/// At equal steps of area, in the order of the triangles; within a triangle by the R2 sequence (Roberts 2018).
void WallChange::findWalls(const TriangleMesh& rest, TaskControl& control)
{
    const MassProperties properties = massProperties(rest);
    if (!(properties.area > 0))
        return;
    m_orientation = properties.volume < 0 ? -1 : 1;
    control.throwIfCancelled();
    const SurfaceRay surface(rest, m_orientation);
    const double step = properties.area / wallPointCount;
    double areaUpTo = 0;
    std::size_t i = 0;
    for (std::uint32_t t = 0; t < rest.triangles.size(); ++t) {
        const std::array<Vec3, 3> corners = cornersOf(rest.vertices, rest.triangles[t]);
        areaUpTo += 0.5 * crossOf(corners).norm();
        for (; (static_cast<double>(i) + 0.5) * step <= areaUpTo; ++i) {
            if (i % pointsBetweenLooks == 0)
                control.throwIfCancelled();
            double b = fractionOf(0.7548776662466927 * static_cast<double>(i));
            double c = fractionOf(0.5698402909980532 * static_cast<double>(i));
            if (b + c > 1) {
                b = 1 - b;
                c = 1 - c;
            }
            const Vec3 place = placeIn(corners, b, c);
            const Vec3 inwards = inwardsFrom(corners, m_orientation);
            if (const auto exit = exitFrom(surface, inwards, place, t, leastCosineAtRest))
                m_points.push_back({t, b, c, exit->distance, place + exit->distance * inwards});
        }
    }
}

std::optional<ThinnedWall> WallChange::thinnest(const std::vector<Vec3>& now, double spacing,
                                                TaskControl& control) const
{
    if (m_points.empty())
        return {};
    tbb::task_arena alone(1);
    std::vector<ThinnedWall> thin = alone.execute([&] { return thinOnes(now, spacing, control); });
    std::ranges::stable_sort(thin, {}, &ThinnedWall::thickness);
    for (const ThinnedWall& one : thin) {
        control.throwIfCancelled();
        const auto isBeside = [&](const ThinnedWall& other) { return (other.place - one.place).norm() <= one.atRest; };
        if (std::ranges::count_if(thin, isBeside) >= witnesses)
            return one;
    }
    return {};
}

/// Whether a triangle is of what lay behind a place at rest, give or take what slides when a wall is pressed: a bar that is dented
/// at its side is no shorter, though rays along it end in the dent.
bool WallChange::isOpposite(const WallPoint& point, std::uint32_t triangle, double spacing) const
{
    const std::array<Vec3, 3> corners = cornersOf(m_rest, m_triangles[triangle]);
    const Vec3 middle = (corners[0] + corners[1] + corners[2]) / 3;
    const double size = std::max(
        {(corners[1] - corners[0]).norm(), (corners[2] - corners[1]).norm(), (corners[0] - corners[2]).norm()});
    return (middle - point.opposite).norm() <= std::max(0.5 * point.thickness, 2 * spacing) + size;
}

std::vector<ThinnedWall> WallChange::thinOnes(const std::vector<Vec3>& now, double spacing, TaskControl& control) const
{
    const TriangleMesh mesh{.vertices = now, .triangles = m_triangles, .faceOfTriangle = {}};
    const SurfaceRay surface(mesh, m_orientation);
    std::vector<ThinnedWall> thin;
    for (std::size_t i = 0; i < m_points.size(); ++i) {
        if (i % pointsBetweenLooks == 0)
            control.throwIfCancelled();
        const WallPoint& point = m_points[i];
        const std::array<Vec3, 3> corners = cornersOf(now, m_triangles[point.triangle]);
        const Vec3 place = placeIn(corners, point.b, point.c);
        const auto exit = exitFrom(surface, inwardsFrom(corners, m_orientation), place, point.triangle, leastCosineNow);
        if (!exit || !isOpposite(point, exit->triangle, spacing))
            continue;
        const double limit =
            std::max(thinShareOfRest * point.thickness, std::min(spacing, thinShareBelowSpacing * point.thickness));
        if (exit->distance < limit && exit->distance > leastShareOfSpacing * spacing)
            thin.push_back({place, point.triangle, exit->distance, point.thickness});
    }
    return thin;
}

} // namespace knead
