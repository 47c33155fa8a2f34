#pragma once

#include "core/aggregate/aggregate.h"
#include "core/aggregate/lattice_rows.h"

#include <compare>
#include <vector>

namespace knead {

/// The objects that may carry a point of the surface: those reached along connections from the cell that owns it.
/// The aggregate must outlive it; its members may be called from any thread.
class NeighborhoodFinder {
public:
    explicit NeighborhoodFinder(const Aggregate& aggregate);

    /// The material a point belongs to: a kept cell, or one object where no kept cell is close.
    struct Owner {
        Lattice::Node node{}; ///< the lowest corner of the cell, or the object
        bool isCell = false;
        auto operator<=>(const Owner&) const = default;
    };

    /// The kept cell that contains a point [lattice coordinates], else the nearest of the kept cells around it, else
    /// the nearest object.
    Owner owner(const Vec3& coordinates) const;

    /// Objects at most three steps along connections from the owner's, ascending.
    std::vector<ObjectIndex> gather(const Owner& owner) const;

private:
    bool isKept(const Lattice::Node& cell) const;

    const Aggregate& m_aggregate;
    LatticeRows m_rows;
};

} // namespace knead
