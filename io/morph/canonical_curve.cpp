#include "io/morph/canonical_curve.h"

#include "io/morph/millimetre_map.h"

#include <Geom_Circle.hxx>
#include <Geom_Line.hxx>
#include <Precision.hxx>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace knead {

namespace {

constexpr double largestArcRadius = 1e4; // in chords
constexpr double fullCircle = 2 * std::numbers::pi;

gp_Dir directionOf(const Vec3& v)
{
    return {v.x(), v.y(), v.z()};
}

std::optional<CanonicalCurve> withinTolerance(CanonicalCurve found, const std::vector<Vec3>& places, double tolerance)
{
    const auto count = static_cast<double>(places.size() - 1);
    for (std::size_t i = 0; i < places.size(); ++i) {
        const double at = found.first + (found.last - found.first) * static_cast<double>(i) / count;
        found.error = std::max(found.error, (toVec3(found.curve->Value(at).XYZ()) - places[i]).norm());
    }
    return found.error <= tolerance ? std::optional(found) : std::nullopt;
}

std::optional<CanonicalCurve> lineThrough(const std::vector<Vec3>& places, double tolerance)
{
    const Vec3 way = places.back() - places.front();
    if (!(way.norm() > Precision::Confusion()))
        return std::nullopt;
    return withinTolerance({new Geom_Line(toPoint(places.front()), directionOf(way)), 0, way.norm(), 0}, places,
                           tolerance);
}

/// Through the first, the middle and the last place, or, where these two are one, through places a third of the way on.
std::optional<CanonicalCurve> circleThrough(const std::vector<Vec3>& places, double tolerance)
{
    const std::size_t last = places.size() - 1;
    const bool isClosed = (places.back() - places.front()).norm() <= tolerance;
    const Vec3& a = places.front();
    const Vec3& b = places[isClosed ? last / 3 : last / 2];
    const Vec3& c = places[isClosed ? 2 * last / 3 : last];
    const Vec3 ab = b - a;
    const Vec3 ac = c - a;
    const Vec3 normal = ab.cross(ac);
    const double square = normal.squaredNorm();
    if (!(square > std::pow(std::max(ab.norm(), ac.norm()), 4) / (largestArcRadius * largestArcRadius)))
        return std::nullopt;
    const Vec3 toMiddle = (ac.squaredNorm() * normal.cross(ab) + ab.squaredNorm() * ac.cross(normal)) / (2 * square);
    const Vec3 middle = a + toMiddle;
    const Vec3 out = -toMiddle.normalized();
    const Vec3 along = normal.normalized().cross(out);
    double turned = std::atan2(along.dot(c - middle), out.dot(c - middle));
    turned += turned <= 0 ? fullCircle : 0;
    const gp_Ax2 frame(toPoint(middle), directionOf(normal), directionOf(out));
    return withinTolerance({new Geom_Circle(frame, toMiddle.norm()), 0, isClosed ? fullCircle : turned, 0}, places,
                           tolerance);
}

} // namespace

std::optional<CanonicalCurve> canonicalCurve(const std::vector<Vec3>& places, double tolerance)
{
    assert(places.size() >= 5);
    if (auto line = lineThrough(places, tolerance))
        return line;
    return circleThrough(places, tolerance);
}

} // namespace knead
