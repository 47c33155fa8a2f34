#pragma once

#include "core/task/task_control.h"
#include "io/brep/cad_body.h"

#include <vector>

namespace knead {

/// Makes the geometry checks and notes in the bodies what they say. Bodies are checked beside each other, and a shape that is
/// at several places once. Where a check fails to run, nothing is noted.
/// @throws Cancelled
void checkBodies(const std::vector<CadBody*>& bodies, TaskControl& control);

} // namespace knead
