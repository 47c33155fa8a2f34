#include "core/geometry/wall_thickness.h"

#include "core/geometry/mass_properties.h"
#include "core/geometry/surface_ray.h"
#include "core/task/parallel_progress.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace knead {

namespace {

constexpr std::size_t sampleCount = 20'000;         // 2 % of them are 400: the quantile is right to 5 % of itself
constexpr double thinShare = 0.02;                  // of the area
constexpr double leastCosine = 0.93969262078590838; // of 20 degrees
constexpr double noWall = std::numeric_limits<double>::infinity();

struct Sample {
    Vec3 place = Vec3::Zero();
    Vec3 inward = Vec3::Zero(); ///< of unit length; zero on a triangle without area
    std::uint32_t triangle = 0;
};

/// Points at equal steps of area, in the order of the triangles; within a triangle by the R2 sequence (Roberts 2018).
class AreaSamples {
public:
    AreaSamples(const TriangleMesh& mesh, double orientation)
        : m_mesh(mesh)
        , m_orientation(orientation)
        , m_areaUpTo(mesh.triangles.size())
    {
        double sum = 0;
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
            m_areaUpTo[t] = sum += 0.5 * crossOf(mesh.vertices, mesh.triangles[t]).norm();
    }

    Sample operator[](std::size_t i) const
    {
        const double area = (static_cast<double>(i) + 0.5) / sampleCount * m_areaUpTo.back();
        const auto found = std::upper_bound(m_areaUpTo.begin(), m_areaUpTo.end() - 1, area);
        const auto triangle = static_cast<std::uint32_t>(found - m_areaUpTo.begin());
        double b = fraction(0.7548776662466927 * static_cast<double>(i));
        double c = fraction(0.5698402909980532 * static_cast<double>(i));
        if (b + c > 1) {
            b = 1 - b;
            c = 1 - c;
        }
        const std::array<Vec3, 3> corners = cornersOf(m_mesh.vertices, m_mesh.triangles[triangle]);
        return {corners[0] + b * (corners[1] - corners[0]) + c * (corners[2] - corners[0]),
                -m_orientation * crossOf(corners).stableNormalized(), triangle};
    }

private:
    static double fraction(double value) { return value - std::floor(value); }

    const TriangleMesh& m_mesh;
    double m_orientation;
    std::vector<double> m_areaUpTo; // the triangle's own included
};

double thicknessAt(const SurfaceRay& surface, const Sample& sample)
{
    if (sample.inward.isZero())
        return noWall;
    const auto exit = surface.firstExit(sample.place, sample.inward, sample.triangle);
    return exit && exit->cosine >= leastCosine ? exit->distance : noWall;
}

} // namespace

WallThickness wallThickness(const TriangleMesh& mesh, TaskControl& control)
{
    const MassProperties properties = massProperties(mesh);
    if (!(properties.area > 0))
        return {};
    const double orientation = properties.volume < 0 ? -1 : 1;
    const AreaSamples samples(mesh, orientation);
    control.throwIfCancelled();
    const SurfaceRay surface(mesh, orientation);
    std::vector<double> thickness(sampleCount);
    forEachBlock(sampleCount, 256, control, "measuring walls", [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            thickness[i] = thicknessAt(surface, samples[i]);
    });
    std::ranges::sort(thickness);
    const auto walls =
        static_cast<std::size_t>(std::lower_bound(thickness.begin(), thickness.end(), noWall) - thickness.begin());
    const double wallShare = static_cast<double>(walls) / sampleCount;
    if (wallShare < thinShare) {
        const double ball = 6 * std::abs(properties.volume) / properties.area;
        return {ball, ball, wallShare};
    }
    return {thickness[static_cast<std::size_t>(thinShare * sampleCount)], thickness[walls / 2], wallShare};
}

} // namespace knead
