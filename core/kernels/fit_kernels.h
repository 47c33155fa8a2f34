#pragma once

#include <cstddef>
#include <cstdint>

/// The innermost loops of moving least squares fits around points of the skin. See kernels.h for how they are compiled and picked.
namespace knead::kernels {

inline constexpr std::size_t fitLanes = 8; ///< nodes are worked on so many at a time

/// A number of nodes and those that fill up the last lanes.
constexpr std::size_t inFitLanes(std::size_t count)
{
    return (count + fitLanes - 1) / fitLanes * fitLanes;
}

/// All products of two of the functions 1, x, y, z, xx, yy, zz, xy, yz, zx: the monomials up to degree 4, by ascending degree. Each but
/// the first, which is 1, is a coordinate times an earlier one.
struct FitMonomials {
    static constexpr std::size_t count = 35;
    std::uint8_t powers[count][3]{};
    std::uint8_t factor[count]{}; ///< which earlier one
    std::uint8_t axis[count]{};   ///< of the coordinate

    constexpr FitMonomials()
    {
        std::size_t next = 0;
        for (int degree = 0; degree <= 4; ++degree)
            for (int x = degree; x >= 0; --x)
                for (int y = degree - x; y >= 0; --y, ++next) {
                    powers[next][0] = static_cast<std::uint8_t>(x);
                    powers[next][1] = static_cast<std::uint8_t>(y);
                    powers[next][2] = static_cast<std::uint8_t>(degree - x - y);
                }
        for (std::size_t k = 1; k < count; ++k) {
            axis[k] = powers[k][0] > 0 ? 0 : powers[k][1] > 0 ? 1 : 2;
            std::uint8_t lower[3] = {powers[k][0], powers[k][1], powers[k][2]};
            --lower[axis[k]];
            factor[k] = find(lower[0], lower[1], lower[2]);
        }
    }

    /// @pre there is one with these powers
    constexpr std::uint8_t find(int x, int y, int z) const
    {
        std::uint8_t k = 0;
        while (powers[k][0] != x || powers[k][1] != y || powers[k][2] != z)
            ++k;
        return k;
    }
};
inline constexpr FitMonomials fitMonomials;

/// Nodes around a point. Filled up to a multiple of fitLanes with such as have no share.
struct FitNodes {
    const double* place[3]; ///< x y z from the point, in any unit
    const double* distance; ///< from the point
    const double* share;    ///< 0 .. 1: what its weight is multiplied with
    std::size_t count;      ///< a multiple of fitLanes
};

/// Nodes in a support, counted by their weight.
struct FitContent {
    double count;
    double slope; ///< over the support
};

struct FitKernels {
    /// Places and distances of nodes as a point sees them.
    /// @param steps x y z of the nodes and @param point from the same origin @return the least distance
    double (*lookAround)(std::size_t count, const float* const (&steps)[3], const double (&point)[3],
                         double* const (&place)[3], double* distance);

    /// Sums of share times w(r), r = distance / support, w = (1 - r)^3 (3 r + 1) up to 1 and 0 beyond (Wendland).
    FitContent (*content)(const FitNodes& nodes, double support);

    /// Writes share times w(r) per node, and the sums of the monomials of place / support with that weight.
    void (*moments)(const FitNodes& nodes, double support, double* weight, double (&sums)[FitMonomials::count]);

    /// Writes, per node, its weight times the polynomial of place / support with ten coefficients, in the order of the functions.
    /// @return the sum of their absolute values
    double (*functions)(const FitNodes& nodes, double support, const double* weight, const double (&coefficients)[10],
                        double* values);
};

} // namespace knead::kernels
