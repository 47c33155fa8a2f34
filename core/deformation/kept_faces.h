#pragma once

#include "core/geometry/triangle_mesh.h"

#include <cstdint>
#include <set>

namespace knead {

/// The triangles of some CAD faces of a mesh, as a mesh of its own: what FieldDeformation::kept is made of.
/// @param faces as TriangleMesh::faceOfTriangle
TriangleMesh facesOf(const TriangleMesh& mesh, const std::set<std::uint32_t>& faces);

/// Two meshes as one; vertices in one place stay two, CAD faces are forgotten.
TriangleMesh besides(TriangleMesh one, const TriangleMesh& other);

} // namespace knead
