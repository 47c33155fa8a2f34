#pragma once

#include "core/geometry/smooth_map.h"
#include "core/geometry/triangle_mesh.h"
#include "core/model/export_report.h"
#include "core/task/task_control.h"

#include <array>

namespace knead {

/// A mesh where a map takes it.
TriangleMesh carried(const SmoothMap& map, TriangleMesh mesh);

/// Remarks on where a surface passes through itself although it did not at rest, by more than a tenth of the tolerance.
/// @param rest the surface of the part, and the triangles that are carried to `now`
void noteCrossings(const SmoothMap& map, const std::array<const TriangleMesh*, 2>& rest, const TriangleMesh& now,
                   TaskControl& control, PartExportReport& report);

/// The same of a surface of flat faces in its present place, of which no other is known: by more than the tolerance, within which sides
/// of a crack lie on each other.
void noteCrossings(const TriangleMesh& now, TaskControl& control, PartExportReport& report);

/// Remarks on where a surface is folded: faces follow a fold, too, as long as they make a sound solid, which they do where material has
/// come to lie on itself. Why a part has flat faces begins with that.
/// @param now where the map takes `rest`
void noteFold(const TriangleMesh& rest, const TriangleMesh& now, PartExportReport& report);

} // namespace knead
