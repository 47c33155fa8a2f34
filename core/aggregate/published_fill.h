#pragma once

#include "core/aggregate/aggregate.h"
#include "core/geometry/triangle_mesh.h"

namespace knead {

/// Fills a closed surface as published in 2000: spheres of radius a/2 on a cubic lattice wherever their centers are inside,
/// each connected to its up to 26 neighbors with one stiffness for all (weight w the same, so that the sum of k l^2 is
/// 6 E V). Kept to repeat published scenes: it is softer at the surface than fill() and not isotropic (Zener ratio 2.33 with
/// equal stiffness). The lattice is centered in the box of the mesh; a bar of 5 x 5 x 17 spacings gives the 425 objects of
/// the paper.
/// @param spacing a [m], > 0
/// @throws Problem when the mesh is empty or not closed, the spacing is not positive, or no center
///         is inside
Aggregate fillAsPublished(const TriangleMesh& mesh, double spacing);

} // namespace knead
