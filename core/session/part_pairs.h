#pragma once

#include "core/model/part.h"

#include <cstddef>
#include <span>
#include <vector>

namespace knead {

/// Parts of two files that belong together, by their numbers.
struct PartPair {
    std::size_t before = 0;
    std::size_t after = 0;
};

/// Each part once: those of the same path, the first with the first; then those of the same name; then what is left, in order.
std::vector<PartPair> pairsOfParts(std::span<const Part* const> before, std::span<const Part* const> after);

} // namespace knead
