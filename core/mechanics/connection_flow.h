#pragma once

#include "core/mechanics/connection_data.h"

namespace knead {

/// A trial of plastic flow over a time at these positions, that begins at data.changes [s]. @pre data.tensors
void findFlow(ConnectionData& data, const VectorArray& position, double duration);

/// The trial takes place. @return energy that went with it [J]
double acceptFlow(ConnectionData& data);

/// The trial is forgotten.
inline void rejectFlow(ConnectionData& data)
{
    data.hasTrial = false;
    data.forgetEnergy();
}

/// See StructuralConnections.
double renormalize(ConnectionData& data, const ObjectState& state, const std::vector<std::uint8_t>& marks,
                   double share);
void recover(ConnectionData& data, double dt);

/// Finds C of states that were kept without it from nominal lengths.
void findMetric(ConnectionData& data);

} // namespace knead
