#pragma once

#include "core/aggregate/aggregate.h"
#include "core/geometry/triangle_mesh.h"

#include <vector>

namespace knead {

/// Points on a surface, about half a spacing apart, that stand for it when something is touched. Each is a point of the surface
/// itself; corners and edges are among them, so that nothing sharp reaches beyond. Their areas add up to that of the surface.
/// @param orientation 1 where triangles face outwards, -1 where all are inside out
std::vector<SkinPoint> skinPoints(const TriangleMesh& mesh, const Lattice& lattice, double orientation = 1);

} // namespace knead
