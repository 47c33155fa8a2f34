#pragma once

#include "core/model/part.h"

#include <vector>

namespace knead {

/// Models side by side as one: each is a child of the new root, and its name leads the paths of its parts. Format and unit
/// are kept where all agree; a doubt about the unit becomes a warning, since the other files keep theirs. One model alone stays
/// as it is.
/// @param models at least one
Model joined(std::vector<Model> models);

/// As a warning where others are beside it.
Message doubtOfOneAmongOthers(const UnitRemark& remark);

/// Adds to the numbers of the parts in a tree.
void shiftNumbers(PartNode& node, std::size_t by);

/// The model with these parts in place of its own, in the tree that their paths describe.
Model withParts(Model model, std::vector<Part> parts);

} // namespace knead
