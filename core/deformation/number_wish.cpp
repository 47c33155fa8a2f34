#include "core/deformation/number_wish.h"

#include "core/message/message.h"

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

struct Extent {
    double least = 0;
    double most = 0;
};

/// Of places along a direction from an origin [m].
Extent extentAlong(const Vec3& direction, const Vec3& origin, std::span<const Vec3> places)
{
    Extent extent{direction.dot(places.front() - origin), direction.dot(places.front() - origin)};
    for (const Vec3& place : places) {
        const double along = direction.dot(place - origin);
        extent = {std::min(extent.least, along), std::max(extent.most, along)};
    }
    return extent;
}

Vec3 longestSideOf(const Box& box)
{
    Eigen::Index axis = 0;
    box.sizes().maxCoeff(&axis);
    return Vec3::Unit(axis);
}

Vec3 unitOf(const Vec3& direction)
{
    const double length = direction.norm();
    if (!std::isfinite(length) || length < 1e-12)
        throw Problem(Message("Deformation", "A direction of no length is none; give x, y, z, or three numbers."));
    return direction / length;
}

/// The part of it across the axis.
Vec3 sideAcross(const Vec3& side, const Vec3& axis)
{
    const Vec3 unit = unitOf(side);
    const Vec3 across = unit - unit.dot(axis) * axis;
    if (across.norm() < 1e-6)
        throw Problem(
            Message("Deformation", "The side runs along the axis, but must lie across it; choose another one."));
    return across.normalized();
}

Vec3 usualSide(const Vec3& axis)
{
    constexpr double steep = 0.9;
    return sideAcross(std::abs(axis.z()) > steep ? Vec3::UnitX() : Vec3::UnitZ(), axis);
}

/// Toward the side it bends to, a positive angle, lies the inside of the arc.
double neutralOf(double kFactor, double angle, const Extent& thickness)
{
    const double depth = kFactor * (thickness.most - thickness.least);
    return angle >= 0 ? thickness.most - depth : thickness.least + depth;
}

void setAmount(const NumberWish& wish, NumberDeformation& deformation)
{
    switch (wish.kind) {
    case NumberKind::bend:
    case NumberKind::twist:
        deformation.angle = wish.amount;
        break;
    case NumberKind::taper:
    case NumberKind::stretch:
    case NumberKind::scale:
        deformation.factor = wish.amount;
        break;
    case NumberKind::shear:
        deformation.shift = wish.amount;
        break;
    }
}

void refuseContradictions(const NumberWish& wish)
{
    if (wish.kind != NumberKind::bend && (wish.radius || wish.neutral || wish.kFactor))
        throw Problem(
            Message("Deformation", "Only a bend has a radius and a plane that keeps its length; leave them out."));
    if (wish.neutral && wish.kFactor)
        throw Problem(Message("Deformation", "The plane that keeps its length is given twice, by its place and by a k "
                                             "factor; leave one of them out."));
    if (wish.kFactor && !(*wish.kFactor >= 0 && *wish.kFactor <= 1))
        throw Problem(Message("Deformation", "A k factor is between 0, inside, and 1, outside."));
    if (wish.radius && wish.to)
        throw Problem(Message("Deformation", "Angle and radius say where the bend ends; leave out the second plane."));
    if (wish.radius && !(*wish.radius > 0))
        throw Problem(Message("Deformation", "The radius of a bend must be larger than 0."));
}

} // namespace

NumberDeformation numberDeformation(const NumberWish& wish, std::span<const Vec3> places)
{
    refuseContradictions(wish);
    const Box box = boxOfPlaces(places);
    NumberDeformation result{.kind = wish.kind, .stays = wish.stays, .eases = wish.eases};
    setAmount(wish, result);
    result.axis = wish.axis ? unitOf(*wish.axis) : longestSideOf(box);
    result.side = wish.side ? sideAcross(*wish.side, result.axis) : usualSide(result.axis);
    result.origin = wish.origin.value_or(box.center() - result.axis.dot(box.center()) * result.axis);
    const Extent length = extentAlong(result.axis, result.origin, places);
    result.from = wish.from.value_or(length.least);
    result.to = wish.radius ? result.from + std::abs(wish.amount) * *wish.radius : wish.to.value_or(length.most);
    result.neutral = wish.neutral.value_or(0);
    if (wish.kFactor)
        result.neutral = neutralOf(*wish.kFactor, wish.amount, extentAlong(result.side, result.origin, places));
    return result;
}

} // namespace knead
