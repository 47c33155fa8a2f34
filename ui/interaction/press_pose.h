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

/// Of a surface around a place, outward, of length 1: the mean over what lies within a radius and faces the same way.
/// @param triangles of `places`
/// @param triangle that the place lies on
Vec3 normalAround(std::span<const std::array<std::uint32_t, 3>> triangles, std::span<const float> points,
                  std::uint32_t triangle, const Vec3& place, double radius);

/// Force at which a ball stops in a material a third of its radius deep, roughly: H pi a^2 with H = 2.8 yield stresses (Tabor), no
/// more than Hertz's 4/3 E / (1 - nu^2) sqrt(r) d^1.5 [N].
double thumbForce(const Material& material, double radius);

} // namespace knead
