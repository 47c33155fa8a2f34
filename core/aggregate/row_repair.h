#pragma once

#include "core/aggregate/cell_polygon.h"
#include "core/aggregate/cut_cells.h"
#include "core/geometry/half_edges.h"
#include "core/geometry/winding_number.h"

#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace knead {

/// Decides what is material in rows of cells where the surface alone does not tell, because it has holes or overlaps:
/// by the generalized winding number, as far as that is needed.
///
/// A row is odd when a hole may be in it, or when what its pieces of surface add up to is no part of a cell. In an odd row
/// cells without surface are material where the surface winds around them more than half. Stretches of cells with
/// surface are taken exactly from both ends as far as no hole may be in them and their pieces add up; in what is left
/// between, points are tried.
/// Immutable but for a tree made when first needed; may be used on any number of threads.
class RowRepair {
public:
    /// What the surface gives to the cells of a row, see cutCells(); one entry per cell.
    struct Pieces {
        std::span<const double> inCell;
        std::span<const double> area;
        std::span<const std::uint8_t> isTouched; ///< by the surface
    };

    struct Outcome {
        std::vector<double> fraction; ///< per cell, 0..1
        std::size_t decided = 0;      ///< cells that differ from what the pieces say, or do not follow from them
        double doubtful = 0;          ///< [cells] where the winding number is nearer to a half than to 0 or 1
    };

    RowRepair(const TriangleMesh& mesh, const HalfEdges& halfEdges, const CellGrid& grid, double orientation);

    /// Rows (u, v) in which holes may be; none when last < first.
    CellRange suspectRows(std::int32_t u) const;
    bool isSuspect(std::int32_t u, std::int32_t v) const;

    /// Whether the pieces of a row bound material by themselves.
    bool isSound(const Pieces& pieces) const;
    Outcome decide(std::int32_t u, std::int32_t v, const Pieces& pieces) const;

    /// Made when first asked for.
    const WindingNumber& windingNumber() const;
    double orientation() const { return m_orientation; }

private:
    struct Tried {
        double material = 0; ///< of the points, 0..1
        double doubtful = 0;
    };

    /// Cells in which the surface that would close a hole may be, of one u.
    struct Hole {
        CellRange v;
        CellRange w;
    };

    double windingAt(const Vec3& inLattice) const;
    Tried tryPoints(const Lattice::Node& cell) const;
    void suspectHoles(const HalfEdges& halfEdges);
    std::vector<std::uint8_t> suspectCells(std::int32_t u, std::int32_t v) const;
    std::vector<std::size_t> takeExactly(const Pieces& pieces, std::size_t begin, std::size_t end,
                                         const std::vector<std::uint8_t>& isSuspect, const std::vector<double>& level,
                                         std::vector<double>& fraction) const;

    const TriangleMesh& m_mesh;
    const CellGrid& m_grid;
    double m_orientation;
    std::vector<std::vector<Hole>> m_holes; ///< per u
    mutable std::once_flag m_once;
    mutable std::unique_ptr<const WindingNumber> m_winding;
};

} // namespace knead
