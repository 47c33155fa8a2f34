#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/session/filled_model.h"
#include "core/session/frame.h"

#include <cstdint>
#include <set>

namespace knead {

/// The surfaces of all parts, in their order, as a frame of a content shows them: of parts that have not moved the triangles that they
/// were opened with, so that a recipe comes to the same bits [m]. Any thread.
TriangleMesh presentSurface(const FilledModel& content, const Frame& shown);

/// Of some CAD faces of a body. @param faces indices into Part::faces
TriangleMesh presentFaces(const FilledModel& content, const Frame& shown, BodyId body,
                          const std::set<std::uint32_t>& faces);

} // namespace knead
