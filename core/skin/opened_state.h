#pragma once

#include "core/aggregate/aggregate.h"
#include "core/aggregate/connection_id.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace knead {

/// A body as if it had never been filled anew: objects that lie in the opened part, where these have come, and what of their connections
/// is no more.
struct OpenedState {
    std::shared_ptr<const Aggregate> aggregate; ///< a filling of the opened part
    std::vector<Vec3> displacements;            ///< per object [m]
    std::vector<BrokenConnection> broken;
};

/// What the present filling says of the carriers of its former shape: each piece goes its own way. None without a former shape, or
/// where a piece of the one has nothing of the other.
/// @param displacements one per object of `present`, since it was filled [m]
/// @param broken of `present`
std::optional<OpenedState> openedState(const Aggregate& present, std::span<const Vec3> displacements,
                                       std::span<const BrokenConnection> broken);

/// Connections of the carriers of a former shape that cracks of the present filling have come between. Empty without a former shape.
std::vector<BrokenConnection> brokenInFormer(const Aggregate& present, std::span<const BrokenConnection> broken);

} // namespace knead
