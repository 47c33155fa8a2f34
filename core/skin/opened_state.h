#pragma once

#include "core/aggregate/aggregate.h"
#include "core/aggregate/connection_id.h"
#include "core/skin/carried_cracks.h"

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

/// Connections of the first filling that cracks have come between, those that parted what the present one was filled from included.
/// Empty where the former shape follows another one, through which cracks are not followed back.
/// @param broken of `present`
/// @param healed of its objects: what makes pieces one again, see regrown()
/// @return ascending
std::vector<BrokenConnection> brokenInFirst(const Aggregate& present, std::span<const BrokenConnection> broken,
                                            std::span<const GrownTogether> healed = {});

} // namespace knead
