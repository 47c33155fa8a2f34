#pragma once

#include "core/mechanics/connection_data.h"

namespace knead {

/// See StructuralConnections.
double largestFrequency(ConnectionData& data, ObjectState& state, const std::vector<double>& added);
std::vector<std::int8_t> fastestMode(const ConnectionData& data);
void setFastestMode(ConnectionData& data, const std::vector<std::int8_t>& mode);
std::vector<double> stiffnessBounds(const ConnectionData& data, const ObjectState& state,
                                    const std::vector<double>& added);
double leastDampingTime(const ConnectionData& data);

} // namespace knead
