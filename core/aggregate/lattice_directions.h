#pragma once

#include <array>
#include <cstdint>

namespace knead {

inline constexpr int latticeDirectionCount = 13;

/// The forward halves of the neighbors, each the higher of its pair: 3 along the axes, 6 across face diagonals, which
/// make the 18 neighbors of every filled part; and 4 along body diagonals, which only the published arrangement has.
inline constexpr std::array<std::array<std::int32_t, 3>, latticeDirectionCount> latticeDirections{{{1, 0, 0},
                                                                                                   {0, 1, 0},
                                                                                                   {0, 0, 1},
                                                                                                   {1, 1, 0},
                                                                                                   {1, -1, 0},
                                                                                                   {1, 0, 1},
                                                                                                   {1, 0, -1},
                                                                                                   {0, 1, 1},
                                                                                                   {0, 1, -1},
                                                                                                   {1, 1, 1},
                                                                                                   {1, 1, -1},
                                                                                                   {1, -1, 1},
                                                                                                   {1, -1, -1}}};

} // namespace knead
