#pragma once

#include <cstdint>
#include <vector>

namespace knead {

/// A sphere in a cell of a grid.
struct CellEntry {
    std::uint64_t key; ///< of the cell
    std::uint32_t sphere;
};

/// Sorts entries by key; those of a cell stay in order. O(n) per eleven bits of the largest key.
/// @param scratch memory to work in
void sortByCell(std::vector<CellEntry>& entries, std::uint64_t largestKey, std::vector<CellEntry>& scratch);

} // namespace knead
