#pragma once

#include "core/aggregate/cell_finder.h"
#include "core/geometry/vec3.h"

namespace knead {

/// How the material around a place lies: along a bar, in a plate or on all sides.
///
///   C = integral (x - c) (x - c)^T / integral 1,   c its middle,
/// over the material within about 3.5 cells, as the surface bounds it and wherever the lattice lies in it.
class LocalShape {
public:
    /// On all sides.
    LocalShape() = default;

    /// @param spread C [a^2]
    explicit LocalShape(const Mat3& spread);

    /// e C e / tr C: nearly 1 along a thin bar, 1/2 along a plate, 1/3 where there is material on all sides.
    /// @param direction e in axes of the lattice, of any length > 0
    double along(const Vec3& direction) const
    {
        return direction.dot(m_spread * direction) / (m_spread.trace() * direction.squaredNorm());
    }

    /// sqrt(12 c), c the least principal value of C: the thickness of a plate, the width of a square bar [cells].
    /// Of more than four cells it says less than there is.
    double thickness() const { return m_thickness; }

private:
    Mat3 m_spread = Mat3::Identity();
    double m_thickness = 7;
};

/// @param place in coordinates of the lattice [a]
LocalShape localShapeAt(const CellFinder& finder, const Vec3& place);

} // namespace knead
