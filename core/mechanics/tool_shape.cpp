#include "core/mechanics/tool_shape.h"

#include "core/message/message.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace knead {

namespace {

using Vec2 = Eigen::Vector2d;

/// Signed distance in a plane and where it grows.
struct PlanePoint {
    double distance;
    Vec2 normal;
};

/// Joins a distance across an axis with one along it: a prism over a plane figure, cut off at `beyond` = 0.
/// @param across distance in the plane of the figure @param beyond how far past the nearer end
SurfacePoint prism(const PlanePoint& across, double beyond, double end, const std::array<Eigen::Index, 3>& axes)
{
    const auto place = [&](double u, double v, double w) {
        Vec3 normal;
        normal[axes[0]] = u;
        normal[axes[1]] = v;
        normal[axes[2]] = w;
        return normal;
    };
    if (beyond <= 0 && across.distance >= beyond)
        return {across.distance, place(across.normal.x(), across.normal.y(), 0)};
    if (across.distance <= 0)
        return {beyond, place(0, 0, end)};
    const double distance = std::sqrt(across.distance * across.distance + beyond * beyond);
    const double sideways = across.distance / distance;
    return {distance, place(sideways * across.normal.x(), sideways * across.normal.y(), beyond / distance * end)};
}

PlanePoint circle(double radius, const Vec2& point)
{
    const double length = point.norm();
    return {length - radius, length > 0 ? Vec2(point / length) : Vec2::UnitX()};
}

/// A triangle with its tip down: corners (0, -h), (b, h), (-b, h). One half of it, mirrored.
PlanePoint triangle(double halfBack, double halfHeight, const Vec2& point)
{
    const double side = point.x() < 0 ? -1 : 1;
    const Vec2 own(std::abs(point.x()), point.y());
    const Vec2 tip(0, -halfHeight);
    const Vec2 edge(halfBack, 2 * halfHeight); // from the tip to the back
    const double length = edge.norm();
    const Vec2 outward(edge.y() / length, -edge.x() / length);
    const double beyond = (own - tip).dot(outward);
    const double behind = own.y() - halfHeight;
    if (beyond <= 0 && behind <= 0)
        return beyond > behind ? PlanePoint{beyond, {side * outward.x(), outward.y()}}
                               : PlanePoint{behind, Vec2::UnitY()};
    const double part = std::clamp((own - tip).dot(edge) / (length * length), 0.0, 1.0);
    const Vec2 fromEdge = own - (tip + part * edge);
    const Vec2 fromBack(std::max(own.x() - halfBack, 0.0), behind);
    const Vec2& from = fromBack.squaredNorm() < fromEdge.squaredNorm() ? fromBack : fromEdge;
    const double distance = from.norm();
    if (distance == 0) // rounding leads onto it
        return {0, {side * outward.x(), outward.y()}};
    return {distance, {side * from.x() / distance, from.y() / distance}};
}

SurfacePoint ball(double radius, const Vec3& point)
{
    const double length = point.norm();
    return {length - radius, length > 0 ? Vec3(point / length) : Vec3::UnitZ()};
}

double signOf(double value)
{
    return value < 0 ? -1 : 1;
}

/// Turns a profile (radius, height), from the axis to the axis, about z.
TriangleMesh turned(const std::vector<Vec2>& profile)
{
    constexpr std::uint32_t sides = 64;
    TriangleMesh mesh;
    const auto rings = static_cast<std::uint32_t>(profile.size() - 2);
    for (std::uint32_t ring = 0; ring < rings; ++ring)
        for (std::uint32_t i = 0; i < sides; ++i) {
            const double angle = 2 * std::numbers::pi * i / sides;
            const Vec2& p = profile[ring + 1];
            mesh.vertices.emplace_back(p.x() * std::cos(angle), p.x() * std::sin(angle), p.y());
        }
    const auto low = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.emplace_back(0, 0, profile.front().y());
    mesh.vertices.emplace_back(0, 0, profile.back().y());
    for (std::uint32_t i = 0; i < sides; ++i) {
        const std::uint32_t j = (i + 1) % sides;
        mesh.triangles.push_back({low, j, i});
        for (std::uint32_t ring = 0; ring + 1 < rings; ++ring) {
            const std::uint32_t below = ring * sides;
            mesh.triangles.push_back({below + i, below + j, below + sides + j});
            mesh.triangles.push_back({below + i, below + sides + j, below + sides + i});
        }
        const std::uint32_t top = (rings - 1) * sides;
        mesh.triangles.push_back({low + 1, top + i, top + j});
    }
    return mesh;
}

TriangleMesh ballMesh(double radius)
{
    constexpr int rings = 32;
    std::vector<Vec2> profile;
    for (int i = 0; i <= rings; ++i) {
        const double angle = std::numbers::pi * i / rings;
        profile.emplace_back(radius * std::sin(angle), -radius * std::cos(angle));
    }
    return turned(profile);
}

TriangleMesh wedgeMesh(const Vec3& size)
{
    const Vec3 h = size / 2;
    TriangleMesh mesh;
    mesh.vertices = {{-h.x(), 0, -h.z()}, {-h.x(), h.y(), h.z()}, {-h.x(), -h.y(), h.z()},
                     {h.x(), 0, -h.z()},  {h.x(), h.y(), h.z()},  {h.x(), -h.y(), h.z()}};
    mesh.triangles = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
    return mesh;
}

TriangleMesh boxMesh(const Vec3& size)
{
    TriangleMesh mesh;
    for (int i = 0; i < 8; ++i)
        mesh.vertices.push_back(0.5 * size.cwiseProduct(Vec3((i & 1) * 2 - 1, (i & 2) - 1, (i & 4) / 2 - 1)));
    mesh.triangles = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
    return mesh;
}

Box boxOf(const TriangleMesh& mesh)
{
    if (mesh.empty())
        throw Problem(Message("Tool", "The tool's part has no surface. Choose another file."));
    Box box;
    for (const Vec3& vertex : mesh.vertices)
        box.extend(vertex);
    return box;
}

TriangleMesh centered(TriangleMesh mesh)
{
    const Vec3 center = boxOf(mesh).center();
    for (Vec3& vertex : mesh.vertices)
        vertex -= center;
    return mesh;
}

} // namespace

std::string_view nameOf(ToolKind kind)
{
    switch (kind) {
    case ToolKind::box:
        return "box";
    case ToolKind::ball:
        return "ball";
    case ToolKind::cylinder:
        return "cylinder";
    case ToolKind::wedge:
        return "wedge";
    case ToolKind::plate:
        return "plate";
    case ToolKind::part:
        return "part";
    }
    return "";
}

ToolPart::ToolPart(TriangleMesh mesh)
    : m_mesh(centered(mesh))
    , m_center(boxOf(mesh).center())
    , m_size(boxOf(mesh).sizes())
    , m_distance(m_mesh)
{
}

ToolPart::ToolPart(TriangleMesh centered, const Vec3& center, const Vec3& size)
    : m_mesh(std::move(centered))
    , m_center(center)
    , m_size(size)
    , m_distance(m_mesh)
{
}

SurfacePoint ToolPart::nearest(const Vec3& point) const
{
    const SurfaceDistance::Hit hit = m_distance.nearest(point);
    if (hit.distance > 1e-9 * m_size.norm())
        return {hit.signedDistance, (point - hit.point) / hit.signedDistance};
    const TriangleMesh::Triangle& t = m_mesh.triangles[hit.triangle];
    const Vec3& a = m_mesh.vertices[t[0]];
    return {hit.signedDistance, (m_mesh.vertices[t[1]] - a).cross(m_mesh.vertices[t[2]] - a).normalized()};
}

SurfacePoint surfaceOf(const ToolShape& shape, const Vec3& point)
{
    const Vec3 half = shape.size / 2;
    switch (shape.kind) {
    case ToolKind::ball:
        return ball(half.x(), point);
    case ToolKind::cylinder:
        return prism(circle(half.x(), point.head<2>()), std::abs(point.z()) - half.z(), signOf(point.z()), {0, 1, 2});
    case ToolKind::wedge:
        return prism(triangle(half.y(), half.z(), point.tail<2>()), std::abs(point.x()) - half.x(), signOf(point.x()),
                     {1, 2, 0});
    case ToolKind::part:
        if (shape.part)
            return shape.part->nearest(point);
        break;
    case ToolKind::box:
    case ToolKind::plate:
        break;
    }
    return boxSurface(shape.size, point);
}

TriangleMesh meshOf(const ToolShape& shape)
{
    const double radius = shape.size.x() / 2;
    const double top = shape.size.z() / 2;
    switch (shape.kind) {
    case ToolKind::ball:
        return ballMesh(radius);
    case ToolKind::cylinder:
        return turned({{0, -top}, {radius, -top}, {radius, top}, {0, top}});
    case ToolKind::wedge:
        return wedgeMesh(shape.size);
    case ToolKind::part:
        if (shape.part)
            return shape.part->mesh();
        break;
    case ToolKind::box:
    case ToolKind::plate:
        break;
    }
    return boxMesh(shape.size);
}

Vec3 fittingSize(ToolKind kind, const Vec3& size, const ToolPart* part)
{
    switch (kind) {
    case ToolKind::ball:
        return Vec3::Constant(size.x());
    case ToolKind::cylinder:
        return {size.x(), size.x(), size.z()};
    case ToolKind::part:
        return part != nullptr ? part->size() : size;
    case ToolKind::box:
    case ToolKind::wedge:
    case ToolKind::plate:
        break;
    }
    return size;
}

SurfacePoint boxSurface(const Vec3& size, const Vec3& point)
{
    const Vec3 beyond = point.cwiseAbs() - 0.5 * size;
    Eigen::Index axis = 0;
    const double largest = beyond.maxCoeff(&axis);
    if (largest <= 0) {
        Vec3 normal = Vec3::Zero();
        normal[axis] = signOf(point[axis]);
        return {largest, normal};
    }
    const Vec3 outside = beyond.cwiseMax(0.0);
    const double distance = outside.norm();
    Vec3 normal = outside / distance;
    for (Eigen::Index i = 0; i < 3; ++i)
        normal[i] *= signOf(point[i]);
    return {distance, normal};
}

} // namespace knead
