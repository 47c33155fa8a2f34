#pragma once

#include "core/deformation/field_deformation.h"
#include "core/geometry/smooth_map.h"
#include "core/task/task_control.h"

#include <memory>

namespace knead {

/// The smooth map of a field: see FieldDeformation. Twice continuously differentiable, as fine as the nodes are dense; a field whose
/// displacements are those of a quadratic function comes back exactly.
/// @param earlier a map that was made before, or null. Where it is of the same DisplacementField, an object and not its values, what
/// takes long is taken from it: another factor, other faces that stay and other locks take no time.
/// @throws Problem for a field without nodes, or with numbers that are not finite. @throws Cancelled
std::shared_ptr<const SmoothMap> fieldMap(const FieldDeformation& deformation,
                                          TaskControl& control = TaskControl::none(),
                                          const SmoothMap* earlier = nullptr);

} // namespace knead
