#pragma once

#include "core/geometry/vec3.h"

#include <cstdint>
#include <span>
#include <vector>

namespace knead {

/// A sphere that may come into contact.
struct VicinitySphere {
    Vec3 center;              ///< [m]
    double radius = 0;        ///< [m], >= 0
    std::uint32_t group = 0;  ///< pairs within a group are not looked for
};

/// Finds which spheres are close to each other or to a box. Spheres are sorted by the cell of a uniform grid they lie in, only
/// occupied cells take memory, so a sparse scene costs no more than a dense one.
class UniformGrid {
public:
    /// Sorts the spheres into cells as wide as the largest sphere plus `margin` [m]. O(n lg n). Copies what it needs.
    void build(std::span<const VicinitySphere> spheres, double margin);

    struct Pair {
        std::uint32_t first;    ///< < second
        std::uint32_t second;
        friend auto operator<=>(const Pair&, const Pair&) = default;
    };

    /// All pairs of spheres of different groups whose surfaces are closer than the margin, sorted.
    std::vector<Pair> pairs() const;

    /// All spheres whose centers lie in the box, ascending.
    std::vector<std::uint32_t> inBox(const Box& box) const;

private:
    using Cell = Eigen::Matrix<std::int32_t, 3, 1>;
    struct Entry {
        Cell cell;
        std::uint32_t sphere;
    };

    Cell cellOf(const Vec3& place) const;
    /// Entries of the cells (x0..x1, y, z), which are neighbors in the sorted order.
    std::span<const Entry> row(std::int32_t x0, std::int32_t x1, std::int32_t y, std::int32_t z) const;

    std::vector<VicinitySphere> m_spheres;
    std::vector<Entry> m_entries;   ///< sorted by z, y, x of the cell, then sphere
    double m_cellSize = 1;
    double m_margin = 0;
};

} // namespace knead
