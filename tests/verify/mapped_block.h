#pragma once

#include "core/geometry/triangle_mesh.h"

#include <array>
#include <functional>

namespace knead::book {

/// A unit cube of cells carried through space by a map: a bar, a ring, a plate with a hole. One description serves both
/// programs: Knead fills its surface, CalculiX solves on its cells.
struct MappedBlock {
    std::array<int, 3> cells = {1, 1, 1};                    ///< along u, v and w, > 0
    std::function<Vec3(double u, double v, double w)> place; ///< of a point of the unit cube [m]
    bool closed = false;                                     ///< u = 0 and u = 1 are the same: a ring

    Vec3 at(double i, double j, double k) const { return place(i / cells[0], j / cells[1], k / cells[2]); }
};

/// Its surface, welded and facing outwards.
TriangleMesh surfaceOf(const MappedBlock& block);

/// Along x and centered at the origin; the cells of a bar of these measures that is `across` cells thick in z.
MappedBlock bar(const Vec3& size, int across);

/// A full cylinder along x, centered at the origin; a square of cells is carried into the circle.
MappedBlock roundBar(double radius, double length, int across);

/// A pipe along x, centered at the origin, `thick` cells through its wall.
MappedBlock pipe(double innerRadius, double outerRadius, double length, int thick);

/// A pipe of square section along x, centered at the origin, with sharp corners, `thick` cells through its wall.
MappedBlock squarePipe(double width, double wall, double length, int thick);

/// A plate of length along x and width along y, centered at the origin, with a round hole in its middle.
MappedBlock plateWithHole(double length, double width, double holeRadius, double thickness, int around);

/// A part of a ring in x and y about the origin from angle `from` to `to` [rad], of rectangular section.
MappedBlock ringSector(double innerRadius, double outerRadius, double thickness, double from, double to, int through);

} // namespace knead::book
