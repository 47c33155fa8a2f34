#pragma once

#include "core/model/part.h"

#include <string>
#include <vector>

namespace knead {

/// A tree with only those parts that are kept, numbered anew in their order, and without assemblies that have none left.
/// @param keep one per part
PartNode prunedTree(const PartNode& tree, const std::vector<bool>& keep);

/// The assembly that the paths of parts describe, in the order of the parts.
PartNode treeOfPaths(const std::vector<const Part*>& parts);

/// Gives the nodes of a tree the products of those with the same names, in their order, in another.
void takeProducts(const PartNode& from, PartNode& to);

/// What Part::path was in versions that did not name the bodies of a product: theirs was that of the product, numbered.
std::string formerPath(const Part& part);

} // namespace knead
