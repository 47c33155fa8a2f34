#pragma once

#include "core/geometry/triangle_mesh.h"

namespace knead {

/// A surface of fewer triangles: vertices in one cube of `size` [m] become one where their normals point to the same side of it, at the
/// place that is nearest to the planes of all triangles at them, so that edges and corners stay where they are (quadric error
/// clustering, Lindstrom 2000, "Out-of-core simplification of large polygonal models"). The two sides of a wall stay apart. Triangles
/// that collapse are gone, with the faces that they were of. A closed surface stays one as far as its volume goes, though edges may
/// meet more than two triangles.
/// @pre size > 0
TriangleMesh clustered(const TriangleMesh& mesh, double size);

} // namespace knead
