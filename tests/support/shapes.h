#pragma once

#include "core/geometry/triangle_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

/// Closed meshes with known volumes for tests and benchmarks. All are welded and face outwards.
namespace knead::shapes {

inline TriangleMesh moved(TriangleMesh mesh, const Pose& pose)
{
    for (Vec3& vertex : mesh.vertices)
        vertex = pose.toWorld(vertex);
    return mesh;
}

/// About a generic axis, so that nothing lines up with a lattice.
inline Pose tilt(double angle, const Vec3& position = Vec3::Zero())
{
    return {position, Quaternion(Eigen::AngleAxisd(angle, Vec3(0.3, 1, 0.5).normalized()))};
}

inline Quaternion about(double degrees, const Vec3& axis)
{
    return Quaternion(Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis.normalized()));
}

/// The union of meshes that do not touch; face numbers go on counting.
inline TriangleMesh together(TriangleMesh mesh, const TriangleMesh& other)
{
    const auto firstVertex = static_cast<std::uint32_t>(mesh.vertices.size());
    std::uint32_t firstFace = 0;
    for (const std::uint32_t face : mesh.faceOfTriangle)
        firstFace = std::max(firstFace, face + 1);
    mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const TriangleMesh::Triangle& t : other.triangles)
        mesh.triangles.push_back({t[0] + firstVertex, t[1] + firstVertex, t[2] + firstVertex});
    for (const std::uint32_t face : other.faceOfTriangle)
        mesh.faceOfTriangle.push_back(face + firstFace);
    return mesh;
}

inline TriangleMesh insideOut(TriangleMesh mesh)
{
    for (TriangleMesh::Triangle& triangle : mesh.triangles)
        std::swap(triangle[1], triangle[2]);
    return mesh;
}

/// Sides along the axes, centered at the origin. Faces 0..5 are -x, +x, -y, +y, -z, +z.
inline TriangleMesh box(const Vec3& size)
{
    TriangleMesh mesh;
    for (int i = 0; i < 8; ++i)
        mesh.vertices.push_back(0.5 * size.cwiseProduct(Vec3((i & 1) * 2 - 1, (i & 2) - 1, (i & 4) / 2 - 1)));
    const std::uint32_t quads[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                       {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    for (std::uint32_t face = 0; face < 6; ++face) {
        const auto& q = quads[face];
        mesh.triangles.push_back({q[0], q[1], q[2]});
        mesh.triangles.push_back({q[0], q[2], q[3]});
        mesh.faceOfTriangle.insert(mesh.faceOfTriangle.end(), {face, face});
    }
    return mesh;
}

/// A box with a box-shaped void in its middle; the faces of the void are 6..11.
inline TriangleMesh hollowBox(const Vec3& size, const Vec3& voidSize)
{
    return together(box(size), insideOut(box(voidSize)));
}

/// A grid of (columns x rows) points closed in both directions, joined by triangles.
template <typename Place>
TriangleMesh closedGrid(std::uint32_t columns, std::uint32_t rows, Place&& place)
{
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i < columns; ++i)
        for (std::uint32_t j = 0; j < rows; ++j)
            mesh.vertices.push_back(place(2 * std::numbers::pi * i / columns, 2 * std::numbers::pi * j / rows));
    const auto at = [&](std::uint32_t i, std::uint32_t j) { return i % columns * rows + j % rows; };
    for (std::uint32_t i = 0; i < columns; ++i)
        for (std::uint32_t j = 0; j < rows; ++j) {
            mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    return mesh;
}

/// About the z axis; `radius` to the middle of the tube.
inline TriangleMesh torus(double radius, double tubeRadius, std::uint32_t around, std::uint32_t aroundTube)
{
    return closedGrid(around, aroundTube, [&](double a, double b) {
        const double r = radius + tubeRadius * std::cos(b);
        return Vec3(r * std::cos(a), r * std::sin(a), tubeRadius * std::sin(b));
    });
}

/// A surface of revolution about z through the points (radius, height) of an open profile that ascends; both ends are
/// closed by a point on the axis. Faces: 0 bottom, 1 side, 2 top.
template <typename Profile>
TriangleMesh revolution(std::uint32_t around, std::uint32_t rings, Profile&& profile)
{
    TriangleMesh mesh;
    for (std::uint32_t ring = 0; ring < rings; ++ring)
        for (std::uint32_t i = 0; i < around; ++i) {
            const auto [radius, height] = profile(ring);
            const double angle = 2 * std::numbers::pi * i / around;
            mesh.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), height);
        }
    const auto addTip = [&](double height) {
        mesh.vertices.emplace_back(0, 0, height);
        return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
    };
    const auto [bottom, top] = profile.tips();
    const std::uint32_t low = addTip(bottom);
    const std::uint32_t high = addTip(top);
    const auto add = [&](const TriangleMesh::Triangle& triangle, std::uint32_t face) {
        mesh.triangles.push_back(triangle);
        mesh.faceOfTriangle.push_back(face);
    };
    for (std::uint32_t i = 0; i < around; ++i) {
        const std::uint32_t j = (i + 1) % around;
        add({low, j, i}, 0);
        for (std::uint32_t ring = 0; ring + 1 < rings; ++ring) {
            const std::uint32_t below = ring * around;
            const std::uint32_t above = below + around;
            add({below + i, below + j, above + j}, 1);
            add({below + i, above + j, above + i}, 1);
        }
        add({high, (rings - 1) * around + i, (rings - 1) * around + j}, 2);
    }
    return mesh;
}

/// Along z, centered at the origin.
inline TriangleMesh cylinder(double radius, double length, std::uint32_t around)
{
    struct Profile {
        double radius;
        double length;
        std::pair<double, double> operator()(std::uint32_t ring) const { return {radius, (ring - 0.5) * length}; }
        std::pair<double, double> tips() const { return {-length / 2, length / 2}; }
    };
    return revolution(around, 2, Profile{radius, length});
}

inline TriangleMesh sphere(double radius, std::uint32_t around)
{
    struct Profile {
        double radius;
        std::uint32_t rings;
        std::pair<double, double> operator()(std::uint32_t ring) const
        {
            const double angle = std::numbers::pi * (ring + 1) / (rings + 1) - std::numbers::pi / 2;
            return {radius * std::cos(angle), radius * std::sin(angle)};
        }
        std::pair<double, double> tips() const { return {-radius, radius}; }
    };
    return revolution(around, around / 2, Profile{radius, around / 2});
}

/// A prism over a simple polygon that is star-shaped seen from its first corner, in the x-y plane, counter-clockwise;
/// z from 0 to height. Faces: 0 bottom, 1 top, 2.. the sides in the order of the corners.
inline TriangleMesh prism(const std::vector<Eigen::Vector2d>& corners, double height)
{
    TriangleMesh mesh;
    const auto n = static_cast<std::uint32_t>(corners.size());
    for (const double z : {0.0, height})
        for (const Eigen::Vector2d& corner : corners)
            mesh.vertices.emplace_back(corner.x(), corner.y(), z);
    const auto add = [&](const TriangleMesh::Triangle& triangle, std::uint32_t face) {
        mesh.triangles.push_back(triangle);
        mesh.faceOfTriangle.push_back(face);
    };
    for (std::uint32_t i = 1; i + 1 < n; ++i) {
        add({0, i + 1, i}, 0);
        add({n, n + i, n + i + 1}, 1);
    }
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t j = (i + 1) % n;
        add({i, j, n + j}, 2 + i);
        add({i, n + j, n + i}, 2 + i);
    }
    return mesh;
}

/// An L of two legs of equal length; its inner corner is the first corner of the polygon.
inline TriangleMesh bracket(double leg, double thickness, double height)
{
    return prism({{thickness, thickness}, {thickness, leg}, {0, leg}, {0, 0}, {leg, 0}, {leg, thickness}}, height);
}

/// Two prongs along y with a slot between them, joined by a base below y = `base`; the slot is open at y = `length`.
/// A box in x 0..width, y 0..length, z 0..height without the slot.
inline TriangleMesh fork(double width, double length, double height, double base, double slot)
{
    const double left = (width - slot) / 2;
    const double right = (width + slot) / 2;
    TriangleMesh mesh;
    const std::vector<Eigen::Vector2d> corners{{0, 0},        {left, 0},       {right, 0},      {width, 0},
                                               {width, base}, {width, length}, {right, length}, {right, base},
                                               {left, base},  {left, length},  {0, length},     {0, base}};
    const std::uint32_t n = 12; // not star-shaped, so its triangles are listed below
    for (const double z : {0.0, height})
        for (const Eigen::Vector2d& corner : corners)
            mesh.vertices.emplace_back(corner.x(), corner.y(), z);
    const std::uint32_t quads[5][4] = {{0, 1, 8, 11}, {1, 2, 7, 8}, {2, 3, 4, 7}, {7, 4, 5, 6}, {11, 8, 9, 10}};
    for (const auto& q : quads) {
        mesh.triangles.push_back({q[0], q[2], q[1]});
        mesh.triangles.push_back({q[0], q[3], q[2]});
        mesh.triangles.push_back({q[0] + n, q[1] + n, q[2] + n});
        mesh.triangles.push_back({q[0] + n, q[2] + n, q[3] + n});
    }
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t j = (i + 1) % n;
        mesh.triangles.push_back({i, j, n + j});
        mesh.triangles.push_back({i, n + j, n + i});
    }
    return mesh;
}

} // namespace knead::shapes
