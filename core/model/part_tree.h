#pragma once

#include "core/model/part.h"

#include <vector>

namespace knead {

/// A tree with only those parts that are kept, numbered anew in their order, and without assemblies that have none left.
/// @param keep one per part
PartNode prunedTree(const PartNode& tree, const std::vector<bool>& keep);

/// The assembly that the paths of parts describe, in the order of the parts.
PartNode treeOfPaths(const std::vector<const Part*>& parts);

} // namespace knead
