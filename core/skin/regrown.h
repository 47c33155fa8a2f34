#pragma once

#include "core/aggregate/aggregate.h"
#include "core/aggregate/connection_id.h"
#include "core/geometry/vec3.h"
#include "core/skin/carried_cracks.h"

#include <span>
#include <vector>

namespace knead {

/// Of skins of a body that have grown together, those that make pieces one again: where two pieces were parted, most of both sides meets
/// there now, and has grown together. Pieces that lean on each other elsewhere, or have hardly begun to heal, are pieces that hold on
/// to each other. What has grown together within a piece is in it, too.
/// @param displacements of the objects since the body was filled [m]
/// @param broken of `present`
/// @param pairs of its objects
std::vector<GrownTogether> regrown(const Aggregate& present, std::span<const Vec3> displacements,
                                   std::span<const BrokenConnection> broken, std::span<const GrownTogether> pairs);

} // namespace knead
