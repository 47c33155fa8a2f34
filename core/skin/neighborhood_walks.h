#pragma once

#include "core/aggregate/lattice.h"

#include <cstddef>
#include <cstdint>

/// Walks along connections, by which objects come into a neighborhood: from the nodes at corners of a cell and of those around it.
namespace knead::neighborhood_walks {

inline constexpr std::int32_t reach = 3;   ///< steps
inline constexpr std::int32_t corners = 4; ///< nodes per axis at corners of a cell and of those around it

/// The number of the walk from a node, below corners^3.
/// @param local from the lowest corner of the cell, -1 to 2 along each axis
inline std::size_t walkFrom(const Lattice::Node& local)
{
    return static_cast<std::size_t>(((local[0] + 1) * corners + local[1] + 1) * corners + local[2] + 1);
}

} // namespace knead::neighborhood_walks
