#pragma once

#include "core/geometry/triangle_mesh.h"

#include <TopoDS_Shape.hxx>

namespace knead {

/// A solid with a flat face for each triangle of a closed mesh, edges and vertices shared; a solid for each closed shell, with
/// those inside as its voids. For what smooth faces cannot describe.
/// @param mesh closed, outward [m]; triangles that are shorter than a point are left out
/// @return a solid, or a compound of several [mm]
/// @throws std::runtime_error, when the mesh bounds no volume
TopoDS_Shape facetedSolid(const TriangleMesh& mesh);

} // namespace knead
