#pragma once

#include "core/task/task_control.h"
#include "io/brep/cad_body.h"

#include <vector>

namespace knead {

/// Closes, orients and repairs a body as far as it can be done without a guess. Separate faces are sewn, closed shells
/// become solids (several bodies when several volumes are bounded), a shell inside of another one its void, and what
/// fails the geometry checks is rebuilt. A step that does not make things better is taken back, so a sound body comes
/// out as it went in.
/// @param capsFlatOpenings as ImportOptions
/// @throws Cancelled
std::vector<CadBody> healed(const CadBody& body, bool capsFlatOpenings, TaskControl& control);

} // namespace knead
