#pragma once

#include "core/geometry/triangle_mesh.h"

#include <cstddef>

namespace knead {

/// Splits triangles until no edge is longer than `maximumEdge` [m], so that a flat face can bend. The surface keeps its shape,
/// faces and orientation; a closed mesh stays closed, since both sides of an edge share the new vertex.
/// Coarser when more than about `maximumTriangles` would be needed, or half of that in addition to those that are there: a mesh is
/// never refused.
/// @pre maximumEdge > 0
TriangleMesh refine(const TriangleMesh& mesh, double maximumEdge, std::size_t maximumTriangles = 400'000);

/// Every edge gets a vertex in its middle, so that four triangles take the place of each.
TriangleMesh halveEdges(const TriangleMesh& mesh);

} // namespace knead
