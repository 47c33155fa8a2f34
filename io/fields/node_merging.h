#pragma once

#include "io/fields/field_content.h"

namespace knead {

/// Whether a place or a displacement may be meant: finite, and no larger than what anybody makes [m].
bool isSensible(const Vec3& v);

/// The field in [m] without nodes that say nothing, and with one node in each place: the mean of its displacements.
/// @param metres in one of the unit of the nodes, and of the displacements
/// @param warnings gets what was left out and merged
DisplacementField mergedField(const FieldContent& content, double metresOfNodes, double metresOfValues,
                              std::vector<Message>& warnings);

} // namespace knead
