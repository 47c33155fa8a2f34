#pragma once

#include "core/aggregate/aggregate.h"
#include "core/mechanics/object_state.h"
#include "core/mechanics/structural_connections.h"
#include "core/skin/new_filling.h"

#include <span>
#include <vector>

namespace knead {

/// What objects of a body that is filled anew take over from those that were there before: numbers by moving least squares over
/// the old objects of its piece around a new one, as they lie now.
///
/// Elastic strain goes with the material, not with the lattice: of H = ln sqrt(F C^-1 F^T) of the old objects, whose F is lost, the
/// new ones have F = I and
///     C = exp(-2 dev H),  theta_rest = -tr H,
/// so that their stress is what it was. Hardening and damage are carried as numbers.
class CarriedState {
public:
    /// @param before with its state, both read while this lives
    /// @param filling of where the objects of `before` are now, read while this lives
    CarriedState(const StructuralConnections& before, const ObjectState& state, const NewFilling& filling);

    /// Velocities, each piece with the linear and angular momentum that it had: whatever the fit lacks is a rigid motion more.
    /// @param mass of the new objects [kg]
    VectorArray velocities(const LaneVector<double>& mass) const;

    /// What has flowed, of a material with the law of tensor_law.h. Volumes of no pressure add up to what they were.
    /// @param materials of the old objects
    StructuralConnections::Changes changes(const MaterialMap& materials) const;

private:
    struct Around { ///< an old object and its part in a new one
        ObjectIndex object;
        double share;
    };
    std::span<const Around> around(ObjectIndex object) const
    {
        return {m_around.data() + m_first[object], m_first[object + 1] - m_first[object]};
    }
    void findAround();

    const StructuralConnections& m_before;
    const ObjectState& m_state;
    const NewFilling& m_filling;
    const Aggregate& m_aggregate;
    std::vector<std::size_t> m_first;
    std::vector<Around> m_around;
};

} // namespace knead
