#pragma once

#include "core/aggregate/aggregate.h"

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace knead {

/// What has become of the cells between the objects of a body.
struct CellQuality {
    /// The least determinant of the three edges at a corner of a cell, by a^3: 1 at rest, 0 where a cell is flat there, negative
    /// where it is inside out. An object may be sound in the mean of what is around it where a cell is not.
    double leastCorner = 1;
    double largestStretch = 1; ///< the longest edge or space diagonal of a cell by what it was
    std::size_t inverted = 0;  ///< cells with a corner that is inside out
};

/// The cells of an aggregate: eight objects that are connected along all twelve edges. Immutable; any thread.
class CellShapes {
public:
    using Corners = std::array<ObjectIndex, 8>; ///< bits 2, 1, 0 of the place in it: further along u, v, w

    explicit CellShapes(const Aggregate& aggregate);

    std::size_t count() const { return m_cells.size(); }
    const std::vector<Corners>& cells() const { return m_cells; }

    /// Of all cells. Uses several threads; same bits for any number.
    /// @param place where an object is [m]; called from all of them
    CellQuality quality(const std::function<Vec3(ObjectIndex)>& place) const;

private:
    std::vector<Corners> m_cells;
    double m_spacing;
    double m_handedness; ///< -1 where u, v, w are a left-handed system, else 1
};

} // namespace knead
