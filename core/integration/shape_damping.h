#pragma once

#include "core/aggregate/pieces.h"
#include "core/mechanics/object_state.h"

namespace knead {

/// Shape damping: relaxes the velocities v of each connected piece towards a motion that does not change its shape,
///     v += (1 - exp(-rate dt)) (u - v).
/// A free piece has u = V + W x r, the rigid motion with its momenta, and keeps those: nothing brakes its flight. A piece with
/// held objects has u = their mean velocity, and comes to rest on what holds it. So what was cut off falls like a stone.
/// @param rate [1/s]
/// @param pieces of the body's objects, see PiecesOfBody
/// @return energy taken out [J]
double dampShape(ObjectState& state, double rate, double dt, const Pieces& pieces);

} // namespace knead
