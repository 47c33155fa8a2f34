#pragma once

#include "core/mechanics/connection_data.h"

namespace knead {

/// What broke at one look.
struct BreakReport {
    double released = 0; ///< energy of connections that broke [J]
    std::size_t broken = 0;
};

/// Breaks connections that bear too much, see StructuralConnections.
BreakReport breakOverloaded(ConnectionData& data, const ObjectState& state, double step);

/// Takes live connections away. @return energy that they had [J]
double breakAll(ConnectionData& data, const ObjectState& state, const std::vector<BrokenConnection>& connections,
                double step);

/// What a broken connection changes at its ends.
void markBroken(ConnectionData& data, const ConnectionId& connection);

/// The shape of an object some connections of which broke.
void findLiveShape(ConnectionData& data, ObjectIndex object);

} // namespace knead
