#pragma once

#include "core/aggregate/aggregate.h"
#include "core/aggregate/material.h"
#include "core/mechanics/object_state.h"

#include <array>
#include <memory>
#include <vector>

namespace knead {

/// The structural connections of one body: parameters by direction, and the forces they give.
///
/// Force on an object o from the connection to p (eqs 2, 3 and 5 of the paper, with the sign that attracts when stretched):
///     F = [k (|d| - l) + b (v_p - v_o).n] n,   d = x_p - x_o,  n = d / |d|
/// There is no friction in structural connections: it would brake a rigid rotation.
///
/// Calibration (18 neighbors, spacing a, cut-cell weight w, shear modulus mu): k = mu a w. Central forces alone give
/// Poisson's ratio 1/4; the rest is a volumetric energy per object, 1/2 (lambda - mu) V theta^2 with
/// theta = ln det F, F the least-squares deformation gradient over the object's connections. It is absent at 1/4.
///
/// Objects are worked on in blocks that depend on the lattice only. A block computes every connection with an end in it and
/// writes to its own objects alone, so no two threads write to one place and the bits do not depend on their number;
/// connections between blocks are computed by both, with results that are exact opposites.
class StructuralConnections {
public:
    StructuralConnections(std::shared_ptr<const Aggregate> aggregate, const Material& material);

    /// Changes stiffness and damping; nominal lengths stay as they are.
    void setMaterial(const Material& material);

    /// Writes state.force and state.damping. Reads positions and velocities.
    void computeForces(ObjectState& state);

    /// Elastic energy at present positions, volumetric part included [J].
    double energy(const ObjectState& state);

    /// Largest angular frequency of the body about its present shape, with contacts on it, from above [rad/s].
    /// At Poisson's ratio 1/4 and below it is the bound of bounds per object, omega^2 <= max 2 lambda_max(K_ii) / m_i; above,
    /// where that would cost a factor in the time step, a power iteration with a margin. The iteration starts from the
    /// mode found last time.
    double largestFrequency(ObjectState& state);

    std::size_t count() const { return m_count; } ///< connections of stiffness > 0

    /// b / k, the same for all connections of the body [s].
    double dampingTime() const { return m_dampingTime; }

    /// Stiffness for contacts of an object [N/m]: as much as adds a twelfth or so to omega^2. 0 <= k <= 3 mu a.
    double contactStiffness(ObjectIndex object) const;

private:
    using DirectionArray = std::array<std::vector<double>, Lattice::directionCount>;

    void findInverseShapes();
    void computeStress(const ObjectState& state);
    /// Connections of one direction whose lower ends are first .. last; the upper ends are `offset` further on.
    struct Chunk {
        std::size_t first;
        std::size_t last;
        std::size_t offset;
    };
    void addForcesOfBlock(ObjectState& state, std::size_t begin, std::size_t end);
    void addForcesOfChunk(ObjectState& state, std::size_t d, const Chunk& chunk, std::size_t begin,
                          std::size_t end) const;
    double bondBound(const ObjectState& state) const;
    double iteratedFrequency(ObjectState& state);

    std::shared_ptr<const Aggregate> m_aggregate;
    DirectionArray m_stiffness;     ///< k [N/m] at the lower object; 0 = no connection
    DirectionArray m_nominalLength; ///< l [m]
    std::size_t m_count = 0;
    std::size_t m_blockSize = 0; ///< objects per block
    double m_dampingTime = 0;
    double m_shearModulus = 0;                         ///< mu [Pa]
    double m_volumetricModulus = 0;                    ///< lambda - mu [Pa]
    std::array<std::vector<double>, 6> m_inverseShape; ///< (sum k o o^T)^-1 in lattice axes: uu vv ww uv uw vw [m/N]
    std::array<std::vector<double>, 9> m_stress;       ///< see kernels::StressArguments
    std::vector<double> m_theta;                       ///< ln det F
    VectorArray m_mode;                                ///< of the largest frequency, as found last
};

} // namespace knead
