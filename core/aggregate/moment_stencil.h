#pragma once

#include "core/aggregate/cell_moments.h"
#include "core/aggregate/lattice.h"

#include <array>
#include <vector>

namespace knead {

/// A functional on the quadratic polynomials around a cell, by its values on 1, u, v, w, uu, vv, ww, uv, uw, vw (as CellMoments).
using QuadraticMoments = std::array<double, CellMoments::count>;

/// The middles of the connections of one family around a cell, over which a functional on quadratic polynomials is spread.
///
/// Weights m_b that act as the functional M, sum_b m_b p(x_b) = M for all quadratic p, and are small:
///   m_b = omega_b p(x_b)^T (sum omega p p^T + ridge)^-1 M,   omega = weight of today at b times Wendland(distance / 2.3 a)
/// The weight of today keeps what little there is at the skin from being asked for much. Lengths are in spacings, from the
/// middle of the cell; distances are from the middle of the material, to a third of a cell.
class MomentStencil {
public:
    static constexpr std::size_t terms = CellMoments::count;
    static constexpr std::size_t products =
        35; ///< different ones among those of two terms: monomials to the fourth degree
    static constexpr std::int32_t first = -2; ///< of the nodes around a cell that are used, per axis
    static constexpr std::int32_t across = 6; ///< and how many
    static constexpr std::size_t nodes = 216; ///< across^3

    struct Point {
        std::size_t node;                     ///< lower end of the connection, ((u * across) + v) * across + w
        double omega;                         ///< without the weight of today
        QuadraticMoments term;                ///< values there
        std::array<double, products> product; ///< omega times the products of two terms
    };

    MomentStencil(std::size_t direction, const Vec3& center);

    /// The one for a family and a center of material. Made when first needed; any thread.
    static const MomentStencil& of(std::size_t direction, const Vec3& center);

    const std::vector<Point>& points() const { return m_points; }

    /// The weights m_b, one per point; those of points without a connection (today's weight 0) are 0.
    /// @param weight of today, one per point
    /// @param weights the result
    void spread(const QuadraticMoments& moments, const std::vector<double>& weight, std::vector<double>& weights) const;

private:
    std::vector<Point> m_points;
};

} // namespace knead
