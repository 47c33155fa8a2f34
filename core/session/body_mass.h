#pragma once

#include "core/session/frame.h"

namespace knead {

/// How much of a body there is and where its middle is.
struct BodyMass {
    double volume = 0;          ///< within its skin [m^3]
    double mass = 0;            ///< [kg]
    Vec3 center = Vec3::Zero(); ///< of mass [m]
};

/// The volume is that of the exact part; the mass that of its materials, regions included.
/// @param present has the materials
BodyMass massAtRest(const FilledModel& content, BodyId body, const Snapshot& present);

/// The volume is that of the exact part, changed as the skin has changed: what the triangles leave out is left out of both.
/// The mass is that at rest, since material neither comes nor goes.
/// @param shown perhaps of the past
BodyMass massNow(const FilledModel& content, BodyId body, const Frame& shown, const Snapshot& present);

} // namespace knead
