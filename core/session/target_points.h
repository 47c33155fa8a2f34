#pragma once

#include "core/model/part.h"
#include "core/session/compensation_study.h"
#include "core/task/task_control.h"

#include <vector>

namespace knead {

/// Places of a part at which deviations are looked at, and at which its compensation is known.
struct TargetPoints {
    std::vector<Vec3> places; ///< on the surface, then inside [m]
    std::vector<bool> counts; ///< whether the deviation there counts: of places on faces that do
    double spacing = 0;       ///< about as far as they are apart [m]
};

/// Places all over the surfaces of the parts, their edges and corners among them, and inside closed ones on a lattice, so that a map
/// of a field at them is well supported everywhere in the part. No two are closer than half the spacing.
/// @param faces that count; empty: all
/// @param spacing [m]; 0: one that gives about 2000 places on the surface
/// @throws Problem when a part or a face is not there, when there is no surface, or when there would be too many places. @throws
/// Cancelled
TargetPoints targetPoints(const Model& model, const FacesOfParts& faces, double spacing,
                          TaskControl& control = TaskControl::none());

} // namespace knead
