#pragma once

#include "core/aggregate/material.h"

namespace knead::scenes {

/// Clay as it is kneaded, which neither tears nor sticks.
inline Material kneadedClay()
{
    Material material{.density = 1700, .youngsModulus = 5e5, .poissonRatio = 0.45, .dampingRatio = 0.2};
    material.shapeDamping = 20;
    material.friction = 0.5;
    material.yieldStress = 1e4;
    material.relaxationTime = 0.002;
    return material;
}

/// The same as it is on a table: it tears, sticks to itself, and heals.
inline Material modelingClay()
{
    Material material = kneadedClay();
    material.tensileStrength = 1e5;
    material.elongationAtBreak = 3;
    material.toughness = 50;
    material.adhesion = 1000;
    material.healingTime = 0.3;
    return material;
}

} // namespace knead::scenes
