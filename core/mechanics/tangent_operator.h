#pragma once

#include "core/kernels/tangent_kernels.h"
#include "core/mechanics/run_slots.h"
#include "core/mechanics/structural_connections.h"

#include <array>
#include <vector>

namespace knead {

/// How the forces of one body's structural connections answer to its velocities within a step: M + h C + h^2 K of the
/// implicit scheme, (M + h C + h^2 K) dv = residual. Products with it walk the lattice; the matrix is never assembled.
///
/// A connection has k [n n^T + max(0, 1 - l / L) (1 - n n^T)] in K: its stiffness along itself, and the pull per length
/// across it, left out under compression, where it is negative. C is k b/k n n^T. The volumetric term, 1/2 B theta^2 per
/// object, takes part as B grad theta grad theta^T (Gauss-Newton) where B > 0. Where B < 0 (Poisson's ratio below
/// 1/4) it is left out, so that the operator is positive definite in any shape; it is then stiffer than the material, by up
/// to 5/2 in compression, which slows the approach to rest and does not change where that is.
///
/// Found in double and kept in single precision, by slots (RunSlots): what it is solved for is a change of velocities, and what a
/// solution lacks is found in double.
///
/// Several threads; same bits for any number of them and any instruction set.
class TangentOperator {
public:
    /// `connections` and `mass` [kg] must outlive it.
    TangentOperator(const StructuralConnections& connections, const LaneVector<double>& mass);

    /// Finds it for present places. @param step h [s]
    void update(const VectorArray& position, double step);

    /// Writes its product with u [m/s], both by slots from the body's first on, component c at [c * stride] [kg m/s].
    /// @return u A u [J]
    double multiply(const float* u, float* product, std::size_t stride);

    /// Writes its diagonal 3x3 blocks, xx yy zz xy xz yz, by slots [kg].
    void findDiagonal(const std::array<double*, 6>& diagonal) const;

    /// Calls visit(lower, upper, root, across) for every connection: (root root^T + across) acts between the two [kg].
    template <typename Visit>
    void forEachConnection(Visit&& visit) const;

    /// How fast the dilatation of an object changes with the velocity of one around it, times the root of its weight h^2 B.
    struct Slope {
        ObjectIndex object;
        Vec3 gradient; ///< [sqrt(kg)]
    };
    /// Writes slopes of an object's dilatation, its own last; none when that has no weight.
    void slopesOf(ObjectIndex object, std::vector<Slope>& slopes) const;

    bool hasBulk() const { return m_hasBulk; }
    const StructuralConnections& connections() const { return *m_connections; }
    const RunSlots& places() const { return m_places; }

private:
    void findConnections(const VectorArray& position, double step);
    void findGradients(const VectorArray& position, double step);
    kernels::SlotTangent view(std::size_t vectorStride) const;
    float* array(std::size_t index) { return &m_values[index * m_stride]; }
    const float* array(std::size_t index) const { return &m_values[index * m_stride]; }
    std::size_t rootOf(std::size_t d) const { return 5 * d; }
    std::size_t acrossOf(std::size_t d) const { return 5 * d + 3; }
    std::size_t stiffnessOf(std::size_t d) const { return 5 * d + 4; }

    const StructuralConnections* m_connections;
    const LaneVector<double>* m_mass;
    RunSlots m_places;
    std::size_t m_directions;
    std::size_t m_stride;
    std::size_t m_massArray;
    std::size_t m_gradient;     ///< the first of 9 arrays
    std::size_t m_pressure;     ///< the first of 9 arrays
    LaneVector<float> m_values; ///< arrays by slots, at multiples of the stride
    bool m_hasBulk = false;
};

template <typename Visit>
void TangentOperator::forEachConnection(Visit&& visit) const
{
    const Lattice& lattice = m_connections->aggregate().lattice;
    for (std::size_t d = 0; d < m_directions; ++d)
        forEachPair(lattice, d, 0, lattice.size(), [&](ObjectIndex lower, ObjectIndex upper) {
            if (m_connections->stiffness()[d][lower] > 0) {
                const std::size_t slot = m_places.of(lower);
                visit(lower, upper,
                      Vec3(array(rootOf(d))[slot], array(rootOf(d) + 1)[slot], array(rootOf(d) + 2)[slot]),
                      static_cast<double>(array(acrossOf(d))[slot]));
            }
        });
}

} // namespace knead
