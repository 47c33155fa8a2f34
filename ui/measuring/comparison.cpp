#include "ui/measuring/comparison.h"

#include "core/geometry/surface_distance.h"

#include <algorithm>

namespace knead {

namespace {

constexpr std::size_t cancelInterval = 4096; // vertices between looks at whether to go on

/// Of each vertex, a third of the area of the triangles around it [m^2].
std::vector<double> areasOf(const TriangleMesh& mesh, std::span<const Vec3> places)
{
    std::vector<double> areas(places.size(), 0);
    for (const auto& t : mesh.triangles) {
        const double area = (places[t[1]] - places[t[0]]).cross(places[t[2]] - places[t[0]]).norm() / 2;
        for (const std::uint32_t v : t)
            areas[v] += area / 3;
    }
    return areas;
}

BodyComparison compare(const FilledBody& body, std::span<const Vec3> places, TaskControl& control)
{
    const SurfaceDistance original(body.mesh);
    const std::vector<double> areas = areasOf(body.mesh, places);
    BodyComparison result{.name = body.name};
    double sum = 0;
    double area = 0;
    for (std::size_t v = 0; v < places.size(); ++v) {
        if (v % cancelInterval == 0) {
            control.throwIfCancelled();
            control.report(static_cast<double>(v) / static_cast<double>(places.size()), body.name);
        }
        const double moved = (places[v] - body.mesh.vertices[v]).norm();
        result.largestDisplacement = std::max(result.largestDisplacement, moved);
        const double distance = moved == 0 ? 0 : original.nearest(places[v]).distance;
        sum += areas[v] * distance;
        area += areas[v];
        if (distance > result.largestDistance) {
            result.largestDistance = distance;
            result.farthest = places[v];
        }
    }
    result.meanDistance = area > 0 ? sum / area : 0;
    return result;
}

} // namespace

Comparison compareWithOriginal(const FilledModel& content, const Frame& shown, const Snapshot& present,
                               TaskControl& control)
{
    Comparison comparison{.time = shown.snapshot->time};
    const auto count = static_cast<double>(content.bodies.size());
    for (BodyId b = 0; b < content.bodies.size(); ++b) {
        TaskPortion portion(control, b / count, (b + 1) / count);
        BodyComparison body = compare(*content.bodies[b], shown.bodies[b]->places, portion);
        body.rest = massAtRest(content, b, present);
        body.now = massNow(content, b, shown, present);
        comparison.bodies.push_back(std::move(body));
    }
    return comparison;
}

} // namespace knead
