#pragma once

#include "core/integration/implicit_system.h"

#include <array>
#include <memory>
#include <vector>

namespace knead {

/// Approximates the inverse of an implicit step's system in two levels, so that the number of iterations depends neither on
/// the stiffness of the material nor on the size of a body:
///     z = D^-1 r + P (P^T A P)^-1 P^T r
/// D holds the 3x3 blocks on the diagonal of A: motion of an object against its neighbors. P holds the six rigid motions of
/// every cluster: what whole regions do. A cluster is what hangs together of a block of the lattice, or a rigid body.
///
/// The clusters and the factor of P^T A P may be older than A: any symmetric positive definite approximation converges to the same
/// solution, more slowly the older it is.
class RigidModePreconditioner {
public:
    RigidModePreconditioner();
    ~RigidModePreconditioner();
    RigidModePreconditioner(RigidModePreconditioner&&) noexcept;
    RigidModePreconditioner& operator=(RigidModePreconditioner&&) noexcept;

    /// Takes over the diagonal blocks of A: cheap, with every change.
    void updateBlocks(const ImplicitSystem& system);

    /// Finds clusters from the live connections, and assembles and factors P^T A P at the present places.
    void updateClusters(const ImplicitSystem& system);

    /// z = approximate inverse times r. Several threads; same bits for any number.
    void apply(const VectorArray& r, VectorArray& z);

    std::size_t clusters() const { return m_center.size(); }

private:
    class Coarse;
    static constexpr std::uint32_t none = 0xffffffffU;

    void findClusters(const ImplicitSystem& system);
    void measureClusters(const ImplicitSystem& system);
    void assemble(const ImplicitSystem& system);

    std::array<std::vector<double>, 6> m_inverse; ///< of the diagonal blocks: xx yy zz xy xz yz; 0 for held objects
    std::vector<std::uint32_t> m_clusterOf;       ///< per row; none for held objects
    VectorArray m_arm;                            ///< per row, from the center of its cluster, by the cluster's size
    std::vector<std::uint8_t> m_turnsOnly;        ///< per row: 1 for the angular velocity of a rigid body
    std::vector<Vec3> m_center;                   ///< per cluster [m]
    std::vector<double> m_size;                   ///< per cluster [m]
    std::vector<std::uint32_t> m_members;         ///< rows by cluster, ascending
    std::vector<std::size_t> m_membersBegin;      ///< per cluster, into m_members, and the end
    std::unique_ptr<Coarse> m_coarse;
};

} // namespace knead
