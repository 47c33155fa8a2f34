#pragma once

#include "core/aggregate/aggregate.h"
#include "core/geometry/triangle_mesh.h"
#include "core/task/task_control.h"

namespace knead {

struct FillOptions {
    double spacing = 0.002;        ///< lattice spacing a [m], > 0
    double minimumFraction = 0.25; ///< cells with less material are dropped
    std::size_t maximumObjects = 20'000'000;
};

/// Fills a closed surface with objects.
///
/// The cells of the lattice are cut exactly by the surface: every triangle is clipped to the cells it crosses, and the
/// divergence theorem along rows gives each cell's volume. No ray is cast and no tolerance is used, so the result is
/// exact for the triangles, and a small leak costs a small error instead of a column.
/// Cells with at least minimumFraction of material are kept; their corners are the objects; connection weights are the
/// material fractions of the cells around them (cut-cell weights). The lattice is centered on the box of the part.
/// The result does not depend on the number of threads.
///
/// @throws std::runtime_error, in a sentence, when the mesh is empty or not closed, when the spacing is not positive and
///         finite, when no cell holds enough material, or when more than maximumObjects would be needed.
/// @throws Cancelled
Aggregate fill(const TriangleMesh& mesh, const FillOptions& options, TaskControl& control = TaskControl::none());

/// The spacing that puts `cells` cells along the longest side of the box of the mesh [m].
double spacingForCellsAcross(const TriangleMesh& mesh, double cells);

/// The spacing that gives about `objects` objects [m], from volume and area.
double spacingForObjectCount(const TriangleMesh& mesh, double objects);

} // namespace knead
