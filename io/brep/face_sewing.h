#pragma once

#include "core/task/task_control.h"
#include "io/brep/cad_body.h"

#include <optional>

namespace knead {

/// Sews faces along edges that lie close to each other. The tolerance rises step by step from a millionth to a
/// thousandth of the size, and no further than needed.
/// @return nothing when no edge could be joined, or a face was lost or changed its area by it
/// @throws Cancelled
std::optional<CadBody> sewn(const CadBody& body, TaskControl& control);

/// The same with one tolerance [mm], whatever lies how close. Faces become shells.
/// @return nothing when a face was lost or changed its area by it
std::optional<CadBody> sewnWith(const CadBody& body, double tolerance);

} // namespace knead
