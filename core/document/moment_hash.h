#pragma once

#include "core/simulation/moment.h"

#include <cstdint>

namespace knead {

/// Hash of the bits of a whole moment: materials, tools, fixtures, connections, contacts and energies as well as positions and
/// velocities (Simulation::stateHash() has no more than those). Equal for equal histories, on any machine, however often they
/// were looked at: means of forces since the last snapshot and sentences for the person are not in it.
std::uint64_t momentHash(Moment moment);

} // namespace knead
