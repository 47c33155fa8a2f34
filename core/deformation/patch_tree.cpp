#include "core/deformation/patch_tree.h"

#include "core/deformation/patch_tree_builder.h"

#include <array>
#include <cmath>

namespace knead {

namespace {

constexpr double linearFrom = 0.8; // of half the root, along each axis, the field begins to become linear
constexpr double linearAt = 0.98;  // and is it

/// 0 before 0, 1 behind 1, 6 t^5 - 15 t^4 + 10 t^3 between.
double quintic(double t)
{
    const double c = std::clamp(t, 0.0, 1.0);
    return c * c * c * (c * (6 * c - 15) + 10);
}

/// How far beyond its middle cubes of leaves in a cell reach at most, of its side.
constexpr double leafReach = patchOverlap / 2;
constexpr double innerReach = 0.5 + (patchOverlap - 1) / 4;

} // namespace

PatchTree::PatchTree(const DisplacementField& field, TaskControl& control)
{
    PatchTreeBuilder(field, control).build(*this);
}

Vec3 PatchTree::displacementAt(const Vec3& place) const
{
    const Cell& root = m_cells.front();
    const Vec3 from = (place - root.center).cwiseAbs() / (root.side / 2);
    double share = 1;
    for (Eigen::Index axis = 0; axis < 3; ++axis)
        share *= 1 - quintic((from[axis] - linearFrom) / (linearAt - linearFrom));
    if (share == 1)
        return sumOfPatches(place);
    const Vec3 linear = m_linear.at(m_linear.within(place));
    return share > 0 ? Vec3(share * sumOfPatches(place) + (1 - share) * linear) : linear;
}

Vec3 PatchTree::sumOfPatches(const Vec3& place) const
{
    Vec3 sum = Vec3::Zero();
    double weights = 0;
    std::array<std::uint32_t, 256> stack; // of a depth-first walk: at most seven per level
    std::size_t pending = 0;
    stack[pending++] = 0;
    while (pending > 0) {
        const Cell& cell = m_cells[stack[--pending]];
        if (cell.firstChild == 0) {
            const Leaf& leaf = m_leaves[cell.leaf];
            const Vec3 t = leaf.patch.within(place);
            const double weight = patchWeight(t);
            sum += weight * (leaf.patch.at(t) + detailAt(t, {m_sources.data() + leaf.firstSource, leaf.sourceCount}));
            weights += weight;
            continue;
        }
        for (std::uint32_t child = cell.firstChild; child < cell.firstChild + 8; ++child) {
            const Cell& next = m_cells[child];
            const double reach = (next.firstChild == 0 ? leafReach : innerReach) * next.side;
            if (((place - next.center).array().abs() < reach).all())
                stack[pending++] = child;
        }
    }
    return sum / weights;
}

} // namespace knead
