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
/// @param leaf that the body comes from
/// @param notes what the document says of its shapes
/// @throws Cancelled
Part makePart(const CadBody& body, const CadNode& leaf, const CadDocument& notes, const ImportOptions& options,
              TaskControl& control = TaskControl::none());

} // namespace knead
