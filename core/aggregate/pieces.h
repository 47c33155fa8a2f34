#pragma once

#include "core/aggregate/aggregate.h"
#include "core/aggregate/connection_id.h"

#include <cstdint>
#include <span>
#include <vector>

namespace knead {

/// Which objects hang together.
struct Pieces {
    std::vector<std::uint32_t> ofObject; ///< the piece of each object; pieces are numbered by their lowest object
    std::size_t count = 0;
};

/// The pieces into which an aggregate falls when some of its connections are broken. O(n).
Pieces findPieces(const Aggregate& aggregate, std::span<const ConnectionId> broken = {});

/// Some of the objects of an aggregate as an aggregate of their own, without the broken connections. Weights and volumes
/// are those of the whole, meshVolume and filledVolume what these objects have of it; cells are not counted.
/// @param objects ascending
Aggregate extract(const Aggregate& aggregate, std::span<const ObjectIndex> objects,
                  std::span<const ConnectionId> broken);

} // namespace knead
