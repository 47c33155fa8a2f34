#pragma once

#include "core/geometry/triangle_mesh.h"

#include <cstddef>

namespace knead {

/// Turns triangles so that neighbors agree on which side is out; of each connected piece the smaller share is turned.
/// A piece with one side only, like a Moebius strip, stays as it is.
/// @return how many were turned
std::size_t orient(TriangleMesh& mesh);

/// Turns closed pieces that are inside out and in no other closed piece, where they would be a void.
/// @return whether there was one
bool turnOutward(TriangleMesh& mesh);

} // namespace knead
