#pragma once

#include "io/brep/cad_body.h"

#include <vector>

namespace knead {

/// Makes solids of the closed shells in a body that has none: each is turned outward, and a shell inside of another one
/// becomes its void. What stays open is one more body, without solids.
/// @return the body itself when none of its shells is closed
std::vector<CadBody> solidsOf(const CadBody& surface);

} // namespace knead
