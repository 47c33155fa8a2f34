#pragma once

#include "core/aggregate/lattice.h"

#include <compare>
#include <cstdint>

namespace knead {

/// A structural connection by the object that stores it and its direction.
struct ConnectionId {
    std::uint32_t direction = 0;
    ObjectIndex lower = 0;
    friend auto operator<=>(const ConnectionId&, const ConnectionId&) = default;
};

} // namespace knead
