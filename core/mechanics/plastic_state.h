#pragma once

#include "core/aggregate/lattice.h"
#include "core/mechanics/vector_array.h"

#include <array>
#include <cstdint>
#include <memory>
#include <tuple>
#include <type_traits>
#include <vector>

namespace knead {

/// A number per connection, by direction, at the lower object.
using DirectionArray = std::array<LaneVector<double>, Lattice::directionCount>;

/// What of a body has flowed. Arrays are empty until something can.
struct PlasticState {
    DirectionArray nominalLength;             ///< l [m]
    std::array<LaneVector<double>, 6> metric; ///< C per object, in lattice axes: uu vv ww uv uw vw; det C = 1
    LaneVector<double> equivalentStrain;      ///< alpha per object: sum of all flow
    LaneVector<double> damage;                ///< per object: what of it counts towards breaking, see tensor_law.h
};

/// Pointers to the arrays of a group, one by one.
template <typename Pointer, typename Arrays>
auto pointersTo(Arrays& arrays)
{
    std::array<Pointer, std::tuple_size_v<std::remove_const_t<Arrays>>> pointers{};
    for (std::size_t n = 0; n < pointers.size(); ++n)
        pointers[n] = arrays[n].data();
    return pointers;
}

/// What rubberlike objects of a body have beside. Arrays are per object but for those by direction.
struct RubberBody {
    bool isWhole = false;           ///< all objects are rubberlike, of one material
    LaneVector<double> isRubber;    ///< 1 or 0; flat surroundings have no F, so springs must hold them
    LaneVector<double> secondShare; ///< see RubberNumbers; empty where all are of one material
    LaneVector<double> inverseChain;
    LaneVector<double> firstScale;
    bool springsAreKnown = false;
    DirectionArray springShare;  ///< of k, for the spring of a connection; empty where all are alike
    DirectionArray springLength; ///< nominal length of that spring [m]
};

/// Numbers and working space of a body with the law of tensor_law.h. All are per object but for the arrays by direction.
struct TensorBody {
    LaneVector<double> volume;       ///< V, less what connections that broke take of it [m^3]
    LaneVector<double> tensionShare; ///< of K in tension: less where broken, else 1; empty: nothing is
    LaneVector<double> energy;       ///< at the stress computed last, where that was asked for [J]

    /// Of each object; empty where all are of one material.
    LaneVector<double> shear;       ///< mu [Pa]
    LaneVector<double> bulk;        ///< K [Pa]
    LaneVector<double> yieldStress; ///< [Pa]
    LaneVector<double> hardening;   ///< [Pa]
    LaneVector<double> flowTime;    ///< [s]
    LaneVector<double> shearDamage; ///< see kernels::TensorLawNumbers

    std::unique_ptr<RubberBody> rubber; ///< null: nothing is rubberlike

    PlasticState flowed;           ///< after the last flow; where S is 1 the same as before it
    double dissipatedEnergy = 0;   ///< by it [J]
    double flowWork = 0;           ///< see StructuralConnections::flowWork() [J]
    LaneVector<double> share;      ///< S of it; empty: there was none yet
    LaneVector<double> dissipated; ///< [J]
    LaneVector<double> dilatation; ///< ln J
    DirectionArray strain;         ///< ln(L / l) per connection
    DirectionArray affine;         ///< ln(|F D| / l_b) per object
    DirectionArray lengthening;    ///< D^T C' D / D^T C D per object

    std::vector<std::uint8_t> blockFlows;      ///< per block of objects: something of it flowed
    std::vector<std::uint8_t> blockLengthened; ///< per block: nominal lengths after the flow may not be those before
    std::size_t reach = 0; ///< the upper end of a connection is at most so much further on than the lower one
};

} // namespace knead
