#pragma once

#include "core/geometry/vec3.h"

#include <Geom_Curve.hxx>

#include <optional>
#include <vector>

namespace knead {

/// A curve of simple form over its own parameter, which runs evenly with that of another one.
struct CanonicalCurve {
    Handle(Geom_Curve) curve; ///< [mm]
    double first = 0;
    double last = 0;
    double error = 0; ///< largest distance at parameters that belong together [mm]
};

/// The straight line or the circle that places lie on which follow each other evenly.
/// @param places from one end to the other, 5 or more [mm]
/// @param tolerance by which they may be off [mm]
/// @return none where they lie on none
std::optional<CanonicalCurve> canonicalCurve(const std::vector<Vec3>& places, double tolerance);

} // namespace knead
