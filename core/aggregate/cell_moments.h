#pragma once

#include "core/aggregate/cell_polygon.h"

#include <array>
#include <cstddef>

namespace knead {

/// Integrals over the material of a cell of 1, its coordinates and their products, about the middle of the cell, with lengths
/// in spacings: values of a linear functional on the quadratic polynomials.
struct CellMoments {
    static constexpr std::size_t count = 10;
    /// 1, u, v, w, uu, vv, ww, uv, uw, vw
    std::array<double, count> value{};

    /// A cell of which the given part is material, evenly spread.
    static CellMoments even(double fraction);
};

/// What pieces of surface add to the moments of the cell they lie in and of those above it in the row, as cutCells() does
/// it for volumes: each piece stands for the material between itself and the top of the row, with the sign of its projection.
class ColumnMoments {
public:
    /// @param cell (u, v, w) of the cell the piece lies in
    void add(PolygonView piece, const Vec3& cell);

    /// Of the material in this cell, when `below` has come up from the cells under it.
    CellMoments inCell(const ColumnMoments& below, double orientation) const;

    /// Passes what goes on upwards to the next cell.
    void addTo(ColumnMoments& below) const;

private:
    std::array<double, CellMoments::count> m_inCell{}; ///< between pieces and the top of their cell
    std::array<double, 6> m_area{};                    ///< of the projections: 1, u, v, uu, vv, uv
};

} // namespace knead
