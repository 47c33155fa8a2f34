#pragma once

#include "core/kernels/kernels.h"
#include "core/vicinity/cell_order.h"
#include "core/vicinity/vicinity.h"

#include <array>
#include <map>
#include <vector>

namespace knead {

/// Uniform grids of cells as wide as two spheres, one grid per octave of radius, so that one large sphere does not widen the
/// cells of all small ones. Spheres are sorted by cell and only occupied cells take memory: a sparse scene costs no more
/// than a dense one. Near linear in the number of spheres for any scene whose spheres have few neighbors. On all threads;
/// the pairs do not depend on their number, nor on the instruction set.
class UniformGrid final : public Vicinity {
public:
    explicit UniformGrid(const kernels::Kernels& kernels = kernels::best());

    const PairBlocks& findPairs(std::span<const VicinitySphere> spheres, double margin) override;

private:
    /// One array per number of sphere_kernels::Spheres, in the order of the cells.
    struct SphereArrays {
        std::array<std::vector<float>, 4> place; ///< x, y, z [cells], reach
        std::array<std::vector<std::int32_t>, 5> number;

        void resize(std::size_t count);
        sphere_kernels::Spheres view() const;
        sphere_kernels::Query query(std::size_t i) const;
    };

    /// The grid of the spheres of one octave of radius. A cell has the key x + nx (y + ny z), x, y, z from 1, so that a row
    /// of cells has consecutive keys and neighbors of border cells have keys of their own.
    struct Level {
        std::vector<std::uint32_t> members; ///< ascending
        double largestRadius = 0;           ///< [m]
        Box box;                            ///< of the centers [m]
        double cellsPerMetre = 1;           ///< along a side [1/m]
        Vec3 origin = Vec3::Zero();
        std::array<std::uint64_t, 3> step{1, 1, 1}; ///< between the keys of neighbors along x, y, z
        std::array<double, 3> lastCell{};           ///< per axis, from 0
        double doubt = 0;                           ///< by how much single precision may be wrong [cells]
        std::vector<CellEntry> entries;             ///< sorted by cell
        std::vector<std::uint64_t> cellKey;         ///< occupied cells, ascending
        std::vector<std::uint32_t> cellBegin;       ///< first sphere of each, and the end
        SphereArrays spheres;

        std::uint64_t largestKey() const { return step[2] * (3 + static_cast<std::uint64_t>(lastCell[2])); }

        std::uint64_t keyOf(const Vec3& place) const;
        Vec3 inCells(const Vec3& place) const { return (place - origin) * cellsPerMetre; }
    };

    /// The cells around one cell, row by row; moves on to cells with higher keys.
    class Surroundings;

    /// One sphere's search after another.
    class Search;

    void sortByRadius();
    void layOut(Level& level) const;
    void sortIn(Level& level);
    template <typename Work>
    void inBlocks(std::size_t count, std::size_t size, const Work& work);
    std::uint64_t findPartners(const Level& level, std::size_t begin, std::size_t end, PairBlock& found) const;
    std::uint64_t findPartners(const Level& level, std::span<const CellEntry> smaller, PairBlock& found) const;
    sphere_kernels::Query queryOf(const Level& level, std::uint32_t sphere) const;

    const kernels::Kernels& m_kernels;
    std::map<int, Level> m_levels;             ///< by octave of radius
    std::vector<CellEntry> m_smaller;          ///< spheres of lower octaves than the level in work
    std::vector<CellEntry> m_scratch;          ///< to sort in
    std::span<const VicinitySphere> m_spheres; ///< during a call of findPairs()
    double m_margin = 0;
};

} // namespace knead
