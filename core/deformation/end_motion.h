#pragma once

#include "core/deformation/number_deformation.h"

namespace knead {

/// What lies beyond one of the planes of a deformation by numbers.
enum class NumberEnd : std::uint8_t { first, second };

/// Whether the ends go as rigid things, so that grips can lead them: all but what changes cross-sections.
bool hasRigidEnds(NumberKind kind);

/// Where a rigid end is: turned by an angle about turnAxis(), and where its reference point has gone, that on the axis, at the height
/// of the neutral plane, in its plane.
struct EndPlace {
    double angle = 0;          ///< [rad]
    Vec3 place = Vec3::Zero(); ///< [m]
};

/// Of unit length: across of axis and side for a bend, the axis for all others.
Vec3 turnAxis(const NumberDeformation& deformation);

/// The place of an end with a share of the whole angle, factor less 1, or shift. @pre hasRigidEnds() @throws Problem as NumberMap
EndPlace endPlace(const NumberDeformation& deformation, NumberEnd end, double share);

} // namespace knead
