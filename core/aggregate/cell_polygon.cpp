#include "core/aggregate/cell_polygon.h"

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

/// Kept between its ends in every coordinate in spite of rounding, so that polygons stay convex along each axis and a
/// cut adds one corner at most.
Vec3 crossing(const Vec3& here, const Vec3& next, double part, int axis, double plane)
{
    Vec3 point = (here + part * (next - here)).cwiseMax(here.cwiseMin(next)).cwiseMin(here.cwiseMax(next));
    point[axis] = plane;
    return point;
}

/// Keeps what lies where side * (coordinate - plane) >= 0.
CellPolygon half(PolygonView polygon, int axis, double plane, double side)
{
    CellPolygon result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3& here = polygon[i];
        const Vec3& next = polygon[i + 1 == polygon.size() ? 0 : i + 1];
        const double fromHere = side * (here[axis] - plane);
        const double fromNext = side * (next[axis] - plane);
        if (fromHere >= 0)
            result.add(here);
        if ((fromHere > 0 && fromNext < 0) || (fromHere < 0 && fromNext > 0)) {
            result.add(crossing(here, next, fromHere / (fromHere - fromNext), axis, plane));
        }
    }
    return result;
}

} // namespace

CellPolygon halfBelow(PolygonView polygon, int axis, double plane)
{
    return half(polygon, axis, plane, -1);
}

CellPolygon halfAbove(PolygonView polygon, int axis, double plane)
{
    return half(polygon, axis, plane, 1);
}

CellRange cellRange(PolygonView polygon, int axis, std::int32_t count)
{
    double low = polygon[0][axis];
    double high = low;
    for (const Vec3& corner : polygon.subspan(1)) {
        low = std::min(low, corner[axis]);
        high = std::max(high, corner[axis]);
    }
    const double outermost = count - 1;
    const double first = std::clamp(std::floor(low), 0.0, outermost);
    const double last = std::clamp(std::ceil(high) - 1, first, outermost);
    return {static_cast<std::int32_t>(first), static_cast<std::int32_t>(last)};
}

CellPolygon clipToCell(PolygonView polygon, int axis, std::int32_t cell, const CellRange& range)
{
    CellPolygon result;
    if (cell > range.first)
        result = halfAbove(polygon, axis, cell);
    else
        for (const Vec3& corner : polygon)
            result.add(corner);
    return cell < range.last ? halfBelow(result.span(), axis, cell + 1) : result;
}

PolygonProjection project(PolygonView polygon, double base)
{
    PolygonProjection sum;
    const Vec3& a = polygon[0];
    for (std::size_t i = 2; i < polygon.size(); ++i) {
        const Vec3& b = polygon[i - 1];
        const Vec3& c = polygon[i];
        const double area = 0.5 * ((b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x()));
        sum.area += area;
        sum.areaTimesHeight += area * ((a.z() - base) + (b.z() - base) + (c.z() - base)) / 3;
    }
    return sum;
}

} // namespace knead
