#pragma once

#include "core/aggregate/material.h"
#include "core/mechanics/manipulator.h"

#include <array>
#include <cstdint>
#include <span>

namespace knead {

/// From where to where a tool goes that is pressed onto a place.
struct PressPoses {
    Pose away; ///< it touches nothing there
    Pose deep; ///< it would be in the material by its own thickness
};

/// Both along the outward normal of the place. The tool is turned no more than it takes: a block, a plate or a cylinder until one of
/// its sides faces the place, a wedge until its edge does; balls and parts stay as they are.
/// @param normal of length 1
/// @param gap between tool and place at the start [m]
PressPoses pressPoses(const ToolShape& shape, const Quaternion& rotation, const Vec3& place, const Vec3& normal,
                      double gap);

/// A place of a surface, and what that is like around it.
struct SurfaceSpot {
    Vec3 place = Vec3::Zero();   ///< [m]
    Vec3 normal = Vec3::UnitZ(); ///< outward, the mean around the place, of length 1
    Vec3 level = Vec3::Zero();   ///< the mean of the surface around the place [m]
};

/// Means over what lies within a radius of the place and faces the same way.
/// @param triangles of `points`, which are x y z of each vertex [m]
/// @param triangle that the place lies on
SurfaceSpot surfaceSpot(std::span<const std::array<std::uint32_t, 3>> triangles, std::span<const float> points,
                        std::uint32_t triangle, const Vec3& place, double radius);

/// Force at which a ball stops in a material a third of its radius deep, roughly: H pi a^2 with H = 2.8 yield stresses (Tabor), no
/// more than Hertz's 4/3 E / (1 - nu^2) sqrt(r) d^1.5 [N].
double thumbForce(const Material& material, double radius);

} // namespace knead
