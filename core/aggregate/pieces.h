#pragma once

#include "core/aggregate/aggregate.h"
#include "core/aggregate/connection_id.h"

#include <cstdint>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

namespace knead {

/// The other object of a connection than the one that stores it. O(lg n).
ObjectIndex upperEnd(const Lattice& lattice, const ConnectionId& connection);

/// Which objects hang together.
struct Pieces {
    std::vector<std::uint32_t> ofObject; ///< the piece of each object; pieces are numbered by their lowest object
    std::size_t count = 0;
};

/// The pieces into which an aggregate falls when some of its connections are broken. O(n).
Pieces findPieces(const Aggregate& aggregate, std::span<const BrokenConnection> broken = {});

/// Per object: bit d is set where the connection in direction d is broken.
std::vector<std::uint16_t> brokenDirections(const Aggregate& aggregate, std::span<const BrokenConnection> broken);

/// An aggregate without some of its connections; itself where there are none of these.
std::shared_ptr<const Aggregate> withoutBroken(const std::shared_ptr<const Aggregate>& aggregate,
                                               std::span<const BrokenConnection> broken);

/// Some of the objects of an aggregate as an aggregate of their own, without the broken connections. Weights and volumes
/// are those of the whole, meshVolume and filledVolume what these objects have of it; cells are not counted.
/// O(m lg m) for m objects.
/// @param objects ascending
/// @param isBroken see brokenDirections()
Aggregate extract(const Aggregate& aggregate, std::span<const ObjectIndex> objects,
                  std::span<const std::uint16_t> isBroken);

/// Values of some objects.
template <typename Values>
auto pickedOf(const Values& values, std::span<const ObjectIndex> objects)
{
    std::vector<std::decay_t<decltype(values[0])>> some;
    some.reserve(objects.size());
    for (const ObjectIndex object : objects)
        some.push_back(values[object]);
    return some;
}

} // namespace knead
