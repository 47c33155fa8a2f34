#pragma once

#include "core/geometry/smooth_map.h"

#include <cstdint>
#include <memory>

namespace knead {

/// What a person does to space between two planes by numbers. Stored: keep the numbers.
enum class NumberKind : std::uint8_t {
    bend = 0,    ///< into an arc of a circle
    twist = 1,   ///< about the axis
    taper = 2,   ///< cross-sections grow or shrink
    stretch = 3, ///< along the axis
    shear = 4,   ///< cross-sections move sideways
    scale = 5,   ///< cross-sections grow or shrink, and what lies between the planes gets longer or shorter by as much
};

/// Bending, twisting, tapering, stretching, shearing or scaling along an axis between two planes across it: x(X) in closed form.
/// What lies outside of the planes moves as a rigid thing, or with one factor.
struct NumberDeformation {
    NumberKind kind = NumberKind::bend;
    Vec3 origin = Vec3::Zero(); ///< a place of the axis [m]
    Vec3 axis = Vec3::UnitX();  ///< along which it runs, of unit length
    Vec3 side = Vec3::UnitZ();  ///< toward which it bends or shears: of unit length, across the axis
    double from = 0;            ///< the first plane, along the axis from the origin [m]
    double to = 0;              ///< the second one, > from [m]
    double angle = 0;           ///< bend, twist: of the second plane against the first one [rad]
    double factor = 1;          ///< taper, stretch, scale: > 0, of what is at or behind the second plane
    double shift = 0;           ///< shear: of the second plane, toward `side` [m]
    double neutral = 0;         ///< bend: of the plane that keeps its length, along `side` from the origin [m]
    double stays = 0;           ///< what stays where it is: 0 the first plane, 1 the second one, 0.5 the middle
    bool eases = false;         ///< begins and ends gently (in a quintic), so that no crease shows at the planes

    double length() const { return to - from; }
    friend bool operator==(const NumberDeformation&, const NumberDeformation&) = default;
};

} // namespace knead
