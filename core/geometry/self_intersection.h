#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/task/task_control.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace knead {

/// Where a surface passes through itself.
struct Crossings {
    std::size_t count = 0; ///< pairs of triangles that cross
    std::vector<std::array<std::uint32_t, 2>>
        some;  ///< such pairs, from all over the surface; the lower triangle first, sorted
    Box where; ///< around the lines along which they cross [m]; empty when none do
};

/// Finds the pairs of triangles that pass through each other by more than a 10^-7 of the largest side of the surface's box, about
/// what single precision leaves of a place. Less is touching, and so is lying on each other. Triangles with a common corner count when
/// they cross beyond it; those with a common edge cannot. A surface that passes through another exactly along edges of both is not
/// seen there.
///
/// O(n lg n) plus the pairs of overlapping boxes, on all threads; the same bits for any number of them.
/// @param most in Crossings::some
/// @throws Cancelled
Crossings findCrossings(const TriangleMesh& mesh, TaskControl& control = TaskControl::none(), std::size_t most = 100);

/// The same on the calling thread alone: for looks in the background, which leave processors to what a person waits for.
Crossings findCrossingsAlone(const TriangleMesh& mesh, std::size_t most = 100);

} // namespace knead
