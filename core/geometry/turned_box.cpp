#include "core/geometry/turned_box.h"

#include <cmath>

namespace knead {

namespace {

using Place = Eigen::Vector3f;
using PlacedTriangle = std::array<Place, 3>;

/// Axes for points near a plane: across it, and in it along the side in which they spread most.
Eigen::Matrix3f axesOf(std::span<const Place> points, const Place& across)
{
    const float length = across.norm();
    if (!(length > std::numeric_limits<float>::min()))
        return Eigen::Matrix3f::Identity();
    const Place normal = across / length;
    const Place first = normal.unitOrthogonal();
    const Place second = normal.cross(first);
    float x = 0, y = 0, xx = 0, yy = 0, xy = 0; // sums over the points, in the plane
    for (const Place& point : points) {
        const Place from = point - points.front();
        const float u = first.dot(from);
        const float v = second.dot(from);
        x += u;
        y += v;
        xx += u * u;
        yy += v * v;
        xy += u * v;
    }
    const auto count = static_cast<float>(points.size());
    const float difference = (xx - x * x / count) - (yy - y * y / count);
    const float mixed = 2 * (xy - x * y / count);
    const float size = std::hypot(difference, mixed);
    Place along = difference > 0 ? Place((difference + size) * first + mixed * second)
                                 : Place(mixed * first + (size - difference) * second);
    along = along.squaredNorm() > 0 ? along.normalized() : first;
    Eigen::Matrix3f axes;
    axes << normal, along, normal.cross(along);
    return axes;
}

/// Half of it.
float area(const Eigen::AlignedBox3f& box)
{
    const Place sides = box.sizes();
    return sides.x() * sides.y() + sides.y() * sides.z() + sides.z() * sides.x();
}

/// The smallest box with given axes around some points that have a given upright box around them, or that upright box
/// when it is smaller: a closed surface has no plane.
TurnedBox boxAround(std::span<const Place> points, const Eigen::Matrix3f& axes, const Eigen::AlignedBox3f& upright)
{
    Eigen::AlignedBox3f sides;
    for (const Place& point : points)
        sides.extend(Place(axes.transpose() * point));
    if (area(sides) < area(upright))
        return {axes * sides.center(), axes, sides.sizes() / 2, upright};
    return {upright.center(), Eigen::Matrix3f::Identity(), upright.sizes() / 2, upright};
}

} // namespace

TurnedBox boxAround(std::span<const PlacedTriangle> triangles)
{
    if (triangles.empty())
        return {};
    Place across = Place::Zero();
    for (const PlacedTriangle& t : triangles)
        across += (t[1] - t[0]).cross(t[2] - t[0]);
    const std::span<const Place> points(triangles.front().data(), 3 * triangles.size());
    Eigen::AlignedBox3f upright;
    for (const Place& point : points)
        upright.extend(point);
    return boxAround(points, axesOf(points, across), upright);
}

TurnedBox boxAround(const std::array<TurnedBox, 4>& boxes)
{
    std::array<Place, 32> corners;
    std::size_t count = 0;
    Place across = Place::Zero();
    Eigen::AlignedBox3f upright;
    for (const TurnedBox& box : boxes) {
        if (box.isEmpty())
            continue;
        upright.extend(box.upright);
        across += box.half.y() * box.half.z() * box.axes.col(0);
        for (unsigned corner = 0; corner < 8; ++corner) {
            const Place sides((corner & 1U) != 0 ? 1.0F : -1.0F, (corner & 2U) != 0 ? 1.0F : -1.0F,
                              (corner & 4U) != 0 ? 1.0F : -1.0F);
            corners[count++] = box.center + box.axes * box.half.cwiseProduct(sides);
        }
    }
    if (count == 0)
        return {};
    const std::span<const Place> points(corners.data(), count);
    return boxAround(points, axesOf(points, across), upright);
}

} // namespace knead
