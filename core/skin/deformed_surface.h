#pragma once

#include "core/aggregate/aggregate.h"
#include "core/geometry/triangle_mesh.h"
#include "core/skin/skin_fields.h"
#include "core/task/task_control.h"

#include <span>

namespace knead {

/// The surface of an opened part, split until it is fine enough to bend with its objects where these were filled.
/// @param mostTriangles it is split no finer than into about so many
TriangleMesh bendableSurface(const TriangleMesh& mesh, const Aggregate& aggregate, std::size_t mostTriangles);

/// The surface of a part where its objects have taken it: split until it is fine enough to bend with them.
/// @param displacements one per object, from rest [m]
/// @param mostTriangles it is split no finer than into about so many
/// @throws Cancelled
TriangleMesh deformedSurface(const TriangleMesh& mesh, const Aggregate& aggregate, std::span<const Vec3> displacements,
                             std::size_t mostTriangles = 400'000, TaskControl& control = TaskControl::none());

/// The surface and what has become of the material at its vertices.
struct StrainedSurface {
    TriangleMesh mesh;
    SkinFields fields;
};

/// The same surface, with what has become of the material. @throws Cancelled
/// @param body the objects of the aggregate, as they have moved
/// @param loaded see SkinStress::stresses()
StrainedSurface strainedSurface(const TriangleMesh& mesh, const Aggregate& aggregate, const ObjectStrains& body,
                                std::span<const ObjectIndex> loaded = {}, std::size_t mostTriangles = 400'000,
                                TaskControl& control = TaskControl::none());

} // namespace knead
