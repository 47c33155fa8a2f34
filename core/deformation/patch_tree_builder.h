#pragma once

#include "core/deformation/patch_fit.h"
#include "core/deformation/patch_tree.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

namespace knead {

constexpr double patchOverlap = 1.8; ///< sides of the cube of a patch, of those of its leaf: 5.8 patches at a place

/// Per level of the tree: what eigenvalues of 0.01 to 1 say counts, what is told by rounding or a few nodes of a plane does not.
constexpr PatchHold childHold{1e-7, 1e-5, 1e-4};

/// Makes the leaves of a PatchTree: fits all cells from the root down, then picks the largest good ones.
class PatchTreeBuilder {
public:
    PatchTreeBuilder(const DisplacementField& field, TaskControl& control);

    void build(PatchTree& tree);

private:
    using Nodes = std::vector<std::uint32_t>; ///< in the order of m_field

    /// A cell with the nodes in the cube of its patch.
    struct Work {
        std::uint32_t cell = 0;
        std::uint32_t parent = 0;
        Nodes nodes;
        Nodes wider; ///< in a larger cube, where those are few
    };

    void fitRoot(PatchTree& tree);
    std::vector<Work> fitLevel(std::vector<Work> level);
    void fit(const Work& work);
    static std::size_t blockSizeOf(std::size_t cells) { return std::clamp<std::size_t>(cells / 256, 1, 64); }
    double squaredOff(std::uint32_t node, const QuadraticPatch& patch) const;
    bool isWorthSplitting(const Work& work) const;
    std::vector<Work> chooseLevel(std::vector<Work> level);
    bool isGoodEnough(const Work& work) const;
    bool isChosen(const Work& work) const;
    void addDetail(const std::vector<const Work*>& leaves);
    std::pair<Nodes, double> nearestOf(const Nodes& nodes, std::uint32_t middle) const;
    bool hidesDetail(const Work& work) const;
    bool gainsBySplitting(std::uint32_t cell) const;
    std::vector<Work> childrenOf(const std::vector<Work>& level, const std::vector<std::uint32_t>& parents) const;
    void shareOut(const Work& parent, std::span<Work, 8> children) const;
    void takeOver(PatchTree& tree) const;
    double leafSideOf(const PatchTree& tree) const;

    TaskControl& m_control;
    DisplacementField m_field;   ///< sorted along a space-filling curve
    std::vector<double> m_error; ///< per node, as far as fits around it are expected to be off at best [m]
    std::vector<PatchTree::Cell> m_cells;
    std::vector<QuadraticPatch> m_patches; ///< per cell
    std::vector<double> m_squares;  ///< per cell: sum of squared errors that nodes in it would have without them [m^2]
    std::vector<double> m_expected; ///< per cell: root mean square of these in the cube [m]
    std::vector<std::vector<PatchSource>> m_sources; ///< per cell
    double m_tolerance = 0;                          ///< nearer to the nodes than this no patch need be [m]
};

} // namespace knead
