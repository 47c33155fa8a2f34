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

/// A connection that is no more.
struct BrokenConnection : ConnectionId {
    /// Where a knife went through it, from its lower end by its length, 0 .. 1; 0: it tore.
    double cutAt = 0;

    bool isCut() const { return cutAt > 0; }
    friend bool operator==(const BrokenConnection&, const BrokenConnection&) = default;
};

} // namespace knead
