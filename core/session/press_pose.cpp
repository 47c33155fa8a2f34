#include "core/session/press_pose.h"

#include "core/geometry/turn.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace knead {

namespace {

/// Turned the least so that `axis`, of length 1, lies along `wanted`.
Quaternion turned(const Quaternion& rotation, const Vec3& axis, const Vec3& wanted)
{
    return (turnOnto(axis, wanted) * rotation).normalized();
}

Quaternion facing(const ToolShape& shape, const Quaternion& rotation, const Vec3& normal)
{
    const auto alongNormal = [&](const Vec3& axis) {
        return turned(rotation, axis, axis.dot(normal) < 0 ? -normal : normal);
    };
    const Vec3 z = rotation * Vec3::UnitZ();
    switch (shape.kind) {
    case ToolKind::box: {
        Eigen::Index nearest = 0;
        (rotation.conjugate() * normal).cwiseAbs().maxCoeff(&nearest);
        return alongNormal(rotation * Vec3::Unit(nearest));
    }
    case ToolKind::plate:
        return alongNormal(z);
    case ToolKind::cylinder: {
        const double along = z.dot(normal);
        return std::abs(along) > std::numbers::sqrt2 / 2 ? alongNormal(z)
                                                         : turned(rotation, z, (z - along * normal).normalized());
    }
    case ToolKind::wedge:
        return turned(rotation, z, normal);
    default:
        return rotation;
    }
}

/// How far a tool reaches from its center against the normal [m].
double reachOf(const ToolShape& shape, const Quaternion& rotation, const Vec3& normal)
{
    const Vec3 n = rotation.conjugate() * normal;
    const Vec3 half = 0.5 * shape.size;
    switch (shape.kind) {
    case ToolKind::ball:
        return half.x();
    case ToolKind::cylinder:
        return half.x() * n.head<2>().norm() + half.z() * std::abs(n.z());
    case ToolKind::part: {
        double reach = 0;
        for (const Vec3& vertex : shape.part->mesh().vertices)
            reach = std::max(reach, -n.dot(vertex));
        return reach;
    }
    default:
        return half.dot(n.cwiseAbs());
    }
}

} // namespace

PressPoses pressPoses(const ToolShape& shape, const Quaternion& rotation, const Vec3& place, const Vec3& normal,
                      double gap)
{
    const Quaternion turned = facing(shape, rotation, normal);
    const double reach = reachOf(shape, turned, normal);
    return {{place + (reach + gap) * normal, turned}, {place - reach * normal, turned}};
}

SurfaceSpot surfaceSpot(std::span<const std::array<std::uint32_t, 3>> triangles, std::span<const float> points,
                        std::uint32_t triangle, const Vec3& place, double radius)
{
    const auto point = [&](std::uint32_t vertex) -> Vec3 {
        return Eigen::Map<const Eigen::Vector3f>(points.data() + std::size_t{3} * vertex).cast<double>();
    };
    const auto areaOf = [&](const std::array<std::uint32_t, 3>& corners) -> Vec3 {
        const Vec3 a = point(corners[0]);
        return (point(corners[1]) - a).cross(point(corners[2]) - a);
    };
    const Vec3 first = areaOf(triangles[triangle]);
    Vec3 sum = Vec3::Zero();
    Vec3 middles = Vec3::Zero();
    double size = 0;
    for (const auto& corners : triangles) {
        const Vec3 middle = (point(corners[0]) + point(corners[1]) + point(corners[2])) / 3;
        if ((middle - place).norm() > radius)
            continue;
        const Vec3 area = areaOf(corners);
        if (area.dot(first) <= 0)
            continue;
        sum += area;
        middles += area.norm() * middle;
        size += area.norm();
    }
    const Vec3 normal = sum.isZero(0) ? first : sum;
    return {place, normal.isZero(0) ? Vec3::UnitZ() : Vec3(normal.stableNormalized()),
            size > 0 ? Vec3(middles / size) : place};
}

double thumbForce(const Material& material, double radius)
{
    constexpr double depth = 1.0 / 3; // of the radius
    const double poisson = material.poissonRatio;
    const double elastic =
        4.0 / 3 * material.youngsModulus / (1 - poisson * poisson) * radius * radius * std::pow(depth, 1.5);
    if (!material.yields())
        return elastic;
    const double area = std::numbers::pi * radius * radius * depth * (2 - depth); // of the cap's rim
    return std::min(elastic, 2.8 * material.yieldStress * area);
}

} // namespace knead
