#pragma once

#include "core/aggregate/lattice.h"

#include <cstdint>
#include <vector>

namespace knead {

/// Finds objects of a lattice by their rows: faster than Lattice::find for many look-ups close together.
/// The lattice must outlive it.
class LatticeRows {
public:
    /// The objects of one row along w; empty when there are none.
    struct Row {
        ObjectIndex begin = 0;
        ObjectIndex end = 0;
    };

    explicit LatticeRows(const Lattice& lattice);

    Row row(std::int32_t u, std::int32_t v) const;

    /// First object of a row at w or above; the end of the row when there is none.
    ObjectIndex lowerBound(const Row& row, std::int32_t w) const;

    /// The object at a node, or the number of objects when none is there.
    ObjectIndex find(const Lattice::Node& node) const;

    /// The object closest to a place [lattice coordinates]; the place is first moved into the box of the objects.
    /// @pre the lattice has objects
    ObjectIndex nearest(const Vec3& coordinates) const;

private:
    struct RowStart {
        std::int32_t v;
        ObjectIndex begin;
    };

    const Lattice& m_lattice;
    std::int32_t m_firstPlane = 0;
    std::vector<std::size_t> m_planeBegin; ///< into m_rows, per u from m_firstPlane on, and the end
    std::vector<RowStart> m_rows;          ///< and the end
    Eigen::AlignedBox3i m_bounds;          ///< of the nodes
};

} // namespace knead
