#pragma once

#include "core/geometry/vec3.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace knead {

/// A piece of a triangle, in lattice coordinates. Cutting a triangle by six planes leaves at most nine corners.
struct CellPolygon {
    std::array<Vec3, 9> corners;
    std::size_t size = 0;

    void add(const Vec3& corner) { corners[size++] = corner; }
    std::span<const Vec3> span() const { return {corners.data(), size}; }
};

using PolygonView = std::span<const Vec3>;

/// The half of a polygon on one side of the plane where coordinate `axis` is `plane`. Corners on the plane belong
/// to both halves.
CellPolygon halfBelow(PolygonView polygon, int axis, double plane);
CellPolygon halfAbove(PolygonView polygon, int axis, double plane);

/// First and last cell of a stretch along one axis.
struct CellRange {
    std::int32_t first = 0;
    std::int32_t last = 0;
};

/// The cells a polygon reaches into along an axis of `count` cells. A polygon within a border between two cells belongs
/// to the upper one; what sticks out of the grid by rounding belongs to the outermost cell.
CellRange cellRange(PolygonView polygon, int axis, std::int32_t count);

/// The part of a polygon within cell `cell` of its range: the parts of all cells of the range make up the polygon.
CellPolygon clipToCell(PolygonView polygon, int axis, std::int32_t cell, const CellRange& range);

/// Integrals of a polygon over its projection along w, signed: positive where it faces +w.
struct PolygonProjection {
    double area = 0;
    double areaTimesHeight = 0; ///< heights from w = `base`
};
PolygonProjection project(PolygonView polygon, double base);

} // namespace knead
