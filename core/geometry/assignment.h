#pragma once

#include "core/task/task_control.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace knead {

/// What an item may be paired with.
struct PairingOption {
    std::uint32_t other = 0;
    double cost = 0; ///< >= 0
};

/// Pairs items with others, each of both once at most, so that the sum of the costs is least; an item without a partner costs
/// `costOfNone`. By shortest augmenting paths, O(n m lg m) for n items with m options together. Equal input, equal output.
/// @param options per item
/// @param others how many there are
/// @return per item, its partner @throws Cancelled
std::vector<std::optional<std::uint32_t>> leastCostPairs(std::span<const std::vector<PairingOption>> options,
                                                         std::size_t others, double costOfNone,
                                                         const TaskControl& control = TaskControl::none());

} // namespace knead
