#pragma once

#include "core/mechanics/connection_data.h"

namespace knead {

/// Finds which objects are rubberlike, and what they are made of. @pre data.tensors
void findRubber(ConnectionData& data);

/// Finds the springs of connections from nominal lengths. @pre data.rubber()
void findSprings(ConnectionData& data);

/// Raises bounds of stiffness of rubberlike objects by the stretches about them.
void stiffenByStretch(const ConnectionData& data, const ObjectState& state, std::vector<double>& bounds);

} // namespace knead
