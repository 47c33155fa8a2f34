#pragma once

#include "core/aggregate/local_shape.h"
#include "core/aggregate/moment_spread.h"
#include "core/aggregate/thin_cells.h"

#include <array>
#include <vector>

namespace knead {

/// The two diagonals of a face of cells cross in their middles and have the same weights, so only one of them is fitted: uv, uw, vw.
constexpr std::array<std::size_t, 3> faceDiagonals{3, 5, 7};

/// Two cells per axis, whose corrections are spread together: an eighth to a quarter of the work of one after the other.
///
/// What they give to the connections of a family beside what joinCells() does:
///  - of a cut cell the moments of its material, less what it gave already;
///  - of the sides of full cells -excess / 2 times the derivative along the outward normal, taken over the side. Between full
///    cells the second moments that are too large cancel but for these.
/// excess = evenlyJoined() - 1/12 - stiffening() differs from family to family, so what it multiplies is summed up apart.
///
/// Sides that are skin (bare) are flat and on nodes, where joinCells() is exact in uniform strain. It stays so as long as the
/// connections that lead inwards keep their weights, so only those along the side are fitted, and what the others lack is borne by
/// axes. Fitting them too makes tension, long stretches of rubber and shares of broken pieces up to 3 % worse, and glue weaker by a
/// tenth.
class ThinBlock {
public:
    using Place = std::array<std::int32_t, 3>; ///< numbers of its pairs of cells

    /// @param node in it: the first one inside
    ThinBlock(const Place& place, const Lattice::Node& node)
        : m_place(place)
        , m_node(node)
    {
    }

    void add(const ThinCell& cell);

    const Place& place() const { return m_place; }
    const Lattice::Node& node() const { return m_node; }

    /// Middle of the material, from the node [a].
    Vec3 center() const { return m_centers / m_cells; }

    /// The same in coordinates of the lattice.
    Vec3 centerInLattice() const { return Vec3(m_node[0], m_node[1], m_node[2]) + center(); }

    /// Of the material around it. Before moments().
    void setShape(const LocalShape& shape) { m_shape = shape; }
    const LocalShape& shape() const { return m_shape; }

    /// About the middle of the material. Those of connections along the axes are known once setResidual() was called for all
    /// faceDiagonals.
    QuadraticMoments moments(std::size_t direction) const;

    /// @param direction of faceDiagonals
    /// @param residual what a fit of them has beside what it should
    void setResidual(std::size_t direction, const QuadraticMoments& residual);

private:
    QuadraticMoments meanResidual(std::size_t axis) const;
    void addMaterial(const ThinCell& cell, const Vec3& step);

    Place m_place;
    Lattice::Node m_node;
    LocalShape m_shape;
    Vec3 m_centers = Vec3::Zero();
    double m_cells = 0;
    double m_volume = 0;     // of cut cells
    double m_keptVolume = 0; // of those that joinCells() has seen
    QuadraticMoments m_material{};
    std::array<QuadraticMoments, 3> m_sides{};     // per axis of the sides, to cut cells
    std::array<QuadraticMoments, 3> m_bareSides{}; // that are skin
    std::array<QuadraticMoments, 3> m_residual{};  // per pair of diagonals
};

/// Of cells per slab, by the number of their first pair, ascending.
std::vector<std::vector<ThinBlock>> thinBlocksOf(const std::vector<std::vector<ThinCell>>& slabs);

} // namespace knead
