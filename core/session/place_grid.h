#pragma once

#include "core/geometry/vec3.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <vector>

namespace knead {

/// Places by the cells of a grid, found from near them, and one more at any time.
class PlaceGrid {
public:
    /// @param distance within which places are found [m], > 0
    explicit PlaceGrid(double distance)
        : m_distance(distance)
    {
    }

    void add(const Vec3& place)
    {
        m_cells[cellOf(place)].push_back(static_cast<std::uint32_t>(m_places.size()));
        m_places.push_back(place);
    }

    /// Numbers of the places closer than the distance, in the order in which they were added within a cell.
    std::vector<std::uint32_t> around(const Vec3& place) const
    {
        const Cell cell = cellOf(place);
        std::vector<std::uint32_t> found;
        for (std::int64_t i = -1; i <= 1; ++i)
            for (std::int64_t j = -1; j <= 1; ++j)
                for (std::int64_t k = -1; k <= 1; ++k)
                    if (const auto in = m_cells.find({cell[0] + i, cell[1] + j, cell[2] + k}); in != m_cells.end())
                        for (const std::uint32_t number : in->second)
                            if ((m_places[number] - place).norm() < m_distance)
                                found.push_back(number);
        return found;
    }

private:
    using Cell = std::array<std::int64_t, 3>;

    Cell cellOf(const Vec3& place) const
    {
        const auto along = [&](Eigen::Index axis) {
            return static_cast<std::int64_t>(std::floor(place[axis] / m_distance));
        };
        return {along(0), along(1), along(2)};
    }

    double m_distance;
    std::vector<Vec3> m_places;
    std::map<Cell, std::vector<std::uint32_t>> m_cells;
};

} // namespace knead
