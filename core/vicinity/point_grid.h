#pragma once

#include "core/aggregate/lattice.h"
#include "core/mechanics/vector_array.h"

#include <array>
#include <compare>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <vector>

namespace knead {

/// Points by the cells of a grid, to be found from anywhere near them. Immutable; any thread.
class PointGrid {
public:
    /// @param points outlive it
    /// @param cell about as far as points lie apart [m], > 0
    PointGrid(const VectorArray& points, double cell);

    struct Found {
        double squared; ///< distance [m^2]
        ObjectIndex point;
        friend auto operator<=>(const Found&, const Found&) = default;
    };

    /// The nearest ones, the nearest first: `most` of them, or all there are. Of those as far the one with the lower number.
    /// @param found memory to work in, and the result
    /// @param within what is farther does not count [m]: so a place far from all points costs little
    void nearest(const Vec3& place, std::size_t most, std::vector<Found>& found,
                 double within = std::numeric_limits<double>::infinity()) const;

private:
    using Cell = std::array<std::int64_t, 3>;

    Cell cellOf(const Vec3& place) const;
    void addRing(const Cell& center, int ring, const Vec3& place, std::vector<Found>& found) const;

    const VectorArray& m_points;
    double m_cell;
    std::unordered_map<std::uint64_t, std::vector<ObjectIndex>> m_cells;
};

/// The point nearest to each of some places. On all threads.
/// @param spacing about as far as points lie apart [m], > 0
std::vector<ObjectIndex> nearestPoints(const VectorArray& points, const VectorArray& places, double spacing);

} // namespace knead
