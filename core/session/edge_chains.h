#pragma once

#include "core/session/render_mesh.h"

#include <cstdint>
#include <vector>

namespace knead {

/// Joins the feature edges of a surface, which are short and straight, into what a person calls an edge: those that follow each
/// other between the same two CAD faces; on a plain mesh, those between places where edges meet or end.
/// @return per edge of `render`: the number of its chain, counted in the order of the edges
std::vector<std::uint32_t> chainsOf(const TriangleMesh& mesh, const RenderMesh& render);

} // namespace knead
