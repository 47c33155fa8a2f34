#pragma once

#include "core/model/part.h"

#include <cstddef>
#include <set>
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

/// Which parts of a model are hidden when it takes the place of another one, of which these were, by deforming it, by adding parts or by
/// taking that back: those of the same numbers, pieces of hidden ones, and added ones that are hidden in their file.
std::set<std::size_t> stillHidden(const std::set<std::size_t>& hidden, const Model& before, const Model& now);

/// What Part::path was in versions that did not name the bodies of a product: theirs was that of the product, numbered.
std::string formerPath(const Part& part);

} // namespace knead
