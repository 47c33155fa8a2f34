#include "core/deformation/number_map.h"
#include "core/message/message.h"
#include "ui/deforming/deform_handles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace knead {

namespace {

constexpr double frameMargin = 0.12;        // of a frame around the parts, of their size across
constexpr double leastFactor = 0.05;        // that a drag leaves
constexpr double nearestPlanes = 1e-3;      // to each other, of the size of the parts
constexpr int dragIterations = 12;          // of Gauss and Newton
constexpr double longestDragStep = 100;     // of the small steps, in one of these
constexpr double leastPixelsPerStep = 1e-3; // else the handle is seen from its end and stays

double& numberOf(NumberDeformation& deformation)
{
    switch (deformation.kind) {
    case NumberKind::bend:
    case NumberKind::twist:
        return deformation.angle;
    case NumberKind::shear:
        return deformation.shift;
    default:
        return deformation.factor;
    }
}

} // namespace

double DeformFrames::valueOf(DeformHandle handle) const
{
    NumberDeformation copy = deformation;
    return handle == DeformHandle::from ? copy.from : handle == DeformHandle::to ? copy.to : numberOf(copy);
}

DeformFrames DeformFrames::with(DeformHandle handle, double value) const
{
    const double gap = nearestPlanes * box.diagonal().norm();
    DeformFrames next = *this;
    NumberDeformation& d = next.deformation;
    if (handle == DeformHandle::from)
        d.from = std::min(value, d.to - gap);
    else if (handle == DeformHandle::to)
        d.to = std::max(value, d.from + gap);
    else if (&numberOf(d) == &d.factor)
        d.factor = std::max(value, leastFactor);
    else
        numberOf(d) = value;
    return next;
}

Quantity DeformFrames::quantityOf(DeformHandle handle) const
{
    if (handle != DeformHandle::value || deformation.kind == NumberKind::shear)
        return Quantity::Length;
    const bool turns = deformation.kind == NumberKind::bend || deformation.kind == NumberKind::twist;
    return turns ? Quantity::Angle : Quantity::Number;
}

double DeformFrames::halfAlong(const Vec3& direction) const
{
    return direction.cwiseAbs().dot(box.sizes()) / 2 + frameMargin * box.diagonal().norm() / 2;
}

double DeformFrames::stepOf(DeformHandle handle) const
{
    return quantityOf(handle) == Quantity::Length ? 1e-3 * box.diagonal().norm() : 1e-3;
}

std::array<Vec3, 4> DeformFrames::cornersOf(DeformHandle plane) const
{
    const NumberDeformation& d = deformation;
    const Vec3 middle = d.origin + valueOf(plane) * d.axis;
    const Vec3 side = halfAlong(d.side) * d.side;
    const Vec3 way = halfAlong(across()) * across();
    return {middle + side + way, middle + side - way, middle - side - way, middle - side + way};
}

Vec3 DeformFrames::placeOf(DeformHandle handle) const
{
    const NumberDeformation& d = deformation;
    if (handle != DeformHandle::value)
        return d.origin + valueOf(handle) * d.axis + halfAlong(d.side) * d.side;
    Vec3 place = d.origin + (d.stays > 0.5 ? d.from : d.to) * d.axis;
    if (d.kind == NumberKind::bend)
        place += d.neutral * d.side;
    else if (d.kind != NumberKind::shear)
        place += halfAlong(across()) * across();
    try {
        return numberMap(d)->at(place);
    } catch (const Problem&) { // what is typed makes no map
        return place;
    }
}

double DeformFrames::draggedTo(DeformHandle handle, const Pixel& pixel, const Camera& camera,
                               const WindowSize& window) const
{
    const double step = stepOf(handle);
    double value = valueOf(handle);
    for (int i = 0; i < dragIterations; ++i) {
        const auto seen = [&](double at) { return camera.project(with(handle, at).placeOf(handle), window); };
        const auto here = seen(value);
        const auto next = seen(value + step);
        const auto last = seen(value - step);
        if (!here || !next || !last)
            break;
        const Eigen::Vector2d slope((next->x - last->x) / 2, (next->y - last->y) / 2); // [pixels per step]
        if (slope.norm() < leastPixelsPerStep)
            break;
        const Eigen::Vector2d missing(pixel.x - here->x, pixel.y - here->y);
        const double steps = std::clamp(missing.dot(slope) / slope.squaredNorm(), -longestDragStep, longestDragStep);
        value = with(handle, value + steps * step).valueOf(handle);
    }
    return value;
}

double snapped(double value, Quantity quantity)
{
    constexpr double angleStep = 5 * std::numbers::pi / 180;
    const double step = quantity == Quantity::Angle ? angleStep : quantity == Quantity::Length ? 1e-3 : 0.05;
    return step * std::round(value / step);
}

} // namespace knead
