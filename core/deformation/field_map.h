#pragma once

#include "core/deformation/field_deformation.h"
#include "core/geometry/smooth_map.h"
#include "core/task/task_control.h"

#include <memory>

namespace knead {

/// The smooth map of a field: see FieldDeformation. Twice continuously differentiable, as fine as the nodes are dense; a field whose
/// displacements are those of a quadratic function comes back exactly.
/// @throws Problem for a field without nodes, or with numbers that are not finite. @throws Cancelled
std::shared_ptr<const SmoothMap> fieldMap(const FieldDeformation& deformation,
                                          TaskControl& control = TaskControl::none());

} // namespace knead
