#pragma once

#include "core/aggregate/aggregate.h"
#include "core/aggregate/connection_id.h"

#include <span>

namespace knead {

/// Whether a lattice that was read is one: nodes in order and near, axes at right angles, a spacing.
bool isSound(const Lattice& lattice);

/// Whether weights of a direction are not negative, and 0 where there is no neighbor. @pre the lattice is sound and has segments
bool areSoundWeights(const std::vector<double>& weights, const Lattice& lattice, std::size_t direction);

/// Whether broken connections, ascending, are connections of an aggregate.
bool areSoundBroken(std::span<const BrokenConnection> broken, const Aggregate& aggregate);

/// Whether points of a skin are near their lattice, with areas that can be.
bool areSoundPoints(const std::vector<SkinPoint>& skin, const Lattice& lattice);

} // namespace knead
