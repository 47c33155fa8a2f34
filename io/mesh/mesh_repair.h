#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/message/message.h"

#include <string>
#include <vector>

namespace knead {

/// Removes pairs of triangles that lie on each other back to back: a fold without volume. Where the triangles of a
/// closed surface are folded, this leaves the surface closed.
TriangleMesh withoutFolds(const TriangleMesh& mesh);

struct RepairedMesh {
    TriangleMesh mesh;
    std::vector<Message> repairs; ///< as Part::repairs; empty when nothing had to be done
};

/// Removes triangles that are there twice, turns those that face the other way than their neighbors, turns closed
/// surfaces outward and closes holes that are small (below 1 % of the area) and nearly flat.
/// @param mesh welded
/// @param capsFlatOpenings closes nearly flat holes of any size
RepairedMesh repaired(TriangleMesh mesh, bool capsFlatOpenings = false);

} // namespace knead
