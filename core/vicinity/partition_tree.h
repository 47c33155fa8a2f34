#pragma once

#include "core/vicinity/vicinity.h"

#include <vector>

namespace knead {

/// The published vicinity calculation: a binary space partition. At every node the spheres on either side of a plane go to two
/// children, those that span it stay in the node; the plane's axis cycles through x, y, z; leaves hold one sphere or none.
/// A sphere is examined against the nodes it reaches, both children where it spans the plane.
///
/// The pairs are found by the paper's parallel scheme: the spheres are split into subsets S_1 .. S_n of equal size, a tree
/// T_i is made of each, and every sphere of S_i is examined against T_i .. T_n. Subsets depend on the number of spheres, never
/// on the number of threads. With one subset this is the sequential algorithm.
///
/// The nodes of a tree come from a pool that keeps its memory from one build to the next, as in the paper.
/// Cost: the first cut through a compact body of n spheres is spanned by n^(2/3) of them, which all others meet:
/// Theta(n^(5/3)) for one body, close to n lg n for many scattered ones.
class PartitionTree final : public Vicinity {
public:
    enum class Plane { half, median };

    /// @param subsets n of the parallel scheme, >= 1
    explicit PartitionTree(Plane plane, std::size_t subsets = 1);

    const PairBlocks& findPairs(std::span<const VicinitySphere> spheres, double margin) override;

private:
    struct Node {
        double plane = 0;
        std::int32_t axis = 0;
        std::int32_t low = none; ///< child, or none
        std::int32_t high = none;
        std::uint32_t firstHeld = 0; ///< spheres held: those that span the plane, or the one of a leaf
        std::uint32_t lastHeld = 0;
    };
    static constexpr std::int32_t none = -1;

    /// One subset and its tree. Held spheres of a node are contiguous in `order`.
    struct Tree {
        std::vector<Node> pool; ///< nodes of the present tree first; memory outlives the tree
        std::vector<std::uint32_t> order;
        std::size_t spanning = 0;
        int depth = 0;
    };
    struct Work { ///< a part of a tree still to be split
        std::uint32_t begin;
        std::uint32_t end;
        std::int32_t parent;
        bool isLow;
        int depth;
        Box space;
    };

    void build();
    void plant(Tree& tree, std::uint32_t begin, std::uint32_t end);
    void split(Tree& tree, const Work& work, std::vector<Work>& todo);
    double planeOf(Tree& tree, const Work& work, int axis) const;
    std::uint64_t examine(const Tree& tree, std::uint32_t sphere, PairBlock& found) const;

    Plane m_plane;
    std::size_t m_subsets;
    std::span<const VicinitySphere> m_spheres; ///< during a call of findPairs()
    std::vector<Tree> m_trees;
    double m_margin = 0;
};

} // namespace knead
