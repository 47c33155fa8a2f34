#pragma once

#include "core/deformation/displacement_field.h"
#include "core/deformation/patch_detail.h"
#include "core/task/task_control.h"

#include <cstdint>
#include <span>
#include <vector>

namespace knead {

/// A field as a partition of unity of quadratic patches on the leaves of an octree:
///   u(X) = sum_k w_k(X) p_k(X) / sum_k w_k(X),
/// where w_k is patchWeight() in a cube that is somewhat larger than leaf k. Twice continuously differentiable.
///
/// Every cell of the tree, from the whole down to where few nodes are left, is fitted to the nodes in its cube, held to what its
/// parent came to: a quadratic field is the same patch everywhere, and where nodes are few or lie in a plane, what is known from farther
/// away goes on. A leaf is then the largest cell that is, everywhere in its cube, about as near to the nodes as the best fit there
/// would be to nodes that it has not seen: noise does not make leaves smaller, detail does. Where not even the smallest leaves are near
/// enough to the nodes, patches go through them, if that tells nodes that they have not seen better than a quadratic function does.
/// The tree covers three times the box of the nodes; toward its border the field becomes the best linear one.
class PatchTree {
public:
    struct Cell {
        Vec3 center;                  ///< [m]
        double side = 0;              ///< [m]
        std::uint32_t firstChild = 0; ///< of eight, those toward +x, +y, +z by the bits 1, 2, 4; 0: a leaf
        std::uint32_t leaf = 0;
    };
    /// What there is in a leaf.
    struct Leaf {
        QuadraticPatch patch;
        std::size_t firstSource = 0;
        std::size_t sourceCount = 0;
    };

    /// On all threads; its bits depend on none of them.
    /// @pre nodes are finite, at least one, no two in one place
    /// @throws Cancelled
    PatchTree(const DisplacementField& field, TaskControl& control);

    Vec3 displacementAt(const Vec3& place) const;

    /// The side of leaves, of which a tenth of the nodes have smaller ones [m].
    double leafSide() const { return m_leafSide; }
    std::size_t patchCount() const { return m_leaves.size(); }
    std::size_t sourceCount() const { return m_sources.size(); }

private:
    friend class PatchTreeBuilder;

    Vec3 sumOfPatches(const Vec3& place) const;

    std::vector<Cell> m_cells; ///< the root first
    std::vector<Leaf> m_leaves;
    std::vector<PatchSource> m_sources;
    QuadraticPatch m_linear; ///< the best one for all nodes
    double m_leafSide = 0;
};

} // namespace knead
