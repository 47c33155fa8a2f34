#pragma once

#include "core/simulation/snapshot.h"

#include <span>
#include <vector>

namespace knead {

/// How much light of its surroundings each render vertex keeps beside tools: 1 far from them, least where one touches.
/// It tells how far a hovering tool is, and where it will touch. With g the distance of the tool, u the direction to its
/// nearest point and n the normal,
///
///     shade = product over tools of 1 - a F w,   w = (1 - (g / s)^2)^2, 0 where g >= s,   a = contactDarkest
///
/// with s the largest measure of the tool, or 0.3 of that for an imported part, whose distances take long. F is the
/// share of the light that a ball keeps off, which touches the nearest point from behind and is seen as large as the
/// tool from there: pi R^2 = area of its silhouette along u. With h = (g + R) / R, c = n . u, q^2 = h^2 - 1, k = 1 - h^2 c^2,
///
///     F = c / h^2, at least 0       where k <= 0: the horizon of the vertex does not cut the ball
///     F = (c acos(-c q / sqrt(1 - c^2)) - q sqrt(k)) / (pi h^2) + atan(sqrt(k) / q) / pi       else
///
/// (form factor of a sphere). For a ball this is exact, for a box right at and far from its faces.
/// @param points, normals x y z per render vertex, as they are drawn
/// @return per render vertex; empty where no tool is near
std::vector<float> contactShades(std::span<const float> points, std::span<const float> normals,
                                 std::span<const ToolState> tools);

/// What contactShades() takes off where all light is kept off.
inline constexpr double contactDarkest = 0.75;

} // namespace knead
