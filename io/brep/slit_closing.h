#pragma once

#include "core/geometry/triangle_mesh.h"

namespace knead {

/// Closes the narrow slits that triangulation may leave between faces of a closed solid that meet almost tangentially:
/// each loop of open edges gets triangles of its own vertices, and folds without volume go. Wide holes stay, since something is missing there.
TriangleMesh closeSlits(TriangleMesh mesh);

} // namespace knead
