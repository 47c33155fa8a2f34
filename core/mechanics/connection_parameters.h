#pragma once

#include "core/mechanics/connection_data.h"

namespace knead {

/// Finds all that follows from the materials and from what has changed; nominal lengths stay, broken connections stay
/// broken.
void updateMaterials(ConnectionData& data);

/// Puts earlier changes back.
void restoreChanges(ConnectionData& data, ConnectionChanges changes);

/// Makes arrays of what can flow that have none yet.
void makeLengthsOwn(ConnectionData& data);

/// K^-1 of an object from K = sum k o o^T; none where that is nearly flat.
void setInverseShape(ConnectionData& data, ObjectIndex object, const Mat3& shape);

/// What the laws of tensor_law.h and hyperelastic_law.h take of the materials. @pre data.tensors
kernels::TensorLawNumbers tensorNumbers(const ConnectionData& data);

/// Stiffness for contacts of an object [N/m].
double contactStiffness(const ConnectionData& data, ObjectIndex object);

/// Lattice vector of a direction, in units of the spacing.
inline Vec3 latticeVector(std::size_t d)
{
    const Lattice::Node& o = Lattice::directions[d];
    return {static_cast<double>(o[0]), static_cast<double>(o[1]), static_cast<double>(o[2])};
}

} // namespace knead
