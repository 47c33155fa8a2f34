#pragma once

#include "core/geometry/triangle_mesh.h"

#include <cstddef>

namespace knead {

/// A surface without the faults that its triangles show by themselves.
struct CleanSurface {
    TriangleMesh mesh;
    std::size_t removed = 0; ///< triangles that were there twice, or cancelled each other
    std::size_t flipped = 0; ///< triangles that ran the other way than those around them
};

/// Of triangles with the same corners one is kept; none when as many face one way as the other, as where two welded boxes
/// share a face. Then each stretch of triangles that share edges in pairs is turned so that all face one way: the way of
/// most of its area. A clean surface stays as it is.
CleanSurface cleanSurface(const TriangleMesh& mesh);

} // namespace knead
