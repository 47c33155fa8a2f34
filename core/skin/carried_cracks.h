#pragma once

#include "core/aggregate/aggregate.h"
#include "core/aggregate/connection_id.h"
#include "core/mechanics/vector_array.h"

#include <span>
#include <utility>
#include <vector>

namespace knead {

/// Objects of a body whose skins have grown together, the lower one first.
using GrownTogether = std::pair<ObjectIndex, ObjectIndex>;

/// A filling with cracks. Holds on to what it is made of.
struct CrackedFilling {
    const Aggregate& aggregate;
    const VectorArray& places; ///< of its objects [m]
    std::span<const BrokenConnection> broken;
    std::span<const GrownTogether> healed = {}; ///< what hangs together again
};

/// Connections of another filling of the same material that are none, since they lead across its cracks.
///
/// The straight way between two of its objects goes past objects of the cracked one; it leads across a crack where two of these that
/// follow each other are of different pieces, or not connected any more, neither directly nor over a third one. So cracks stay where
/// they are, as long as they are, and there are as many connections across as there were.
/// @param places of the objects of `other`, among those of the cracked filling [m]
/// @return ascending; cut where those before were
std::vector<BrokenConnection> carriedCracks(const CrackedFilling& cracked, const Aggregate& other,
                                            const VectorArray& places);

/// Where the objects of an aggregate are at rest.
VectorArray nodesOf(const Aggregate& aggregate);

} // namespace knead
