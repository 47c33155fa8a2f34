#pragma once

#include "core/integration/implicit_system.h"
#include "core/integration/rigid_mode_levels.h"

#include <array>
#include <memory>
#include <vector>

namespace knead {

/// Approximates the inverse of an implicit step's system in levels, so that the number of iterations depends neither on
/// the stiffness of the material nor on the size of a body:
///     z = D^-1 r + P M P^T r,  M about (P^T A P)^-1
/// D holds the 3x3 blocks on the diagonal of A: motion of an object against its neighbors. P holds the six rigid motions of
/// every cluster: what whole regions do. A cluster is what hangs together of a block of four objects along each edge, or a
/// rigid body. M is RigidModeLevels.
///
/// The clusters and M may be older than A: any symmetric positive definite approximation converges to the same
/// solution, more slowly the older it is.
class RigidModePreconditioner {
public:
    /// Takes over the diagonal blocks of A: with every step.
    void updateBlocks(const ImplicitSystem& system);

    /// Takes over what its links add to them: cheap, with every change.
    void updateLinks(const ImplicitSystem& system);

    /// Finds clusters from the live connections, and M at the present places.
    void updateClusters(const ImplicitSystem& system);

    /// z = approximate inverse times r, by slots. Several threads; same bits for any number. @return r z
    double apply(const FloatArray& r, FloatArray& z);

    /// The first part of it, z = D^-1 r, of slots begin .. end: after it finish() does the rest.
    void begin(const FloatArray& r, FloatArray& z, std::size_t begin, std::size_t end) const;
    double finish(const FloatArray& r, FloatArray& z);

    /// r z of momenta by rows: how large they are.
    double sizeOf(const ImplicitSystem& system, const VectorArray& momenta);

    std::size_t clusters() const { return m_clusters.size(); }

private:
    static constexpr std::uint32_t none = 0xffffffffU;
    static constexpr std::size_t lanes = 4; ///< along the edge of a cluster, whose slots begin at multiples of it

    /// A slot whose four are not all of one cluster.
    struct OddSlot {
        std::uint32_t slot;
        std::uint32_t cluster;
    };
    /// The two slots of a rigid body: its cluster's motion as it is.
    struct RigidSlots {
        std::uint32_t slot;
        std::uint32_t cluster;
    };

    void invert(const std::array<LaneVector<double>, 6>& diagonal, std::size_t begin, std::size_t end);
    void findClusters(const ImplicitSystem& system);
    void measureClusters(const ImplicitSystem& system);
    void listSlots(const ImplicitSystem& system);
    void assemble(const ImplicitSystem& system);

    std::array<LaneVector<double>, 6> m_diagonal; ///< blocks by slots, without links: xx yy zz xy xz yz
    std::array<LaneVector<double>, 6> m_linked;   ///< what links add
    std::vector<std::uint32_t> m_linkedRows;      ///< where they do
    std::vector<std::uint8_t> m_isLinked;         ///< per row: whether it is one of these
    std::array<LaneVector<float>, 6> m_inverse;   ///< both together, inverted; 0 for held objects
    std::vector<std::uint32_t> m_clusterOf;       ///< per row; none for held objects
    std::vector<RigidModeLevels::Cluster> m_clusters;
    VectorArray m_arm;                     ///< per row, from the center of its cluster, by the cluster's size
    FloatArray m_slotArm;                  ///< the same by slots
    std::vector<std::uint32_t> m_fours;    ///< slots where four of one cluster begin, by cluster
    std::vector<std::size_t> m_foursBegin; ///< per cluster, into m_fours, and the end
    std::vector<std::int32_t> m_motionOf;  ///< cluster of every four slots; -1: none, or odd
    std::vector<OddSlot> m_odd;            ///< by slot
    std::vector<RigidSlots> m_rigid;
    std::unique_ptr<RigidModeLevels> m_levels;
    std::vector<float> m_load;   ///< of finish(), eight per cluster
    std::vector<float> m_motion; ///< and what it moves by
    FloatArray m_r;              ///< of sizeOf()
    FloatArray m_z;
};

/// A power of two that makes the largest of all components about 1, so that single precision has room for what follows; 1 when
/// all are 0.
double scaleOf(const VectorArray& rows);

} // namespace knead
