#pragma once

#include "core/deformation/number_deformation.h"

#include <string>

namespace knead {

/// A deformation by numbers as grips do it to material: what lies beyond each plane is held and goes as the formula says, and what lies
/// between finds its own shape. Bends, twists, stretches and shears; whether it eases says nothing here.
struct PhysicalDeformation {
    NumberDeformation numbers;
    double duration = 1;   ///< of the way [s], 0.01 .. 3600; it begins and ends at rest
    bool letsGo = false;   ///< at the end, of what has moved most, so that the material springs back
    std::string name = {}; ///< of the grips, see nameOfGrip()
};

} // namespace knead
