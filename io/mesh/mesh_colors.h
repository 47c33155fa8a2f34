#pragma once

#include "core/model/part.h"

#include <optional>
#include <vector>

namespace knead {

/// Gives a mesh the colors of its triangles. One color is that of the part; several make the mesh a part with a face
/// per color, since colors belong to faces.
/// @param colors one a triangle of part.mesh
void paintTriangles(Part& part, const std::vector<std::optional<Color>>& colors);

} // namespace knead
