#pragma once

#include "core/geometry/triangle_mesh.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace knead {

/// A surface prepared for drawing: a vertex of the mesh appears once per smooth region around it (a CAD face; for a
/// plain mesh what lies within a crease angle), so that shading is smooth inside and sharp between. Made once;
/// immutable.
struct RenderMesh {
    std::vector<std::uint32_t> source;                   ///< vertex of the mesh, per render vertex
    std::vector<std::uint32_t> face;                     ///< CAD face, per render vertex; 0 for plain meshes
    std::vector<std::array<std::uint32_t, 3>> triangles; ///< of render vertices, in the order of the mesh
    std::vector<std::uint32_t> faceOfTriangle;           ///< CAD face; all 0 for plain meshes
    std::vector<std::array<std::uint32_t, 2>> edges;     ///< feature edges, of render vertices
    std::vector<std::uint32_t> chainOfEdge;              ///< which belong together, see chainsOf()
    std::uint32_t chains = 0;                            ///< how many there are
};

RenderMesh renderMesh(const TriangleMesh& mesh);

/// Writes the deformed surface as the graphics card wants it: x y z per render vertex.
/// @param places of the mesh's vertices [m]
std::vector<float> renderPoints(const RenderMesh& mesh, std::span<const Vec3> places);

/// Unit normals, x y z per render vertex, weighted by the areas of the triangles around.
std::vector<float> renderNormals(const RenderMesh& mesh, std::span<const float> points);

} // namespace knead
