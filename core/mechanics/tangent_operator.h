#pragma once

#include "core/mechanics/kernel_views.h"
#include "core/mechanics/structural_connections.h"

#include <array>
#include <vector>

namespace knead {

/// How the forces of one body's structural connections answer to its velocities within a step: h C + h^2 K of the
/// implicit scheme (M + h C + h^2 K) dv = residual. Products with it walk the lattice; the matrix is never assembled.
///
/// A connection has k [n n^T + max(0, 1 - l / L) (1 - n n^T)] in K: its stiffness along itself, and the pull per length
/// across it, left out under compression, where it is negative. C is k b/k n n^T. The volumetric term, 1/2 B theta^2 per
/// object, takes part as B grad theta grad theta^T (Gauss-Newton) where B > 0. Where B < 0 (Poisson's ratio below
/// 1/4) it is left out, so that the operator is positive definite in any shape; it is then stiffer than the material, by up
/// to 5/2 in compression, which slows the approach to rest and does not change where that is.
///
/// Several threads; same bits for any number of them and any instruction set.
class TangentOperator {
public:
    /// `connections` must outlive it.
    explicit TangentOperator(const StructuralConnections& connections);

    /// Finds it for present places. @param step h [s]
    void update(const VectorArray& position, double step);

    /// Adds its product with u [m/s] to `product` [kg m/s]. Both begin with the body's first object.
    void addProduct(const kernels::ConstVectors& u, const kernels::Vectors& product);

    /// Adds its diagonal 3x3 blocks, xx yy zz xy xz yz, of the body's objects [kg].
    void addBlocks(const std::array<double*, 6>& blocks) const;

    /// Calls visit(lower, upper, root, across) for every connection: (root root^T + across) acts between the two [kg].
    template <typename Visit>
    void forEachConnection(Visit&& visit) const;

    /// How fast the dilatation of an object changes with the velocity of one around it.
    struct Slope {
        ObjectIndex object;
        Vec3 gradient; ///< [1/m]
    };
    /// Slopes of an object's dilatation, its own last; empty when that has no weight.
    std::vector<Slope> slopesOf(ObjectIndex object) const;
    double weightOf(ObjectIndex object) const { return m_weight[object]; } ///< h^2 B [J s^2]

    bool hasBulk() const { return m_hasBulk; }
    const StructuralConnections& connections() const { return *m_connections; }

private:
    kernels::ConstVectors gradientsTowards(std::size_t d, std::size_t first) const;
    void findGradients(const VectorArray& position, double step);
    void findPressures(const kernels::ConstVectors& u);
    kernels::ConstVectors roots(std::size_t d, std::size_t lower) const { return kernels::from(m_root[d], lower); }

    const StructuralConnections* m_connections;
    std::array<VectorArray, Lattice::directionCount> m_root;
    std::array<std::vector<double>, Lattice::directionCount> m_across;
    bool m_hasBulk = false;
    std::array<std::vector<double>, 9> m_gradient;               ///< of each object's dilatation, by lattice column
    std::array<VectorArray, Lattice::directionCount> m_diagonal; ///< the same towards neighbors across
    std::vector<double> m_weight;                                ///< h^2 B, 0 where that is negative
    std::vector<double> m_pressure; ///< h^2 B times the rate of dilatation, of the last product
};

template <typename Visit>
void TangentOperator::forEachConnection(Visit&& visit) const
{
    const Lattice& lattice = m_connections->aggregate().lattice;
    for (std::size_t d = 0; d < Lattice::directionCount; ++d)
        for (const Lattice::Segment& segment : lattice.segments[d])
            for (ObjectIndex lower = segment.begin; lower < segment.end; ++lower)
                if (m_connections->stiffness()[d][lower] > 0)
                    visit(lower, lower + static_cast<ObjectIndex>(segment.offset), m_root[d].at(lower),
                          m_across[d][lower]);
}

} // namespace knead
