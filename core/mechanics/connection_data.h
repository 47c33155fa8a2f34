#pragma once

#include "core/aggregate/lattice_runs.h"
#include "core/aggregate/lattice_sweep.h"
#include "core/aggregate/material_map.h"
#include "core/aggregate/pieces.h"
#include "core/kernels/tensor_law.h"
#include "core/mechanics/connection_law.h"
#include "core/mechanics/object_state.h"
#include "core/mechanics/plastic_state.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace knead {

/// What has become of the connections of a body since it was made. Arrays are empty until they are needed.
struct ConnectionChanges {
    PlasticState plastic;
    LaneVector<double> restDilatation;    ///< per object: theta of no pressure
    double keptVolume = 0;                ///< without pressure, see keepVolume() [m^3]; 0: sum V e^rest still is it
    std::vector<BrokenConnection> broken; ///< in the order of breaking
};

/// A number per object or per connection of a direction; that of all where `each` is empty.
inline kernels::ObjectNumber numberOf(const LaneVector<double>& each, double all)
{
    return {each.empty() ? nullptr : each.data(), all};
}
inline double valueAt(const kernels::ObjectNumber& number, std::size_t i)
{
    return number.each != nullptr ? number.each[i] : number.all;
}

/// All that is known of the structural connections of one body. What is done with it is in connection_parameters.h,
/// connection_stress.h, connection_forces.h, connection_flow.h, connection_volume.h, connection_fracture.h,
/// connection_frequency.h and rubber_connections.h; StructuralConnections puts it together.
struct ConnectionData {
    ConnectionData(std::shared_ptr<const Aggregate> aggregate, const MaterialMap& materials);

    /// What the connections of a block give to the objects from `begin` on: the last ones of the block and those
    /// behind it.
    struct Margin {
        std::size_t begin = 0;
        VectorArray force;
        VectorArray damping;
    };

    RubberBody* rubber() const { return tensors ? tensors->rubber.get() : nullptr; }
    bool isRubber(std::size_t object) const { return rubber() != nullptr && rubber()->isRubber[object] > 0; }
    const PlasticState& plasticState() const { return hasTrial ? tensors->flowed : changes.plastic; }
    void forgetEnergy() { energyAt.resize(0); }

    /// l of the connections of a direction, at the lower object [m].
    kernels::ObjectNumber nominalLengths(std::size_t d) const
    {
        return numberOf(plasticState().nominalLength[d], aggregate->lattice.direction(static_cast<int>(d)).norm());
    }
    double nominalLength(const ConnectionId& connection) const
    {
        return valueAt(nominalLengths(connection.direction), connection.lower);
    }

    /// The two objects of a connection that was made, the lower one first.
    std::array<ObjectIndex, 2> endsOf(const ConnectionId& connection) const
    {
        return {connection.lower, upperEnd(aggregate->lattice, connection)};
    }

    /// Calls visit(neighbor, connection) for the connections of an object that were made, broken ones among them.
    template <typename Visit>
    void forEachConnectionMade(ObjectIndex object, Visit&& visit) const
    {
        forEachNeighbor(aggregate->lattice, object, [&](ObjectIndex neighbor, const ConnectionId& connection) {
            if (aggregate->weight[connection.direction][connection.lower] > 0)
                visit(neighbor, connection);
        });
    }

    /// The same for live ones.
    template <typename Visit>
    void forEachConnection(ObjectIndex object, Visit&& visit) const
    {
        forEachConnectionMade(object, [&](ObjectIndex neighbor, const ConnectionId& connection) {
            if (stiffness[connection.direction][connection.lower] > 0)
                visit(neighbor, connection);
        });
    }

    std::shared_ptr<const Aggregate> aggregate;
    const MaterialMap* materials;
    ConnectionLaws laws;
    std::vector<double> borneVolume; ///< V [m^3]
    DirectionArray stiffness;        ///< k [N/m] at the lower object; 0 = no connection
    ConnectionChanges changes;
    std::uint64_t lengthVersion = 0;
    std::size_t count = 0;
    std::vector<LatticeRun> runs;            ///< for forces
    std::vector<LatticeRun> stressRuns;      ///< for the volumetric stress
    LaneVector<std::uint32_t> hasBehind;     ///< see neighborsBehind()
    std::size_t blockSize = 0;               ///< objects per block
    std::vector<Margin> margins;             ///< per block
    DirectionArray dampingTime;              ///< b / k [s] at the lower object; empty: the same for all
    std::vector<std::uint32_t> brokenAround; ///< per object: bit d for a broken forward connection, bit
                                             ///< directionCount + d for a backward one; empty: none broken
    double structuralFriction = 0;
    bool hasBulk = false;
    LaneVector<double> bulk;                        ///< (lambda - mu) V [J]; 0 where surroundings are too thin
    std::vector<ObjectIndex> flat;                  ///< those: they have no dilatation
    std::array<LaneVector<double>, 6> inverseShape; ///< (sum k o o^T)^-1 in lattice axes: uu vv ww uv uw vw [m/N]
    std::array<VectorArray, 3> stress;              ///< by lattice column, see kernels::StressArguments
    LaneVector<double> theta;                       ///< ln det F less its rest value
    std::unique_ptr<TensorBody> tensors;            ///< null where none yields or is rubberlike
    bool hasTrial = false;                          ///< a flow that is not accepted yet is in tensors
    VectorArray mode;                               ///< of the largest frequency, as found last
    VectorArray energyAt;                           ///< positions of the energy found last; none: it is not known
    double energy = 0;                              ///< that [J]
};

} // namespace knead
