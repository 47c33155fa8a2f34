#include "core/geometry/triangle_tree.h"

#include "core/task/parallel.h"

#include <algorithm>
#include <span>

namespace knead {

namespace {

constexpr std::size_t trianglesPerLeaf = 4; // at most

using Place = Eigen::Vector3f; // in units

/// The middle of a triangle, in 2^-31 of the tree's units from the lowest corner of their box.
struct Center {
    std::array<std::uint32_t, 3> place;
    std::uint32_t triangle;

    /// For the order along a side; no two are the same.
    std::uint64_t key(std::size_t side) const { return std::uint64_t{place[side]} << 32U | triangle; }
};

Center centerOf(const TriangleMesh& mesh, std::uint32_t triangle, const Vec3& low, double scale)
{
    const TriangleMesh::Triangle& t = mesh.triangles[triangle];
    const Vec3 middle = (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3;
    const Vec3 place = ((middle - low) * (scale * 0x7fffffff)).cwiseMax(0).cwiseMin(0xffffffff);
    return {{static_cast<std::uint32_t>(place.x()), static_cast<std::uint32_t>(place.y()),
             static_cast<std::uint32_t>(place.z())},
            triangle};
}

std::size_t widestSide(std::span<const Center> centers)
{
    std::array<std::uint32_t, 3> low = centers.front().place;
    std::array<std::uint32_t, 3> high = low;
    for (const Center& center : centers)
        for (std::size_t side = 0; side < 3; ++side) {
            low[side] = std::min(low[side], center.place[side]);
            high[side] = std::max(high[side], center.place[side]);
        }
    std::size_t widest = 0;
    for (std::size_t side = 1; side < 3; ++side)
        if (high[side] - low[side] > high[widest] - low[widest])
            widest = side;
    return widest;
}

/// Moves the centers before a key to the front, without a branch that depends on them: as the order is unknown, every
/// other one would be guessed wrong. @returns how many there are
std::size_t partition(std::span<Center> centers, std::size_t side, std::uint64_t key)
{
    std::size_t lower = 0;
    for (Center& center : centers) {
        const Center moved = center;
        center = centers[lower];
        centers[lower] = moved;
        lower += moved.key(side) < key ? 1 : 0;
    }
    return lower;
}

/// The middle one of some keys spread over the centers.
std::uint64_t guessMedian(std::span<const Center> centers, std::size_t side)
{
    std::array<std::uint64_t, 15> keys;
    for (std::size_t i = 0; i < keys.size(); ++i)
        keys[i] = centers[i * (centers.size() - 1) / (keys.size() - 1)].key(side);
    std::nth_element(keys.begin(), keys.begin() + keys.size() / 2, keys.end());
    return keys[keys.size() / 2];
}

/// Puts the first `lower` centers along the side in which they spread most before the others.
void split(std::span<Center> centers, std::size_t lower)
{
    constexpr std::size_t few = 64;
    const std::size_t side = widestSide(centers);
    for (int pass = 0; centers.size() > few && pass < 64; ++pass) {
        const std::size_t before = partition(centers, side, guessMedian(centers, side));
        if (lower == before)
            return;
        if (lower < before) {
            centers = centers.first(before);
        } else {
            centers = centers.subspan(before);
            lower -= before;
        }
    }
    std::nth_element(centers.begin(), centers.begin() + static_cast<std::ptrdiff_t>(lower), centers.end(),
                     [side](const Center& a, const Center& b) { return a.key(side) < b.key(side); });
}

} // namespace

TriangleTree::TriangleTree(const TriangleMesh& mesh)
    : m_order(mesh.triangles.size())
{
    const Box box = boxOfPlaces(mesh.vertices);
    m_center = box.center();
    const double size = 0.5 * box.sizes().maxCoeff();
    m_scale = size > 0 ? 1 / size : 1;
    while (trianglesPerLeaf << 2 * m_depth < m_order.size())
        ++m_depth;
    m_nodes.resize(levelBegin(m_depth));
    sortTriangles(mesh);
    findBoxes(mesh);
}

void TriangleTree::sortTriangles(const TriangleMesh& mesh)
{
    std::vector<Center> centers(m_order.size());
    const Vec3 low = m_center - Vec3::Constant(1 / m_scale);
    forEachBlock(centers.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t)
            centers[t] = centerOf(mesh, static_cast<std::uint32_t>(t), low, m_scale);
    });
    // In halves: each level of the tree is two of these.
    const auto splitNode = [&](unsigned level, std::size_t node) {
        const std::size_t begin = node * centers.size() >> level;
        const std::size_t middle = (2 * node + 1) * centers.size() >> (level + 1);
        const std::size_t end = (node + 1) * centers.size() >> level;
        if (end - begin > 1)
            split({centers.data() + begin, end - begin}, middle - begin);
    };
    const unsigned levels = 2 * m_depth;
    const unsigned shared = std::min(levels, 5U); // the parts below fit a core's cache
    for (unsigned level = 0; level < shared; ++level)
        forEachBlock(std::size_t{1} << level, 1, [&](std::size_t node, std::size_t) { splitNode(level, node); });
    forEachBlock(std::size_t{1} << shared, 1, [&](std::size_t part, std::size_t) {
        for (unsigned level = shared; level < levels; ++level)
            for (std::size_t node = part << (level - shared); node < (part + 1) << (level - shared); ++node)
                splitNode(level, node);
    });
    for (std::size_t i = 0; i < m_order.size(); ++i)
        m_order[i] = centers[i].triangle;
}

TriangleTree::Node TriangleTree::nodeOf(const std::array<TurnedBox, 4>& children)
{
    Node node;
    for (std::size_t child = 0; child < 4; ++child) {
        const TurnedBox& box = children[child];
        const auto lane = static_cast<Eigen::Index>(child);
        for (std::size_t i = 0; i < 3; ++i) {
            const auto axis = static_cast<Eigen::Index>(i);
            node.center[i][lane] = box.center[axis];
            node.half[i][lane] = box.half[axis] + doubt;
            for (std::size_t j = 0; j < 3; ++j)
                node.axes[i][j][lane] = box.axes(static_cast<Eigen::Index>(j), axis);
        }
    }
    return node;
}

void TriangleTree::findBoxes(const TriangleMesh& mesh)
{
    std::vector<std::array<Place, 3>> corners(m_order.size());
    forEachBlock(corners.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            for (std::size_t corner = 0; corner < 3; ++corner)
                corners[i][corner] = inUnits(mesh.vertices[mesh.triangles[m_order[i]][corner]]);
    });
    std::vector<TurnedBox> boxes(std::size_t{1} << 2 * m_depth); // of a level, the leaves first
    forEachBlock(boxes.size(), 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t leaf = begin; leaf < end; ++leaf)
            boxes[leaf] = boxAround({corners.data() + firstTriangle(m_depth, leaf),
                                     firstTriangle(m_depth, leaf + 1) - firstTriangle(m_depth, leaf)});
    });
    for (unsigned level = m_depth; level-- > 0;) {
        std::vector<TurnedBox> parents(std::size_t{1} << 2 * level);
        forEachBlock(parents.size(), 256, [&](std::size_t begin, std::size_t end) {
            for (std::size_t parent = begin; parent < end; ++parent) {
                const std::array<TurnedBox, 4> children{boxes[4 * parent], boxes[4 * parent + 1], boxes[4 * parent + 2],
                                                        boxes[4 * parent + 3]};
                m_nodes[levelBegin(level) + parent] = nodeOf(children);
                parents[parent] = boxAround(children);
            }
        });
        boxes = std::move(parents);
    }
}

} // namespace knead
