#pragma once

#include "core/aggregate/cell_finder.h"
#include "core/geometry/vec3.h"

namespace knead {

/// What is thicker than so many cells bends right without help.
constexpr double thickestThinWall = 8;

/// How much of the material at a place of the skin is a wall: as thin as bends wrong, and going on along itself.
///
/// A wall is 1, and so is a bar, along its sides. What goes on for less than about one and a half times its thickness is a lump, 0: it is
/// pressed rather than bent, and its ends must be as strong as its middle. What is thicker than thickestThinWall is 0 too. Between
/// them it passes over by and by, so that a lump that is filled anew a little longer than before has nearly the same weights. What is
/// thinner than three cells is always a wall.
class WallMeasure {
public:
    explicit WallMeasure(const CellFinder& finder)
        : m_finder(finder)
    {
    }

    /// Of a cell that the surface cuts. Where nothing tells which way is inwards two skins are near each other: 1.
    /// @return 0 .. 1
    double share(const Lattice::Node& cell) const;

    /// @param cell at the skin
    /// @param inwards across the skin, of any length > 0
    /// @return 0 .. 1
    double share(const Lattice::Node& cell, const Vec3& inwards) const;

    /// Of material, straight through it from a place at the skin, up to thickestThinWall and a little [cells].
    /// @param place in coordinates of the lattice [a]
    double thickness(const Vec3& place, const Vec3& inwards) const
    {
        return across(place, inwards.normalized()).length;
    }

private:
    /// Straight through the material.
    struct Chord {
        double length = 0; ///< [cells]
        Vec3 middle;
    };

    Chord across(const Vec3& place, const Vec3& inwards) const;
    double along(const Vec3& place, const Vec3& direction, double most) const;
    double goesOn(const Vec3& place, const Vec3& across, double most) const;
    double fractionAt(const Vec3& place) const;

    const CellFinder& m_finder;
};

} // namespace knead
