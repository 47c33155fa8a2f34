#include "core/session/edge_sight.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <unordered_map>

namespace knead {

namespace {

constexpr double grazing = 1e-4; // sine of the angle below which a triangle counts as seen

std::uint64_t edgeKeyOf(std::uint32_t a, std::uint32_t b)
{
    return std::uint64_t{std::min(a, b)} << 32U | std::max(a, b);
}

} // namespace

EdgeSight::EdgeSight(const RenderMesh& mesh)
    : m_sides(mesh.edges.size())
{
    std::unordered_map<std::uint64_t, std::uint32_t>
        edges; // render vertices are split along them: by what these are split from
    for (std::uint32_t e = 0; e < mesh.edges.size(); ++e)
        edges.emplace(edgeKeyOf(mesh.source[mesh.edges[e][0]], mesh.source[mesh.edges[e][1]]), e);
    std::vector<int> found(mesh.edges.size(), 0);
    for (const Triangle& triangle : mesh.triangles)
        for (std::size_t side = 0; side < 3; ++side) {
            const auto edge = edges.find(edgeKeyOf(mesh.source[triangle[side]], mesh.source[triangle[(side + 1) % 3]]));
            if (edge == edges.end())
                continue;
            auto& [first, second] = m_sides[edge->second];
            if (found[edge->second]++ == 0)
                first = triangle;
            second = triangle;
        }
    for (std::size_t e = 0; e < found.size(); ++e)
        if (found[e] != 2)
            m_sides[e] = {}; // at a rim, or where solids touch: a triangle without a size always counts as seen
}

std::vector<bool> EdgeSight::seenFrom(std::span<const float> points, const std::optional<Vec3>& eye,
                                      const Vec3& towardsEye) const
{
    const auto at = [&](std::uint32_t vertex) -> Vec3 {
        return Eigen::Map<const Eigen::Vector3f>(points.data() + std::size_t{3} * vertex).cast<double>();
    };
    const auto isFacing = [&](const Triangle& triangle) {
        const Vec3 a = at(triangle[0]);
        const Vec3 normal = (at(triangle[1]) - a).cross(at(triangle[2]) - a);
        const Vec3 sight = eye ? Vec3(*eye - a) : towardsEye;
        return normal.dot(sight) >= -grazing * normal.norm() * sight.norm();
    };
    std::vector<bool> seen(m_sides.size());
    std::transform(m_sides.begin(), m_sides.end(), seen.begin(),
                   [&](const auto& sides) { return isFacing(sides[0]) || isFacing(sides[1]); });
    return seen;
}

} // namespace knead
