#pragma once

#include "core/aggregate/aggregate.h"
#include "core/mechanics/rigid_surface.h"
#include "core/mechanics/vector_array.h"

namespace knead {

/// How far a rigid surface has gone into the material of a body: largest over its objects of r - d [m], d from the object to
/// the surface (negative inside of it), r the depth of the object below its skin, a third of a spacing for those deeper than a
/// spacing. 0 or less: they do not touch. On all threads; same bits for any number.
/// @param position of the objects now
double overlapOf(const RigidSurface& surface, const VectorArray& position, const Aggregate& aggregate);

} // namespace knead
