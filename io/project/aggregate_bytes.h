#pragma once

#include "core/aggregate/aggregate.h"
#include "io/files/byte_blocks.h"

#include <string>
#include <string_view>

namespace knead {

/// An aggregate as bytes, to the last bit, and the other way: arrays as they lie in memory. Trusts nothing: sizes, order of
/// objects, connections to objects that are not there and numbers that are none are found.
/// @throws Problem, naming what is wrong, for the developer
std::string aggregateToBytes(const Aggregate& aggregate);
Aggregate aggregateFromBytes(std::string_view bytes);

/// Only where the objects are.
void addLattice(const Lattice& lattice, BlockWriter& blocks);
Lattice nextLattice(BlockReader& blocks); ///< without segments

} // namespace knead
