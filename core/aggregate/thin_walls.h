#pragma once

#include "core/aggregate/aggregate.h"
#include "core/aggregate/thin_blocks.h"

namespace knead {

/// Walls of less than 1.75 cells keep a part of the weights of their connections: .83 at one cell and below, all from 1.75 on.
///
/// Their objects lie in two or three layers, and at many tilts no family has enough of its middles near the middle of the wall: such a
/// wall bends too stiffly whatever its weights, by 1.5 on the mean and up to 2. So it is made to bend nearly as it should on the mean, and
/// stretches too easily. Volumes, and with them masses, stay.
/// @param blocks with their shapes
void loosenThinWalls(Aggregate& aggregate, const std::vector<std::vector<ThinBlock>>& blocks);

} // namespace knead
