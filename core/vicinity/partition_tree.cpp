#include "core/vicinity/partition_tree.h"

#include "core/task/parallel.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace knead {

namespace {

// Space can be halved more often than doubles can tell apart; spheres left together then stay in one node and are tested
// one by one, as coincident spheres are.
constexpr int deepest = 200;

// How far a sphere counts as reaching. The margin counts as part of the spheres, or close pairs could be parted; the few
// units in the last place make up for the rounding of this sum, for the same reason.
double reachOf(const VicinitySphere& sphere, double margin)
{
    return (sphere.radius + 0.5 * margin) * (1 + 4 * std::numeric_limits<double>::epsilon());
}

} // namespace

PartitionTree::PartitionTree(Plane plane, std::size_t subsets)
    : m_plane(plane)
    , m_subsets(std::max<std::size_t>(subsets, 1))
{
}

double PartitionTree::planeOf(Tree& tree, const Work& work, int axis) const
{
    if (m_plane == Plane::half)
        return 0.5 * (work.space.min()[axis] + work.space.max()[axis]);
    const auto first = tree.order.begin() + work.begin;
    const auto middle = first + (work.end - work.begin) / 2;
    std::nth_element(first, middle, tree.order.begin() + work.end, [&](std::uint32_t a, std::uint32_t b) {
        return m_spheres[a].center[axis] < m_spheres[b].center[axis];
    });
    return m_spheres[*middle].center[axis];
}

void PartitionTree::split(Tree& tree, const Work& work, std::vector<Work>& todo)
{
    if (work.begin == work.end)
        return;
    const auto index = static_cast<std::int32_t>(tree.pool.size());
    Node node;
    node.firstHeld = work.begin;
    node.lastHeld = work.end;
    tree.depth = std::max(tree.depth, work.depth);
    if (work.end - work.begin > 1 && work.depth < deepest) {
        node.axis = work.depth % 3;
        node.plane = planeOf(tree, work, node.axis);
        // Low side | spanning | high side.
        const auto begin = tree.order.begin();
        const auto reach = [&](std::uint32_t s) { return reachOf(m_spheres[s], m_margin); };
        const auto held = std::partition(begin + work.begin, begin + work.end, [&](std::uint32_t s) {
            return m_spheres[s].center[node.axis] + reach(s) < node.plane;
        });
        const auto high = std::partition(held, begin + work.end, [&](std::uint32_t s) {
            return m_spheres[s].center[node.axis] - reach(s) <= node.plane;
        });
        node.firstHeld = static_cast<std::uint32_t>(held - begin);
        node.lastHeld = static_cast<std::uint32_t>(high - begin);
        tree.spanning += node.lastHeld - node.firstHeld;
        Work low{work.begin, node.firstHeld, index, true, work.depth + 1, work.space};
        Work rest{node.lastHeld, work.end, index, false, work.depth + 1, work.space};
        low.space.max()[node.axis] = node.plane;
        rest.space.min()[node.axis] = node.plane;
        todo.push_back(rest);
        todo.push_back(low);
    }
    tree.pool.push_back(node);
    if (work.parent != none) {
        Node& parent = tree.pool[static_cast<std::size_t>(work.parent)];
        (work.isLow ? parent.low : parent.high) = index;
    }
}

void PartitionTree::plant(Tree& tree, std::uint32_t begin, std::uint32_t end)
{
    tree.pool.clear(); // keeps its memory: the paper's pool of nodes
    tree.spanning = 0;
    tree.depth = 0;
    tree.order.resize(end - begin);
    std::iota(tree.order.begin(), tree.order.end(), begin);
    Box space;
    for (std::uint32_t i = begin; i < end; ++i) {
        const Vec3 reach = Vec3::Constant(m_spheres[i].radius);
        space.extend(m_spheres[i].center - reach);
        space.extend(m_spheres[i].center + reach);
    }
    std::vector<Work> todo{{0, end - begin, none, true, 0, space}};
    while (!todo.empty()) {
        const Work work = todo.back();
        todo.pop_back();
        split(tree, work, todo);
    }
}

void PartitionTree::build()
{
    m_trees.resize(m_subsets);
    const std::size_t count = m_spheres.size();
    forEachBlock(m_subsets, 1, [&](std::size_t subset, std::size_t) {
        plant(m_trees[subset], static_cast<std::uint32_t>(subset * count / m_subsets),
              static_cast<std::uint32_t>((subset + 1) * count / m_subsets));
    });
    m_statistics = {};
    for (const Tree& tree : m_trees) {
        m_statistics.spanningObjects += tree.spanning;
        m_statistics.depth = std::max(m_statistics.depth, tree.depth);
    }
}

std::uint64_t PartitionTree::examine(const Tree& tree, std::uint32_t sphere, PairBlock& found) const
{
    if (tree.pool.empty())
        return 0;
    const VicinitySphere& self = m_spheres[sphere];
    const double reach = reachOf(self, m_margin);
    std::uint64_t tests = 0;
    std::int32_t path[2 * deepest + 2] = {0};
    std::size_t waiting = 1;
    while (waiting > 0) {
        const Node& node = tree.pool[static_cast<std::size_t>(path[--waiting])];
        for (std::uint32_t held = node.firstHeld; held < node.lastHeld; ++held) {
            const std::uint32_t other = tree.order[held];
            if (other <= sphere) // examined the other way round
                continue;
            ++tests;
            if (closerThan(self, m_spheres[other], m_margin)) {
                *found.room(1) = {sphere, other};
                found.wrote(1);
            }
        }
        if (node.low != none && self.center[node.axis] - reach <= node.plane)
            path[waiting++] = node.low;
        if (node.high != none && self.center[node.axis] + reach >= node.plane)
            path[waiting++] = node.high;
    }
    return tests;
}

const PairBlocks& PartitionTree::findPairs(std::span<const VicinitySphere> spheres, double margin)
{
    m_spheres = spheres;
    m_margin = margin;
    build();
    m_pairs.clear();
    m_pairs.append(m_subsets);
    std::vector<std::uint64_t> tests(m_subsets, 0);
    const std::size_t count = spheres.size();
    forEachBlock(m_subsets, 1, [&](std::size_t subset, std::size_t) {
        for (std::size_t s = subset * count / m_subsets; s < (subset + 1) * count / m_subsets; ++s)
            for (std::size_t t = subset; t < m_subsets; ++t)
                tests[subset] += examine(m_trees[t], static_cast<std::uint32_t>(s), m_pairs[subset]);
    });
    m_statistics.sphereTests = std::accumulate(tests.begin(), tests.end(), std::uint64_t{0});
    m_spheres = {};
    return m_pairs;
}

} // namespace knead
