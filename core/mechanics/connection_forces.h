#pragma once

#include "core/mechanics/connection_data.h"

namespace knead {

/// Writes state.force and state.damping, see StructuralConnections::computeForces().
void findForces(ConnectionData& data, ObjectState& state, double dt, double flowTime);

} // namespace knead
