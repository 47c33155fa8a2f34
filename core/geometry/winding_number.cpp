#include "core/geometry/winding_number.h"

#include "core/geometry/triangle_tree.h"
#include "core/task/parallel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace knead {

namespace {

constexpr std::size_t trianglesPerLeaf = 6; // at most
constexpr double farShare = 3;              // farther than so many radii, triangles count together

/// The solid angle of a triangle, halved; positive seen from behind it.
double halfSolidAngle(const std::array<Vec3, 3>& corners, const Vec3& point)
{
    const Vec3 a = corners[0] - point;
    const Vec3 b = corners[1] - point;
    const Vec3 c = corners[2] - point;
    const double la = a.norm();
    const double lb = b.norm();
    const double lc = c.norm();
    return std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

} // namespace

WindingNumber::WindingNumber(const TriangleMesh& mesh)
    : m_corners(mesh.triangles.size())
{
    const TriangleTree tree(mesh);
    forEachBlock(m_corners.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            m_corners[i] = cornersOf(mesh.vertices, mesh.triangles[tree.order()[i]]);
    });
    while (trianglesPerLeaf << 2 * m_depth < m_corners.size())
        ++m_depth;
    m_nodes.resize(levelBegin(m_depth + 1));
    for (unsigned level = 0; level <= m_depth; ++level)
        forEachBlock(std::size_t{1} << 2 * level, level < 4 ? 1 : 256, [&](std::size_t begin, std::size_t end) {
            for (std::size_t node = begin; node < end; ++node)
                m_nodes[levelBegin(level) + node] = nodeOf(firstTriangle(level, node), firstTriangle(level, node + 1));
        });
}

WindingNumber::Node WindingNumber::nodeOf(std::size_t begin, std::size_t end) const
{
    Node node;
    double areas = 0;
    Box box;
    for (std::size_t i = begin; i < end; ++i) {
        const auto& [a, b, c] = m_corners[i];
        const Vec3 area = 0.5 * crossOf(m_corners[i]);
        node.area += area;
        node.center += area.norm() * (a + b + c) / 3;
        areas += area.norm();
        for (const Vec3& corner : m_corners[i])
            box.extend(corner);
    }
    if (areas > 0)
        node.center /= areas;
    else if (begin < end)
        node.center = box.center();
    double squared = 0;
    for (std::size_t i = begin; i < end; ++i)
        for (const Vec3& corner : m_corners[i])
            squared = std::max(squared, (corner - node.center).squaredNorm());
    node.radius = std::sqrt(squared);
    return node;
}

double WindingNumber::at(const Vec3& point) const
{
    struct Pending {
        std::uint32_t level;
        std::uint32_t node;
    };
    std::array<Pending, 64> stack; // three per level, and the last
    std::size_t pending = 0;
    stack[pending++] = {0, 0};
    double halfAngles = 0;
    while (pending > 0) {
        const Pending next = stack[--pending];
        const Node& node = m_nodes[levelBegin(next.level) + next.node];
        const Vec3 away = node.center - point;
        const double squared = away.squaredNorm();
        if (squared > farShare * farShare * node.radius * node.radius && squared > 0) {
            halfAngles += 0.5 * node.area.dot(away) / (squared * std::sqrt(squared));
        } else if (next.level == m_depth) {
            for (std::size_t i = firstTriangle(m_depth, next.node); i < firstTriangle(m_depth, next.node + 1); ++i)
                halfAngles += halfSolidAngle(m_corners[i], point);
        } else {
            for (std::uint32_t child = 0; child < 4; ++child)
                stack[pending++] = {next.level + 1, 4 * next.node + child};
        }
    }
    return halfAngles / (2 * std::numbers::pi);
}

} // namespace knead
