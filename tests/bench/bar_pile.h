#pragma once

#include "core/aggregate/material_map.h"
#include "core/mechanics/structural_connections.h"
#include "core/vicinity/vicinity.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace knead {

/// The test data of the paper's experiment: copies of an aggregate of 425 objects, a bar of 5 x 5 x 17 with connections to
/// all 26 neighbors, in irregular poses and with differing velocities. The bars were dropped from above one by one until they touched: a loose pile, about as
/// high as its footprint is wide, whose volume grows with the number of bars.
class BarPile {
public:
    static constexpr std::size_t objectsPerBar = 425;
    static constexpr double spacing = 2e-3; ///< a [m]; spheres have half of it as radius

    /// Spheres this close count as a pair [m]. A hair above zero: neighbors in a bar touch exactly at rest, and rounding
    /// would decide about each of them.
    static constexpr double margin = 0.01 * spacing;

    /// @param seed the same seed gives the same pile
    BarPile(std::size_t bars, std::uint64_t seed);

    /// Moves every object with its bar [s].
    void move(double dt);

    /// The forces of the connections within the bars.
    void computeForces();

    /// All objects at their present places. Each is a group of its own: the paper examines every sphere against every
    /// other, those of its own aggregate included, whether they are connected or not.
    std::span<const VicinitySphere> spheres();

    std::size_t connectionsPerBar() const { return m_bars.front().connections->count(); }

private:
    struct Bar {
        Pose pose;
        Vec3 velocity; ///< [m/s]
        Vec3 spin;     ///< [rad/s]
        ObjectState state;
        std::unique_ptr<StructuralConnections> connections;
    };
    void place(Bar& bar) const;

    std::shared_ptr<const Aggregate> m_aggregate;
    MaterialMap m_materials;
    std::vector<Bar> m_bars;
    std::vector<VicinitySphere> m_spheres;
};

} // namespace knead
