#include "core/deformation/number_placement.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace knead {

namespace {

constexpr double steepestOfQuintic = 1.875; // 15/8, in its middle

std::string millimetersText(double meters)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", 1e3 * meters);
    return text;
}

/// Toward which side of the neutral plane a bend goes.
double innerSign(const NumberDeformation& deformation)
{
    return deformation.angle < 0 ? -1 : 1;
}

} // namespace

NumberDeformation suggestedDeformation(NumberKind kind, const Box& box)
{
    const Vec3 sides = box.sizes();
    Eigen::Index longest = 0;
    sides.maxCoeff(&longest);
    Eigen::Index shortest = longest == 2 ? 1 : 2;
    for (Eigen::Index axis = 0; axis < 3; ++axis)
        if (axis != longest && sides[axis] < sides[shortest])
            shortest = axis;
    return {.kind = kind,
            .origin = box.center(),
            .axis = Vec3::Unit(longest),
            .side = Vec3::Unit(shortest),
            .from = -sides[longest] / 4,
            .to = sides[longest] / 4};
}

HeightRange heightsBetweenPlanes(const NumberDeformation& deformation, const TriangleMesh& mesh)
{
    HeightRange range{1e300, -1e300};
    const auto add = [&](double height) {
        range.least = std::min(range.least, height);
        range.most = std::max(range.most, height);
    };
    const auto along = [&](const Vec3& place) { return deformation.axis.dot(place - deformation.origin); };
    const auto height = [&](const Vec3& place) { return deformation.side.dot(place - deformation.origin); };
    for (const TriangleMesh::Triangle& triangle : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3& a = mesh.vertices[triangle[i]];
            const Vec3& b = mesh.vertices[triangle[(i + 1) % 3]];
            const double begin = along(a);
            const double way = along(b) - begin;
            // The piece of the edge between the planes: shares of it.
            double first = 0;
            double last = 1;
            if (way == 0) {
                if (begin < deformation.from || begin > deformation.to)
                    continue;
            } else {
                const double atFrom = (deformation.from - begin) / way;
                const double atTo = (deformation.to - begin) / way;
                first = std::max(first, std::min(atFrom, atTo));
                last = std::min(last, std::max(atFrom, atTo));
            }
            if (first > last)
                continue;
            add(height(a + first * (b - a)));
            add(height(a + last * (b - a)));
        }
    return range.isEmpty() ? HeightRange{} : range;
}

HeightRange heightsBetweenPlanes(const NumberDeformation& deformation, std::span<const TriangleMesh> meshes)
{
    HeightRange all;
    for (const TriangleMesh& mesh : meshes) {
        const HeightRange own = heightsBetweenPlanes(deformation, mesh);
        if (all.isEmpty())
            all = own;
        else if (!own.isEmpty())
            all = {std::min(all.least, own.least), std::max(all.most, own.most)};
    }
    return all;
}

double neutralOfSheet(const NumberDeformation& deformation, const HeightRange& heights, double kFactor)
{
    const bool isMostInside = innerSign(deformation) > 0;
    const double inner = isMostInside ? heights.most : heights.least;
    const double outer = isMostInside ? heights.least : heights.most;
    return inner + kFactor * (outer - inner);
}

double smallestRadius(const NumberDeformation& deformation, const HeightRange& heights)
{
    if (heights.isEmpty())
        return 0;
    const double inner =
        innerSign(deformation) > 0 ? heights.most - deformation.neutral : deformation.neutral - heights.least;
    return std::max(0.0, inner);
}

double radiusOf(const NumberDeformation& deformation)
{
    return deformation.length() / std::abs(deformation.angle) / (deformation.eases ? steepestOfQuintic : 1);
}

std::optional<Message> foldOf(const NumberDeformation& deformation, const TriangleMesh& mesh)
{
    if (deformation.kind != NumberKind::bend || deformation.angle == 0)
        return std::nullopt;
    return foldOf(deformation, heightsBetweenPlanes(deformation, mesh));
}

std::optional<Message> foldOf(const NumberDeformation& deformation, const HeightRange& heights)
{
    if (deformation.kind != NumberKind::bend || deformation.angle == 0)
        return std::nullopt;
    const double smallest = smallestRadius(deformation, heights);
    const double radius = radiusOf(deformation);
    if (radius > smallest)
        return std::nullopt;
    return Message(
               "Deformation",
               "A bend of %1 mm radius would fold the material on its inner side, which reaches %2 mm from the "
               "neutral plane. The radius must be larger than that: take a smaller angle, planes farther apart, or a "
               "neutral plane nearer to the inner side.")
        .with(millimetersText(radius), millimetersText(smallest));
}

} // namespace knead
