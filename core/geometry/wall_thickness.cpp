#include "core/geometry/wall_thickness.h"

#include "core/geometry/area_samples.h"
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

double thicknessAt(const SurfaceRay& surface, const AreaSamples::Sample& sample, double orientation)
{
    if (sample.normal.isZero())
        return noWall;
    const auto exit = surface.firstExit(sample.place, -orientation * sample.normal, sample.triangle);
    return exit && exit->cosine >= leastCosine ? exit->distance : noWall;
}

} // namespace

WallThickness wallThickness(const TriangleMesh& mesh, TaskControl& control)
{
    const MassProperties properties = massProperties(mesh);
    if (!(properties.area > 0))
        return {};
    const double orientation = properties.volume < 0 ? -1 : 1;
    const AreaSamples samples(mesh, sampleCount);
    control.throwIfCancelled();
    const SurfaceRay surface(mesh, orientation);
    std::vector<double> thickness(sampleCount);
    forEachBlock(sampleCount, 256, control, "measuring walls", [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            thickness[i] = thicknessAt(surface, samples[i], orientation);
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
