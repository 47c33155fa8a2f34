#pragma once

#include "core/aggregate/cell_moments.h"
#include "core/aggregate/lattice.h"
#include "core/geometry/triangle_mesh.h"
#include "core/task/task_control.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace knead {

/// Where the cells of a lattice are. Cell (u, v, w) lies between the nodes (u, v, w) and (u + 1, v + 1, w + 1).
struct CellGrid {
    Lattice frame;         ///< origin, spacing and axes; no nodes
    Lattice::Node count{}; ///< cells per axis, >= 1
};

/// The smallest grid around a box, centered on it, with w along the longest side.
/// A box whose sides are multiples of the spacing gets nodes on its faces, but for one that is a cell thick: it gets three layers
/// of nodes, since what has two bends nearly twice too stiffly (1.8, with three 1.2).
/// @param rowAxis world axis that rows run along; none: that of the longest side
CellGrid gridAround(const Box& box, double spacing, std::optional<Eigen::Index> rowAxis = {});

class RowRepair;

/// How much of each cell of a grid is material. Only cells with enough of it are stored, row by row along w.
struct CutCells {
    /// Kept cells with the same u and v.
    struct Row {
        std::span<const std::int32_t> w;  ///< ascending
        std::span<const double> fraction; ///< of the cell that is material, 0..1
    };

    /// A cell that the surface cuts, with too little in it to be kept or with enough.
    struct Cut {
        std::int32_t v = 0;
        std::int32_t w = 0;
        CellMoments moments; ///< of its material; as of evenly spread material where RowRepair decided
    };

    /// Kept cells with the same u.
    struct Slab {
        std::int32_t firstRow = 0;            ///< v of the first row
        std::vector<std::size_t> rowBegin{0}; ///< per row, and the end
        std::vector<std::int32_t> w;
        std::vector<double> fraction;
        std::vector<Cut> cut;    ///< ascending in (v, w)
        double volume = 0;       ///< material in all cells of the slab [cells], dropped ones included
        std::size_t decided = 0; ///< cells that RowRepair decided
        double doubtful = 0;     ///< and how much of them could be either [cells]

        std::int32_t rowsEnd() const { return firstRow + static_cast<std::int32_t>(rowBegin.size()) - 1; }
        Row row(std::int32_t v) const; ///< empty outside firstRow .. rowsEnd()
    };

    std::vector<Slab> slabs; ///< by u

    double volume() const;       ///< material in all cells [cells], dropped ones included
    double keptVolume() const;   ///< material in the kept cells [cells]
    std::size_t size() const;    ///< kept cells
    std::size_t decided() const; ///< cells that RowRepair decided
    double doubtful() const;     ///< [cells]
};

/// Cuts the cells of a grid by a closed surface, exactly.
///
/// Each triangle is clipped to the cells it crosses. A piece adds the volume between itself and the top of its cell to
/// this cell, and its projected area times the cell's height to all cells above (the divergence theorem along rows).
/// The moments of cut cells come the same way. Cells with less than minimumFraction are not kept, but for those that
/// withoutScraps() keeps.
/// @param orientation 1 when the triangles face outwards, -1 when they face inwards
/// @param repair decides rows that the surface does not bound; without it the surface is taken for closed
/// @throws Cancelled
CutCells cutCells(const TriangleMesh& mesh, const CellGrid& grid, double orientation, double minimumFraction,
                  TaskControl& control, const RowRepair* repair = nullptr);

} // namespace knead
