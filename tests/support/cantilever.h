#pragma once

#include "support/quadratic_tets.h"

#include <string>

/// How resources/examples/cantilever was made: an arm that is screwed down at one end and pressed down and aside at the other.
namespace knead::quadratic_tets {

/// Without its screw holes, as people mesh such a part.
inline Mesh cantileverMesh()
{
    Blocks blocks;
    blocks.addBox({0, 0, 0}, {120, 20, 10}, {10, 2, 1});
    return std::move(blocks.mesh);
}

/// Of a stiff plastic, with large rotations.
inline std::string cantileverInput()
{
    constexpr double near = 1e-6;
    return inputOf(cantileverMesh(), {.held = [](const Vec3& place) { return place.x() < 24 + near; },
                                      .pushed = [](const Vec3& place) { return place.x() > 120 - near; },
                                      .force = Vec3(0, 20, -100),
                                      .modulus = 2300,
                                      .isNonlinear = true});
}

} // namespace knead::quadratic_tets
