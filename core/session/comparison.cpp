#include "core/session/comparison.h"

#include "core/geometry/mass_properties.h"
#include "core/geometry/refine.h"
#include "core/geometry/surface_distance.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

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

/// Of places on a mesh from a surface, each by the area around it.
/// @param moved how far a vertex has gone [m]; 0: it lies on the surface
template <typename Moved>
BodyComparison distancesOf(const std::string& name, const TriangleMesh& mesh, std::span<const Vec3> places,
                           const SurfaceDistance& original, Moved moved, TaskControl& control)
{
    const std::vector<double> areas = areasOf(mesh, places);
    BodyComparison result{.name = name};
    double sum = 0;
    double area = 0;
    for (std::size_t v = 0; v < places.size(); ++v) {
        if (v % cancelInterval == 0) {
            control.throwIfCancelled();
            control.report(static_cast<double>(v) / static_cast<double>(places.size()), name);
        }
        const double way = moved(v);
        result.largestDisplacement = std::max(result.largestDisplacement, way);
        const double distance = way == 0 ? 0 : original.nearest(places[v]).distance;
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

BodyComparison compare(const FilledBody& body, std::span<const Vec3> places, TaskControl& control)
{
    return distancesOf(
        body.name, body.mesh, places, SurfaceDistance(body.mesh),
        [&](std::size_t v) { return (places[v] - body.mesh.vertices[v]).norm(); }, control);
}

/// Of a surface, by the divergence theorem; mass is not known.
BodyMass massOf(const Part& part)
{
    const MassProperties properties = massProperties(part.mesh);
    return {part.volume > 0 ? part.volume : properties.volume, 0, properties.centroid};
}

const Part* counterpartOf(const Part& part, std::size_t index, const Model& model)
{
    for (const auto& text : {&Part::path, &Part::name})
        if (const auto found = std::ranges::find(model.parts, part.*text, text);
            found != model.parts.end() && found->canBeFilled())
            return &*found;
    return index < model.parts.size() && model.parts[index].canBeFilled() ? &model.parts[index] : nullptr;
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

Comparison compareModels(const Model& original, const Model& changed, TaskControl& control)
{
    constexpr double fineness = 1.0 / 100; // of the size: how far from each other places are looked at
    Comparison comparison;
    for (std::size_t p = 0; p < changed.parts.size(); ++p) {
        const Part& now = changed.parts[p];
        const Part* before = counterpartOf(now, p, original);
        if (!now.canBeFilled() || before == nullptr)
            continue;
        const auto count = static_cast<double>(changed.parts.size());
        TaskPortion portion(control, static_cast<double>(p) / count, static_cast<double>(p + 1) / count);
        const TriangleMesh skin = refine(now.mesh, fineness * now.box.diagonal().norm());
        const SurfaceDistance surface(before->mesh);
        BodyComparison body = distancesOf(
            now.path.empty() ? now.name : now.path, skin, skin.vertices, surface, [](std::size_t) { return 1.0; },
            portion);
        body.largestDisplacement = std::numeric_limits<double>::quiet_NaN();
        body.rest = massOf(*before);
        body.now = massOf(now);
        comparison.bodies.push_back(std::move(body));
    }
    if (comparison.bodies.empty())
        throw std::runtime_error(
            "No closed part of the one file belongs to one of the other: there is nothing to compare.");
    return comparison;
}

} // namespace knead
