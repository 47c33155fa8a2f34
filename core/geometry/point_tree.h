#pragma once

#include "core/geometry/vec3.h"

#include <cstdint>
#include <vector>

namespace knead {

/// Finds the nearest of many points: a balanced tree, halved along the longest side of each box. Immutable after construction; queries
/// may run on any number of threads. Keeps a copy of the points.
class PointTree {
public:
    struct Found {
        double distance = 0; ///< [m]
        std::uint32_t point = 0;
    };

    /// O(n lg n).
    explicit PointTree(std::vector<Vec3> points);

    /// Near ones first, equally near ones by their numbers. Fewer where there are fewer points.
    std::vector<Found> nearest(const Vec3& place, std::size_t count) const;

    /// Distance to the nearest point, and which it is. @pre at least one point
    Found nearest(const Vec3& place) const { return nearest(place, 1).front(); }

private:
    void sort(std::size_t begin, std::size_t end);
    void search(std::size_t begin, std::size_t end, const Vec3& place, std::vector<Found>& best,
                std::size_t count) const;

    std::vector<Vec3> m_points;
    std::vector<std::uint32_t> m_order; ///< of each range, the middle one parts the others
    std::vector<std::uint8_t> m_sides;  ///< of the middle one: along which axis
};

} // namespace knead
