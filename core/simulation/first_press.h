#pragma once

#include "core/aggregate/material.h"
#include "core/mechanics/manipulator.h"
#include "core/model/part.h"

#include <limits>

namespace knead {

/// Something to begin with that shows what a part does: what is at least twice as long as thick is held at one end and bent by a
/// block near the other; what is compact is held at the bottom and squeezed. The stroke is a share of the size, so that any
/// part moves visibly and none is crushed; less where that would break it, or where its walls are too thin for the objects.
struct FirstPress {
    Box held;               ///< material in it stays where it is [m]
    Manipulator block;      ///< with key frames from time 0 on
    bool bends = false;     ///< the part gives way below the block, which a floor would not let it
    double duration = 0;    ///< until all is over [s]
    bool hasBodies = false; ///< more than one, which may touch
    int objects = 0;        ///< that show the walls, as far as a run of some seconds allows
};

/// @param bearableStrain what the material bears before it breaks, see below
/// @throws Problem when no part is closed.
FirstPress firstPress(const Model& model, double bearableStrain = std::numeric_limits<double>::infinity());

/// Strain of a bar when it breaks; infinite for what never does.
double strainAtBreak(const Material& material);

} // namespace knead
