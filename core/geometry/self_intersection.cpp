#include "core/geometry/self_intersection.h"

#include "core/geometry/half_edges.h"
#include "core/geometry/triangle_crossing.h"
#include "core/geometry/triangle_tree.h"
#include "core/task/parallel_progress.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <limits>

namespace knead {

namespace {

constexpr double toleranceShare = 1e-7;     // of the largest side
constexpr std::size_t trianglesPerLeaf = 4; // at most
constexpr std::size_t leavesPerBlock = 256;

/// Along the axes, in units of the surface's size. Rounding keeps the order of numbers, so boxes that overlap still do.
struct SmallBox {
    Eigen::Array3f low = Eigen::Array3f::Constant(std::numeric_limits<float>::infinity());
    Eigen::Array3f high = Eigen::Array3f::Constant(-std::numeric_limits<float>::infinity());

    void extend(const SmallBox& other)
    {
        low = low.min(other.low);
        high = high.max(other.high);
    }
    bool overlaps(const SmallBox& other) const { return (low <= other.high).all() && (high >= other.low).all(); }
};

/// What was found for some leaves.
struct Found {
    std::size_t count = 0;
    std::vector<std::array<std::uint32_t, 2>> some;
    Box where;
};

/// Boxes around the triangles in the order of a TriangleTree: node j of level l holds the triangles j n / 4^l .. (j + 1) n / 4^l.
/// Boxes that lie along the axes are worse than the tree's own at telling distances, but quicker to compare with each other.
class CrossingSearch {
public:
    CrossingSearch(const TriangleMesh& mesh, TaskControl& control, std::size_t most)
        : m_mesh(mesh)
        , m_control(control)
        , m_most(most)
        , m_halfEdges(findHalfEdges(mesh))
        , m_order(TriangleTree(mesh).order())
        , m_boxes(m_order.size())
    {
        while (trianglesPerLeaf << 2 * m_depth < m_order.size())
            ++m_depth;
        findBoxes();
    }

    Crossings run()
    {
        std::vector<Found> found((leafCount() + leavesPerBlock - 1) / leavesPerBlock);
        forEachBlock(leafCount(), leavesPerBlock, m_control, "looking for crossings",
                     [&](std::size_t begin, std::size_t end) {
                         for (std::size_t leaf = begin; leaf < end; ++leaf)
                             searchLeaf(leaf, found[begin / leavesPerBlock]);
                     });
        return joined(found);
    }

private:
    using Four = Eigen::Array4f;

    /// The boxes of the four children of a node.
    struct Node {
        std::array<Four, 3> low;
        std::array<Four, 3> high;

        void set(std::size_t child, const SmallBox& box)
        {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                low[axis][static_cast<Eigen::Index>(child)] = box.low[static_cast<Eigen::Index>(axis)];
                high[axis][static_cast<Eigen::Index>(child)] = box.high[static_cast<Eigen::Index>(axis)];
            }
        }

        /// Not positive for the children whose boxes overlap another.
        Four gaps(const SmallBox& box) const
        {
            Four gap = (low[0] - box.high[0]).max(box.low[0] - high[0]);
            for (std::size_t axis = 1; axis < 3; ++axis) {
                const auto i = static_cast<Eigen::Index>(axis);
                gap = gap.max(low[axis] - box.high[i]).max(box.low[i] - high[axis]);
            }
            return gap;
        }
    };

    std::size_t leafCount() const { return std::size_t{1} << 2 * m_depth; }
    static std::size_t levelBegin(unsigned level) { return ((std::size_t{1} << 2 * level) - 1) / 3; }
    std::size_t firstTriangle(std::size_t leaf) const { return leaf * m_order.size() >> 2 * m_depth; }

    void findBoxes()
    {
        const Box box = boxOfPlaces(m_mesh.vertices);
        const double size = box.sizes().maxCoeff();
        const double scale = size > 0 ? 1 / size : 1;
        m_tolerance = toleranceShare * size;
        forEachBlock(m_order.size(), 4096, [&](std::size_t begin, std::size_t end) {
            for (std::size_t place = begin; place < end; ++place)
                for (const std::uint32_t corner : m_mesh.triangles[m_order[place]]) {
                    const Eigen::Array3f inUnits =
                        ((m_mesh.vertices[corner] - box.center()) * scale).cast<float>().array();
                    m_boxes[place].extend({inUnits, inUnits});
                }
        });
        std::vector<SmallBox> boxes(leafCount()); // of a level, the leaves first
        for (std::size_t leaf = 0; leaf < boxes.size(); ++leaf)
            boxes[leaf] = leafBox(leaf);
        m_nodes.resize(levelBegin(m_depth));
        for (unsigned level = m_depth; level-- > 0;) {
            std::vector<SmallBox> parents(std::size_t{1} << 2 * level);
            for (std::size_t i = 0; i < boxes.size(); ++i) {
                m_nodes[levelBegin(level) + i / 4].set(i % 4, boxes[i]);
                parents[i / 4].extend(boxes[i]);
            }
            boxes = std::move(parents);
        }
    }

    SmallBox leafBox(std::size_t leaf) const
    {
        SmallBox box;
        for (std::size_t place = firstTriangle(leaf); place < firstTriangle(leaf + 1); ++place)
            box.extend(m_boxes[place]);
        return box;
    }

    /// Compares the triangles of a leaf with each other and with those of later leaves.
    void searchLeaf(std::size_t leaf, Found& found) const
    {
        struct Pending {
            unsigned level;
            std::size_t node; // of its level
        };
        const SmallBox box = leafBox(leaf);
        std::array<Pending, 64> stack; // three per level, and the last
        std::size_t pending = 0;
        stack[pending++] = {0, 0};
        while (pending > 0) {
            const Pending next = stack[--pending];
            if (next.level == m_depth) {
                compareLeaves(leaf, next.node, found);
                continue;
            }
            const Four gaps = m_nodes[levelBegin(next.level) + next.node].gaps(box);
            const std::size_t firstChild = 4 * next.node;
            const unsigned above = 2 * (m_depth - next.level - 1); // leaves of a child are 2^above
            for (std::size_t child = 4; child-- > 0;)
                if (gaps[static_cast<Eigen::Index>(child)] <= 0 && (firstChild + child + 1) << above > leaf)
                    stack[pending++] = {next.level + 1, firstChild + child};
        }
    }

    void compareLeaves(std::size_t leaf, std::size_t other, Found& found) const
    {
        for (std::size_t a = firstTriangle(leaf); a < firstTriangle(leaf + 1); ++a)
            for (std::size_t b = std::max(a + 1, firstTriangle(other)); b < firstTriangle(other + 1); ++b)
                if (m_boxes[a].overlaps(m_boxes[b]) && commonCorners(a, b) < 2)
                    compareTriangles(a, b, found);
    }

    int commonCorners(std::size_t a, std::size_t b) const
    {
        const TriangleMesh::Triangle& one = m_mesh.triangles[m_order[a]];
        const TriangleMesh::Triangle& other = m_mesh.triangles[m_order[b]];
        int common = 0;
        for (const std::uint32_t corner : one)
            common += corner == other[0] || corner == other[1] || corner == other[2] ? 1 : 0;
        return common;
    }

    void compareTriangles(std::size_t a, std::size_t b, Found& found) const
    {
        const std::uint32_t low = std::min(m_order[a], m_order[b]);
        const std::uint32_t high = std::max(m_order[a], m_order[b]);
        const auto line = crossingOf({m_mesh, m_halfEdges, low}, {m_mesh, m_halfEdges, high}, m_tolerance);
        if (!line)
            return;
        ++found.count;
        found.where.extend(line->begin).extend(line->end);
        if (found.some.size() < m_most)
            found.some.push_back({low, high});
    }

    /// The first pair of every block, then the second ..., so that they come from all over the surface.
    Crossings joined(const std::vector<Found>& found) const
    {
        Crossings all;
        std::size_t longest = 0;
        for (const Found& one : found) {
            all.count += one.count;
            if (one.count > 0)
                all.where.extend(one.where);
            longest = std::max(longest, one.some.size());
        }
        for (std::size_t rank = 0; rank < longest && all.some.size() < m_most; ++rank)
            for (const Found& one : found)
                if (rank < one.some.size() && all.some.size() < m_most)
                    all.some.push_back(one.some[rank]);
        std::ranges::sort(all.some);
        return all;
    }

    const TriangleMesh& m_mesh;
    TaskControl& m_control;
    std::size_t m_most;
    HalfEdges m_halfEdges;
    double m_tolerance = 0; ///< [m]
    unsigned m_depth = 0;
    std::vector<std::uint32_t> m_order; ///< of triangles, near ones together
    std::vector<SmallBox> m_boxes;      ///< of triangles, in this order
    std::vector<Node> m_nodes;          ///< all levels but the leaves
};

} // namespace

Crossings findCrossings(const TriangleMesh& mesh, TaskControl& control, std::size_t most)
{
    control.throwIfCancelled();
    return mesh.empty() ? Crossings{} : CrossingSearch(mesh, control, most).run();
}

Crossings findCrossingsAlone(const TriangleMesh& mesh, std::size_t most)
{
    tbb::task_arena alone(1);
    return alone.execute([&] { return findCrossings(mesh, TaskControl::none(), most); });
}

} // namespace knead
