#pragma once

#include "core/geometry/triangle_mesh.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace knead {

/// Splits triangles until no edge is longer than `maximumEdge` [m], so that a flat face can bend. The surface keeps its shape,
/// faces and orientation; a closed mesh stays closed, since both sides of an edge share the new vertex.
/// Coarser when more than about `maximumTriangles` would be needed, or half of that in addition to those that are there: a mesh is
/// never refused.
/// @pre maximumEdge > 0
TriangleMesh refine(const TriangleMesh& mesh, double maximumEdge, std::size_t maximumTriangles = 400'000);

/// The same, where the surface is carried elsewhere: edges are as long as there. Where they get 16 times as long as they are in the
/// mesh, the surface is torn, and they stay.
/// @throws Problem when a vertex is carried nowhere
/// @param carry where vertices are taken, as many as it is given; those that it was given before come first again
TriangleMesh refineWhereCarried(const TriangleMesh& mesh, double maximumEdge, std::size_t maximumTriangles,
                                const std::function<const std::vector<Vec3>&(const std::vector<Vec3>&)>& carry);

/// Every edge gets a vertex in its middle, so that four triangles take the place of each.
TriangleMesh halveEdges(const TriangleMesh& mesh);

} // namespace knead
