#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/skin/skin.h"

#include <cstddef>
#include <span>
#include <vector>

namespace knead {

/// Edges of a surface that is filled anew, by the spacing.
inline constexpr double refilledEdge = 0.7;

/// Of that surface. A body of few objects has many more only where it is torn about, and filling that takes minutes.
std::size_t mostRefilledTriangles(const Aggregate& aggregate);

/// Moves the carriers of a skin so that its points come nearer to where they shall be: what these lack is shared out to the carriers
/// that they have it from, again and again (simultaneous iterative reconstruction).
/// @param wanted one per point of the skin [m]
/// @param displacements of the carriers, changed [m]
void fitToSurface(const Skin& skin, std::span<const Vec3> wanted, std::vector<Vec3>& displacements);

/// Adds the vertices and triangles of another mesh, with their faces.
void append(TriangleMesh& all, const TriangleMesh& mesh);

} // namespace knead
