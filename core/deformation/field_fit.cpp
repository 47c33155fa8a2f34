#include "core/deformation/field_fit.h"

#include "core/deformation/field_fit_words.h"
#include "core/deformation/field_map.h"
#include "core/geometry/area_samples.h"
#include "core/geometry/point_tree.h"
#include "core/task/parallel_progress.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

namespace knead {

namespace {

constexpr std::size_t fitSamples = 20'000;   // on all parts together
constexpr std::size_t spacingSamples = 2000; // nodes
constexpr std::size_t roughSamples = 20'000; // nodes
constexpr std::size_t neighborCount = 5;     // of a node, with itself: the fourth is a spacing away
constexpr double reachOfNode = 2;            // spacings
constexpr double reachOfThinNode = 10;       // spacings, where nodes lie around: elements may be longer than thick
constexpr std::size_t aroundCount =
    128;                          // of these: two rows of a surface whose elements are eight times as long as thick
constexpr double roughOff = 0.02; // of what the field moves

/// A point of a surface, and what is looked at there.
struct Look {
    PlaceOnParts at;
    Vec3 normal = Vec3::Zero();
    double distance = 0;    ///< to the nearest node [m]
    bool isCovered = false; ///< has nodes near it, or around it
    double moved = 0;       ///< [m]
    double determinant = 1; ///< of the gradient
};

double spacingAt(const PointTree& nodes, const Vec3& node)
{
    return nodes.nearest(node, neighborCount).back().distance;
}

std::vector<Look> looksAt(std::span<const TriangleMesh> parts)
{
    double area = 0;
    for (const TriangleMesh& part : parts)
        area += AreaSamples(part, 1).area();
    std::vector<Look> looks;
    for (std::size_t p = 0; p < parts.size(); ++p) {
        const double share = area > 0 ? AreaSamples(parts[p], 1).area() / area : 0;
        const AreaSamples samples(parts[p], static_cast<std::size_t>(std::ceil(share * fitSamples)));
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const AreaSamples::Sample sample = samples[i];
            Look& look = looks.emplace_back();
            look.at = {0, sample.place, p, std::nullopt};
            look.normal = sample.normal;
            if (!parts[p].faceOfTriangle.empty())
                look.at.face = parts[p].faceOfTriangle[sample.triangle];
        }
    }
    return looks;
}

/// Whether nodes lie on all sides of a place of a surface, seen along its normal: no half of what is around it is without.
bool isSurrounded(const Vec3& place, const Vec3& normal, const PointTree& nodes, const std::vector<Vec3>& places)
{
    constexpr double steep = 0.1; // what lies above or below is on no side
    constexpr double widestGap = 1.1 * std::numbers::pi;
    const Vec3 right = normal.unitOrthogonal();
    const Vec3 up = normal.cross(right);
    std::vector<double> angles;
    for (const PointTree::Found& found : nodes.nearest(place, aroundCount)) {
        const Vec3 way = places[found.point] - place;
        const double x = right.dot(way);
        const double y = up.dot(way);
        if (std::hypot(x, y) > steep * way.norm())
            angles.push_back(std::atan2(y, x));
    }
    if (angles.empty())
        return false;
    std::ranges::sort(angles);
    double gap = angles.front() + 2 * std::numbers::pi - angles.back();
    for (std::size_t i = 1; i < angles.size(); ++i)
        gap = std::max(gap, angles[i] - angles[i - 1]);
    return gap < widestGap;
}

bool isCovered(const Look& look, double spacing, const PointTree& nodes, const std::vector<Vec3>& places)
{
    return look.distance <= reachOfNode * spacing ||
           (look.distance <= reachOfThinNode * spacing && isSurrounded(look.at.place, look.normal, nodes, places));
}

void measure(std::vector<Look>& looks, const PointTree& nodes, const std::vector<Vec3>& places, const SmoothMap& map,
             TaskControl& control)
{
    const auto measureSome = [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            Look& look = looks[i];
            const PointTree::Found nearest = nodes.nearest(look.at.place);
            look.distance = nearest.distance;
            look.isCovered = isCovered(look, spacingAt(nodes, places[nearest.point]), nodes, places);
            look.moved = (map.at(look.at.place) - look.at.place).norm();
            look.determinant = map.gradient(look.at.place).determinant();
        }
    };
    forEachBlock(looks.size(), 128, control, "comparing the field with the parts", measureSome);
}

PlaceOnParts placed(const Look& look, double value)
{
    PlaceOnParts place = look.at;
    place.value = value;
    return place;
}

void sumUp(const std::vector<Look>& looks, FieldFit& fit)
{
    std::size_t uncovered = 0;
    fit.determinant.value = std::numeric_limits<double>::infinity();
    for (const Look& look : looks) {
        uncovered += look.isCovered ? 0 : 1;
        if (look.distance >= fit.farthest.value)
            fit.farthest = placed(look, look.distance);
        if (look.moved >= fit.displacement.value)
            fit.displacement = placed(look, look.moved);
        if (look.determinant < fit.determinant.value)
            fit.determinant = placed(look, look.determinant);
    }
    fit.uncovered = static_cast<double>(uncovered) / static_cast<double>(std::max<std::size_t>(looks.size(), 1));
}

double medianSpacing(const PointTree& nodes, const std::vector<Vec3>& places)
{
    const std::size_t count = std::min(places.size(), spacingSamples);
    std::vector<double> spacings(count);
    for (std::size_t i = 0; i < count; ++i)
        spacings[i] = spacingAt(nodes, places[i * places.size() / count]);
    const auto middle = spacings.begin() + static_cast<std::ptrdiff_t>(count / 2);
    std::nth_element(spacings.begin(), middle, spacings.end());
    return *middle;
}

/// What the map of the field alone makes of the nodes: those of two sides of a slit are in nearly one place, but move apart.
void judgeRoughness(const FieldDeformation& deformation, const SmoothMap& given, FieldFit& fit, TaskControl& control)
{
    const DisplacementField& field = *deformation.field;
    const double moves = boxOfPlaces(field.displacements).diagonal().norm();
    const std::shared_ptr<const SmoothMap> own = fieldMap({.field = deformation.field}, control, &given);
    const std::size_t count = std::min(field.nodes.size(), roughSamples);
    std::vector<Vec3> nodes(count);
    for (std::size_t i = 0; i < count; ++i)
        nodes[i] = field.nodes[i * field.nodes.size() / count];
    std::vector<Vec3> places(count);
    own->evaluate(nodes, places);
    std::size_t missed = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double off = (places[i] - nodes[i] - field.displacements[i * field.nodes.size() / count]).norm();
        missed += off > roughOff * moves ? 1 : 0;
        if (off > fit.roughest.value)
            fit.roughest = {off, nodes[i], 0, std::nullopt};
    }
    fit.roughness = static_cast<double>(missed) / static_cast<double>(count);
}

} // namespace

FieldFit fitOfField(const FieldDeformation& deformation, const SmoothMap& map, std::span<const TriangleMesh> parts,
                    const std::string& unit, TaskControl& control)
{
    assert(!parts.empty());
    const std::vector<Vec3>& places = deformation.field->nodes;
    const PointTree nodes(places);
    FieldFit fit;
    fit.nodes = boxOfPlaces(places);
    for (const TriangleMesh& part : parts)
        fit.parts.extend(boxOfPlaces(part.vertices));
    fit.spacing = medianSpacing(nodes, places);

    std::vector<Look> looks = looksAt(parts);
    TaskPortion comparing(control, 0, 0.6);
    measure(looks, nodes, places, map, comparing);
    sumUp(looks, fit);
    TaskPortion judging(control, 0.6, 1);
    judgeRoughness(deformation, map, fit, judging);
    sayHowItFits(fit, unit);
    return fit;
}

} // namespace knead
