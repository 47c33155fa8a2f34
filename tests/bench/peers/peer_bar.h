#pragma once

#include "core/aggregate/aggregate.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace knead {

/// The lattice bar that Knead and its peers step: the same objects and the same connections for all.
struct PeerBar {
    struct Connection {
        std::uint32_t first;
        std::uint32_t second;
        bool isDiagonal; ///< sqrt 2 long, else 1
    };

    std::shared_ptr<const Aggregate> aggregate;
    std::vector<Vec3> places;     ///< [spacings]
    std::vector<Vec3> velocities; ///< [spacings / step]
    std::vector<Connection> connections;

    /// It flies and turns, so that neighbor lists must be kept up to date: about one spacing in 135 steps.
    static constexpr double speed = 0.0074; ///< of the center [spacings / step]
    static constexpr double spin = 5e-5;    ///< [rad / step]
};

/// A bar of so many objects along each axis.
PeerBar makePeerBar(const std::array<int, 3>& objects);

} // namespace knead
