#pragma once

#include "core/aggregate/aggregate.h"
#include "core/aggregate/lattice_rows.h"
#include "core/geometry/triangle_mesh.h"
#include "core/skin/cut_borders.h"
#include "core/task/task_control.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace knead {

/// Which part of a body each node of a lattice belongs to, with a smooth share of each label around the borders between
/// them. The nodes are the objects and the corners of all cells that the surface passes through, so that every cell with
/// material in it has all of its corners.
class LabeledNodes {
public:
    static constexpr std::uint32_t noLabel = 0xffffffffU;

    /// @param labels per object; noLabel for those that have no part in this
    /// @param shift moves the lattice against that of the objects [cells], much less than 1, so that labels do not meet
    ///        exactly where the surface has its corners
    /// @param cuts of knives between labels: borders go exactly there
    /// @pre at least one object has a label. @throws Cancelled
    LabeledNodes(const Aggregate& aggregate, std::span<const std::uint32_t> labels, const CutBorders& cuts,
                 const TriangleMesh& skin, const Vec3& shift, TaskControl& control);
    LabeledNodes(const LabeledNodes&) = delete;
    LabeledNodes& operator=(const LabeledNodes&) = delete;

    const Lattice& lattice() const { return m_lattice; }
    std::uint32_t label(std::size_t node) const { return m_label[node]; }

    /// How much a node is of a label, about 0..1; largest for its own. Smooth, but objects keep the label they have.
    double share(std::size_t node, std::uint32_t label) const;

    /// Nodes near a border, ascending: the lowest corners of all cells with several labels are among them.
    const std::vector<ObjectIndex>& nearBorders() const { return m_near; }

    /// The corners of the cell above a node, corner (i, j, k) at place 4 i + 2 j + k; not all there: false.
    bool cornersAbove(const Lattice::Node& lowest, std::array<ObjectIndex, 8>& corners) const;

    /// The label at a place of the material [m]. `isSure` when the whole cell around it has that label.
    struct Found {
        std::uint32_t label = noLabel;
        bool isSure = false;
    };
    Found find(const Vec3& place) const;

private:
    struct Share {
        std::uint32_t label;
        double share;
    };
    using Shares = std::vector<Share>;
    static constexpr std::uint32_t far = 0xffffffffU;

    void collectNodes(const Aggregate& aggregate, std::span<const std::uint32_t> labels, const TriangleMesh& skin,
                      TaskControl& control);
    void labelObjects(const Aggregate& aggregate, std::span<const std::uint32_t> labels);
    void spreadLabels(const Aggregate& aggregate, std::span<const std::uint32_t> labels);
    void findBorders();
    void findShares(const CutBorders& cuts, const Vec3& offset, TaskControl& control);
    static double& shareIn(Shares& shares, std::uint32_t label);
    Shares fitted(ObjectIndex node) const;
    bool isAtCut(ObjectIndex node) const { return m_placeInNear[node] != far && m_isAtCut[m_placeInNear[node]] != 0; }
    void addLeads();
    void keepOwnLabel(std::size_t near);

    Lattice m_lattice;
    std::unique_ptr<const LatticeRows> m_rows;
    std::vector<std::uint32_t> m_label;       ///< per node
    std::vector<std::uint8_t> m_isObject;     ///< per node
    std::vector<std::uint8_t> m_isBorder;     ///< per node: it is next to another label, so that a cell with it is near
    std::vector<ObjectIndex> m_near;          ///< nodes near borders
    std::vector<std::uint32_t> m_placeInNear; ///< per node, or `far`
    std::vector<Shares> m_shares;             ///< per node near a border
    std::vector<std::uint8_t> m_isAtCut;      ///< per node near a border: its shares say how high it lies above a cut
};

} // namespace knead
