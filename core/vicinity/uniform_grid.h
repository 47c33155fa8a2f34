#pragma once

#include "core/vicinity/vicinity.h"

#include <array>
#include <vector>

namespace knead {

/// Uniform grids of cells as wide as two spheres, one grid per octave of radius, so that one large sphere does not widen the
/// cells of all small ones. Spheres are sorted by cell and only occupied cells take memory: a sparse scene costs no more
/// than a dense one. Near linear in the number of spheres for any scene whose spheres have few neighbors.
class UniformGrid final : public Vicinity {
public:
    void build(std::span<const VicinitySphere> spheres, double margin) override;
    std::vector<VicinityPair> pairs() override;

    /// All spheres whose centers lie in the box, ascending.
    std::vector<std::uint32_t> inBox(const Box& box) const;

private:
    using Cell = std::array<std::int64_t, 3>;
    struct Entry {
        std::uint64_t key; ///< of the cell, ordered by z, y, x
        std::uint32_t sphere;
    };
    /// The spheres of one octave of radius.
    struct Level {
        double cellSize = 1;      ///< [m]
        double largestRadius = 0; ///< [m]
        Vec3 origin = Vec3::Zero();
        std::vector<Entry> entries; ///< sorted by key, then sphere

        Cell cellOf(const Vec3& place) const;
    };

    void findWithin(const Level& level, std::vector<VicinityPair>& found);
    void findAcross(const Level& small, const Level& large, std::vector<VicinityPair>& found);
    void test(std::uint32_t a, std::uint32_t b, std::vector<VicinityPair>& found);

    std::vector<VicinitySphere> m_spheres;
    std::vector<Level> m_levels; ///< smallest radii first
    double m_margin = 0;
};

} // namespace knead
