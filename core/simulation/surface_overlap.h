#pragma once

#include "core/aggregate/aggregate.h"
#include "core/mechanics/rigid_surface.h"
#include "core/mechanics/vector_array.h"

namespace knead {

/// How far a rigid surface has gone beyond objects of a body that are below its skin [m]; 0 or less: not at all. On all threads; same
/// bits for any number. What it does at the skin, Contacts::deepest() says.
/// @param position of the objects now
double overlapOf(const RigidSurface& surface, const VectorArray& position, const Aggregate& aggregate);

} // namespace knead
