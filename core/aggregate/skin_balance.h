#pragma once

#include "core/aggregate/aggregate.h"
#include "core/aggregate/cut_cells.h"
#include "core/task/task_control.h"

#include <cstdint>
#include <vector>

namespace knead {

/// Changes the weights of connections at the skin so that uniform stress along a free skin is in balance there.
///
/// In uniform strain e the connections of an object i pull at it with T_i : e, and the material at its part g_i of the skin (see
/// skinAreas()) with sym(g_i, d) : e, d being the unit tensor, where all weights inside are 1. Stress along a free skin has nothing
/// of the latter, so it moves nothing when
///   T_i = sum_b +-w_b D_b D_b D_b / |D_b|^2 = c_i sym(g_i, d)     with any c_i.
/// It holds by itself where the skin goes through nodes. Where it cuts cells, weights of joinCells() and withFittedMoments() miss it by
/// up to as much as the skin bears, and the outermost objects of a hole strain 10 to 25 % less than the material does. So, with d_b
/// the change of a weight and R_i the part of T_i that is not along sym(g_i, d), other changes are made small together with what is left:
///   sum (d_b / w_b^1.1)^2 + 200 sum |R_i|^2 + 200 sum_m (sum_b d_b p_m(x_b))^2,
/// p_m being the ten quadratic polynomials in blocks of five cells, for each family of parallel connections: walls stay as stiff in
/// tension and bending as they were. A dozen steps of conjugate gradients with the diagonal as preconditioner are enough. Not
/// everywhere there are as many unknowns as conditions: a third to two thirds of the imbalance are left.
///
/// Walls of less than 2.5 cells keep their weights, which make up for what the lattice cannot do there, unless others are so near that
/// they share blocks; up to 3.5 cells it passes over. Family sums stay to the last digits, and volumes go with the weights.
///
/// Stress at the top of a hole of 6 to 16 cells across in a strip that is pulled (Heywood), at 13 spacings: -7 to +9 %, at 6.8 cells
/// -11 %; anywhere around it up to 17 % of the largest off, by Kirsch. Layers that withoutScraps() keeps have a part in that: without
/// them it was up to +17 %. Filling takes two to three times as long where all of the skin cuts cells: .5 to 1 us per connection
/// there, one core.
/// The result does not depend on the number of threads.
/// @param isSurface per object, as in CellCorners
/// @throws Cancelled
Aggregate withBalancedSkin(const CutCells& cells, Aggregate aggregate, const std::vector<std::uint8_t>& isSurface,
                           TaskControl& control);

} // namespace knead
