#pragma once

#include "core/aggregate/lattice.h"

#include <array>
#include <functional>

namespace knead {

/// Calls visit(cell) for all cells that a triangle comes closer to than `margin`, and perhaps a few more next to it.
/// Cell (u, v, w) lies between the nodes (u, v, w) and (u + 1, v + 1, w + 1).
/// @param corners in lattice coordinates
/// @param margin [cells]
void forEachTouchedCell(const std::array<Vec3, 3>& corners, double margin,
                        const std::function<void(const Lattice::Node& cell)>& visit);

} // namespace knead
