#pragma once

#include "core/aggregate/lattice.h"

#include <array>
#include <cmath>

namespace knead {

/// How what is around an object pulls at it in uniform strain e, T : e: a symmetric tensor of the third order, in axes of the lattice.
/// Its components uuu vvv www, then sqrt(3) (uuv uuw vvu vvw wwu wwv), so that dot products are those of the tensors. Nothing here has
/// uvw.
using Pull = Eigen::Matrix<double, 9, 1>;

/// D D D / |D|^2: of a connection of weight 1 along D.
inline Pull pullOfConnection(const Vec3& D)
{
    const double mixed = std::sqrt(3.0);
    const Vec3 squares = D.cwiseProduct(D);
    Pull pull;
    pull << squares.cwiseProduct(D), mixed * squares.x() * D.y(), mixed * squares.x() * D.z(),
        mixed * squares.y() * D.x(), mixed * squares.y() * D.z(), mixed * squares.z() * D.x(),
        mixed * squares.z() * D.y();
    return pull / D.squaredNorm();
}

/// g d symmetrically, d the unit tensor: of what presses on an area g of the skin, where all connections inside have weight 1.
inline Pull pullOfSkin(const Vec3& g)
{
    const double mixed = std::sqrt(3.0);
    Pull pull;
    pull << 3 * g, mixed * g.y(), mixed * g.z(), mixed * g.x(), mixed * g.z(), mixed * g.x(), mixed * g.y();
    return pull;
}

/// Per direction of the lattice, at the lower end of a connection of weight 1 and, one further, at its upper end.
inline std::array<Pull, 2 * Lattice::isotropicCount> pullsOfDirections()
{
    std::array<Pull, 2 * Lattice::isotropicCount> pulls;
    for (std::size_t d = 0; d < Lattice::isotropicCount; ++d) {
        const Lattice::Node& ahead = Lattice::directions[d];
        pulls[2 * d] = pullOfConnection(Vec3(ahead[0], ahead[1], ahead[2]));
        pulls[2 * d + 1] = -pulls[2 * d];
    }
    return pulls;
}

} // namespace knead
