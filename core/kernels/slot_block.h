#pragma once

#include <cstddef>
#include <cstdint>

namespace knead {

/// Eight slots in a row, and where the eight beside them are in the lattice.
struct SlotBlock {
    static constexpr std::size_t lanes = 8;

    std::uint32_t first = 0; ///< slot
    /// From `first` to the eight with the same w in the row at (u + du, v + dv), at [3 (du + 1) + dv + 1]. Where there is none, it
    /// leads to slots that are empty, and so are those before and after them.
    std::int32_t offset[9] = {};
};

} // namespace knead
