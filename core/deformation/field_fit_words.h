#pragma once

#include "core/deformation/field_fit.h"

namespace knead {

/// Puts in words what was measured: FieldFit::mismatch and FieldFit::remarks.
/// @param unit in which the field was read; empty: unknown
void sayHowItFits(FieldFit& fit, const std::string& unit);

/// "(1, 2, 3) mm"
Message placeInMillimetres(const Vec3& place);

} // namespace knead
