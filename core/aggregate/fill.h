#pragma once

#include "core/aggregate/aggregate.h"
#include "core/geometry/triangle_mesh.h"
#include "core/task/task_control.h"

#include <cstdint>
#include <optional>

namespace knead {

/// What to do with a surface that is not closed, or overlaps itself.
enum class DirtySurface : std::uint8_t {
    refuse,        ///< an error when it is not closed; overlaps are not looked for
    windingNumber, ///< cells at holes and overlaps are material where the surface winds around them more than half
};

struct FillOptions {
    double spacing = 0.002;        ///< lattice spacing a [m], > 0
    double minimumFraction = 0.25; ///< cells with less material are dropped, but for those that withoutScraps() keeps
    std::size_t maximumObjects = 20'000'000;
    DirtySurface dirty = DirtySurface::refuse;
    std::optional<Eigen::Index>
        rowAxis; ///< world axis that rows of the lattice run along; none: that of the longest side
};

/// Fills a closed surface with objects.
///
/// The cells of the lattice are cut exactly by the surface: every triangle is clipped to the cells it crosses, and the
/// divergence theorem along rows gives each cell's volume. No ray is cast and no tolerance is used, so the result is
/// exact for the triangles, and a small leak costs a small error instead of a column.
/// Cells with at least minimumFraction of material are kept; their corners are the objects; connections weigh what the
/// cells around them have of material, in thin walls fitted to its moments, and such that uniform stress is in balance
/// at the skin. The lattice is centered on the box of the part.
/// The result does not depend on the number of threads.
///
/// Of dirty surfaces double triangles are removed and flipped ones turned; rows of cells with holes or overlaps in them are
/// decided as RowRepair says, all others are cut exactly. Aggregate::repair says how much that was. Depths around a hole
/// are estimated from how full the cells there are. A surface whose holes are so large that 3 % of the volume is in doubt
/// (the winding number is nearer to a half than to 0 or 1) is refused. A surface without faults gives the same bits either way.
///
/// @throws Problem when the mesh is empty or not closed (or
///         bounds no volume, as above), when the spacing is not positive and
///         finite, when no cell holds enough material, or when more than maximumObjects would be needed.
/// @throws Cancelled
Aggregate fill(const TriangleMesh& mesh, const FillOptions& options, TaskControl& control = TaskControl::none());

/// The spacing that puts `cells` cells along the longest side of the box of the mesh [m].
double spacingForCellsAcross(const TriangleMesh& mesh, double cells);

/// The spacing that gives about `objects` objects [m], from volume and area.
double spacingForObjectCount(const TriangleMesh& mesh, double objects);

} // namespace knead
