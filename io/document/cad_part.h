#pragma once

#include "core/task/task_control.h"
#include "io/brep/cad_body.h"
#include "io/document/cad_document.h"
#include "io/importer.h"

#include <vector>

namespace knead {

/// Splits the shape of a leaf into one part per solid and one more for shells and faces that belong to no solid, since
/// each closed solid can be filled on its own.
std::vector<CadBody> splitIntoBodies(const TopoDS_Shape& shape);

/// Measures and tessellates one body: everything a Part holds but its name and path.
/// @param defaultColor of the leaf the body comes from
/// @throws Cancelled
Part makePart(const CadBody& body, const std::optional<Color>& defaultColor, const ShapeColors& colors,
              const ImportOptions& options, TaskControl& control = TaskControl::none());

} // namespace knead
