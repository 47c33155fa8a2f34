#include "core/session/comparison.h"

#include "core/geometry/mass_properties.h"
#include "core/geometry/refine.h"
#include "core/geometry/surface_distance.h"
#include "core/message/message.h"
#include "core/session/part_pairs.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace knead {

namespace {

constexpr std::size_t cancelInterval = 4096; // vertices between looks at whether to go on

/// Of each vertex, a third of the area of the triangles around it [m^2].
std::vector<double> areasOf(const TriangleMesh& mesh, std::span<const Vec3> places)
{
    std::vector<double> areas(places.size(), 0);
    for (const auto& t : mesh.triangles) {
        const double area = crossOf(places, t).norm() / 2;
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

std::vector<const Part*> closedParts(const Model& model)
{
    std::vector<const Part*> closed;
    for (const Part& part : model.parts)
        if (part.canBeFilled())
            closed.push_back(&part);
    return closed;
}

std::string nameOf(const Part& part)
{
    return part.path.empty() ? part.name : part.path;
}

/// From the one surface to the other and back: what is missing lies on the one, what was added on the other.
BodyComparison comparePair(const Part& before, const Part& now, TaskControl& control)
{
    constexpr double fineness = 1.0 / 100; // of the size: how far from each other places are looked at
    const auto far = [](std::size_t) { return 1.0; };
    const auto from = [&](const Part& part, const SurfaceDistance& other, TaskControl& portion) {
        const TriangleMesh skin = refine(part.mesh, fineness * part.box.diagonal().norm());
        return distancesOf(nameOf(now), skin, skin.vertices, other, far, portion);
    };
    TaskPortion there(control, 0, 0.5);
    BodyComparison result = from(now, SurfaceDistance(before.mesh), there);
    TaskPortion back(control, 0.5, 1);
    const BodyComparison other = from(before, SurfaceDistance(now.mesh), back);
    if (other.largestDistance > result.largestDistance) {
        result.largestDistance = other.largestDistance;
        result.farthest = other.farthest;
    }
    result.meanDistance =
        (result.meanDistance * now.area + other.meanDistance * before.area) / (now.area + before.area);
    result.largestDisplacement = std::numeric_limits<double>::quiet_NaN();
    result.rest = massOf(before);
    result.now = massOf(now);
    return result;
}

} // namespace

Comparison compareWithOriginal(const FilledModel& content, const Frame& shown, const Snapshot& present,
                               TaskControl& control)
{
    Comparison comparison{.time = shown.snapshot->time};
    for (BodyId b = 0; b < content.bodies.size(); ++b) {
        TaskPortion portion = TaskPortion::ofItem(control, b, content.bodies.size());
        BodyComparison body = compare(*shown.filled[b], shown.bodies[b]->places, portion);
        body.rest = massAtRest(content, b, present);
        body.now = massNow(content, b, shown, present);
        comparison.bodies.push_back(std::move(body));
    }
    return comparison;
}

Comparison compareModels(const Model& original, const Model& changed, TaskControl& control)
{
    const std::vector<const Part*> originals = closedParts(original);
    const std::vector<const Part*> others = closedParts(changed);
    Comparison comparison;
    const std::vector<PartPair> pairs = pairsOfParts(originals, others);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        TaskPortion portion = TaskPortion::ofItem(control, i, pairs.size());
        comparison.bodies.push_back(comparePair(*originals[pairs[i].before], *others[pairs[i].after], portion));
    }
    if (comparison.bodies.empty())
        throw Problem(Message("Comparison", "One of the files has no closed part: there is nothing to compare."));
    for (std::size_t p = 0; p < originals.size(); ++p)
        if (std::ranges::find(pairs, p, &PartPair::before) == pairs.end())
            comparison.onlyBefore.push_back(nameOf(*originals[p]));
    for (std::size_t p = 0; p < others.size(); ++p)
        if (std::ranges::find(pairs, p, &PartPair::after) == pairs.end())
            comparison.onlyNow.push_back(nameOf(*others[p]));
    return comparison;
}

} // namespace knead
