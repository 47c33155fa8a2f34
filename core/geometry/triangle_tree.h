#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/geometry/turned_box.h"

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace knead {

/// Finds the triangles of a mesh that may be nearest to a point or first along a ray: a perfectly balanced tree of boxes, four to a node.
///
/// Node n has children 4 n + 1 .. 4 n + 4, and node j of level l holds the triangles j count / 4^l .. (j + 1) count / 4^l
/// of the order, so that neither children nor ranges are stored. Boxes are turned with the triangles in them: around a
/// patch of a smooth surface they are thin, and nearly all patches but the nearest are told to be farther. They are in
/// single precision, in units of the mesh's size, and a little too large: four are compared with a point at a time, and
/// what they say is never too far.
class TriangleTree {
public:
    TriangleTree() = default;

    /// O(n lg n), on all threads.
    explicit TriangleTree(const TriangleMesh& mesh);

    /// Triangles, those of a leaf one after the other.
    const std::vector<std::uint32_t>& order() const { return m_order; }

    /// Calls visit(begin, end) for the leaves (triangles begin .. end of the order) whose boxes are not farther than the
    /// squared distance [m^2] that `visit` returned last, at first `farthest`; near ones first.
    template <typename Visit>
    void forEachNear(const Vec3& point, double farthest, Visit&& visit) const;

    /// Calls visit(begin, end) for the leaves whose boxes a ray meets not farther along than `visit` returned last [m], at
    /// first `farthest`; near ones first.
    /// @param direction of unit length
    template <typename Visit>
    void forEachAlong(const Vec3& start, const Vec3& direction, double farthest, Visit&& visit) const;

private:
    using Four = Eigen::Array4f;

    /// The boxes of the four children of a node.
    struct Node {
        std::array<Four, 3> center;
        std::array<std::array<Four, 3>, 3> axes; ///< of unit length, across each other
        std::array<Four, 3> half;                ///< sides along the axes; negative for a child without triangles
    };

    static Node nodeOf(const std::array<TurnedBox, 4>& children);

    std::size_t levelBegin(unsigned level) const { return ((std::size_t{1} << 2 * level) - 1) / 3; }
    std::size_t firstTriangle(unsigned level, std::size_t node) const { return node * m_order.size() >> 2 * level; }

    Eigen::Vector3f inUnits(const Vec3& place) const { return ((place - m_center) * m_scale).cast<float>(); }
    float squaredInUnits(double squared) const { return static_cast<float>(squared * m_scale * m_scale) * (1 + doubt); }
    Four squaredDistances(const Node& node, const Eigen::Vector3f& place) const;
    Four entries(const Node& node, const Eigen::Vector3f& place, const Eigen::Vector3f& direction) const;

    template <typename Bound, typename Distances, typename Visit>
    void walk(float bound, Bound&& inUnitsOf, Distances&& distances, Visit&& visit) const;

    void sortTriangles(const TriangleMesh& mesh);
    void findBoxes(const TriangleMesh& mesh);

    /// Single precision is right to 6e-8 of each number added up, of which there are a few per level of the tree. Boxes
    /// are larger by this, in units, and distances are taken for true to this part of them.
    static constexpr float doubt = 1e-5F;

    Vec3 m_center = Vec3::Zero();
    double m_scale = 1; ///< one over half the largest side of the box [1/m]
    unsigned m_depth = 1;
    std::vector<std::uint32_t> m_order;
    std::vector<Node> m_nodes; ///< all levels but the leaves, which are boxes in their parents
};

inline TriangleTree::Four TriangleTree::squaredDistances(const Node& node, const Eigen::Vector3f& place) const
{
    std::array<Four, 3> from;
    for (std::size_t i = 0; i < 3; ++i)
        from[i] = place[static_cast<Eigen::Index>(i)] - node.center[i];
    Four sum = Four::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
        const Four along = node.axes[i][0] * from[0] + node.axes[i][1] * from[1] + node.axes[i][2] * from[2];
        const Four beyond = (along.abs() - node.half[i]).max(0.0F);
        sum += beyond * beyond;
    }
    return sum;
}

/// How far along a ray the boxes of the children begin, in units; infinite for boxes that it misses.
inline TriangleTree::Four TriangleTree::entries(const Node& node, const Eigen::Vector3f& place,
                                                const Eigen::Vector3f& direction) const
{
    constexpr float leastSlope = 1e-12F; // keeps quotients finite
    std::array<Four, 3> from;
    for (std::size_t i = 0; i < 3; ++i)
        from[i] = place[static_cast<Eigen::Index>(i)] - node.center[i];
    Four enter = Four::Zero();
    Four leave = Four::Constant(std::numeric_limits<float>::max());
    for (std::size_t i = 0; i < 3; ++i) {
        const Four along = node.axes[i][0] * from[0] + node.axes[i][1] * from[1] + node.axes[i][2] * from[2];
        const Four speed =
            node.axes[i][0] * direction[0] + node.axes[i][1] * direction[1] + node.axes[i][2] * direction[2];
        const Four slope = (speed.abs() < leastSlope).select(Four::Constant(leastSlope), speed);
        const Four one = (-node.half[i] - along) / slope;
        const Four other = (node.half[i] - along) / slope;
        enter = enter.max(one.min(other));
        leave = leave.min(one.max(other));
    }
    const auto missed = enter > leave || node.half[0] < 0;
    return missed.select(Four::Constant(std::numeric_limits<float>::infinity()), enter);
}

/// Visits leaves by the distance of their boxes, near ones first, as far as the bound that the visits return.
template <typename Bound, typename Distances, typename Visit>
void TriangleTree::walk(float bound, Bound&& inUnitsOf, Distances&& distancesOf, Visit&& visit) const
{
    struct Pending {
        float distance;
        std::uint32_t level;
        std::uint32_t node; // of its level
    };
    std::array<Pending, 64> stack; // three per level, and the last
    std::size_t pending = 0;
    stack[pending++] = {0, 0, 0};
    while (pending > 0) {
        const Pending next = stack[--pending];
        if (next.distance > bound)
            continue;
        if (next.level == m_depth) {
            bound = inUnitsOf(visit(firstTriangle(m_depth, next.node), firstTriangle(m_depth, next.node + 1)));
            continue;
        }
        const Four distances = distancesOf(m_nodes[levelBegin(next.level) + next.node]);
        const std::size_t first = pending;
        for (std::uint32_t child = 0; child < 4; ++child) {
            const float distance = distances[child];
            if (distance > bound)
                continue;
            std::size_t at = pending++;
            for (; at > first && stack[at - 1].distance < distance; --at)
                stack[at] = stack[at - 1];
            stack[at] = {distance, next.level + 1, 4 * next.node + child};
        }
    }
}

template <typename Visit>
void TriangleTree::forEachNear(const Vec3& point, double farthest, Visit&& visit) const
{
    const Eigen::Vector3f place = inUnits(point);
    walk(
        squaredInUnits(farthest), [this](double squared) { return squaredInUnits(squared); },
        [&](const Node& node) { return squaredDistances(node, place); }, visit);
}

template <typename Visit>
void TriangleTree::forEachAlong(const Vec3& start, const Vec3& direction, double farthest, Visit&& visit) const
{
    const Eigen::Vector3f place = inUnits(start);
    const Eigen::Vector3f way = direction.cast<float>();
    const auto boundOf = [this](double distance) { return static_cast<float>(distance * m_scale) + 10 * doubt; };
    walk(
        boundOf(farthest), boundOf, [&](const Node& node) { return entries(node, place, way); }, visit);
}

} // namespace knead
