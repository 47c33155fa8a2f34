#pragma once

#include "core/aggregate/cell_moments.h"
#include "core/aggregate/lattice.h"

#include <array>
#include <vector>

namespace knead {

/// A functional on the quadratic polynomials around a place, by its values on 1, u, v, w, uu, vv, ww, uv, uw, vw (as CellMoments).
using QuadraticMoments = std::array<double, CellMoments::count>;

/// The same functional by its values on the polynomials around another place: coordinates there are `step` more.
QuadraticMoments moved(const QuadraticMoments& moments, const Vec3& step);

/// Spreads a functional M on quadratic polynomials over the middles x_b of the connections of one family around a node.
///
/// Weights m_b that act as M, sum_b m_b p(x_b) = M for all quadratic p, and are small:
///   m_b = omega_b p(x_b)^T (sum omega p p^T + ridge)^-1 M,   omega = weight of today at b times Wendland(distance / 2.4 a)
/// The weight of today keeps what little there is at the skin from being asked for much. What the ridge keeps out, as two
/// layers of objects have the square of one height only, is the residual sum_b m_b p(x_b) - M. Lengths are in
/// spacings; M and coordinates are about the middle of the material.
class MomentSpread {
public:
    static constexpr std::int32_t reach = 3;  ///< nodes around, per axis and side
    static constexpr std::int32_t across = 7; ///< 2 reach + 1
    static constexpr std::size_t nodes = 343; ///< across^3

    /// The objects around a node, ((u * across) + v) * across + w; a number beyond all objects where there is none.
    using Objects = std::array<ObjectIndex, nodes>;

    /// From the node to that of an entry of Objects.
    static Vec3 stepTo(std::size_t entry)
    {
        const auto along = [](std::size_t place) { return static_cast<double>(place) - reach; };
        return {along(entry / (across * across)), along(entry / across % across), along(entry % across)};
    }

    struct Share {
        std::uint32_t node; ///< lower end of the connection, as in Objects
        double weight;      ///< m_b
    };

    /// The shares of connections that there are (weight of today above 0). Valid until the next call.
    /// @param center middle of the material, from the node
    /// @param today weights of the family, per object
    const std::vector<Share>& spread(std::size_t direction, const QuadraticMoments& moments, const Vec3& center,
                                     const Objects& objects, const std::vector<double>& today);

    /// Of the last call.
    const QuadraticMoments& residual() const { return m_residual; }

private:
    struct Point {
        double u, v, w;
        double omega;
    };

    std::vector<Point> m_points;
    std::vector<Share> m_shares;
    QuadraticMoments m_residual{};
};

} // namespace knead
