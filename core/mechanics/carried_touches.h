#pragma once

#include "core/mechanics/surface_contacts.h"

namespace knead {

/// What the skin of a body remembers of the surfaces that it touches, taken over by its next filling: each new point has the share of
/// its area in what the nearest old one remembers, and all together as much pressure as there was. So friction goes on, and what sticks
/// sticks. Between the points that touched before, a tool reaches into the surface, sharp ones by a good part of a spacing: new points
/// and objects keep how much deeper they are than what touched, see Touch::kept, and come out without a blow.
/// @param touches of all bodies, before
/// @param before, position what the body was, and where its objects are [m]
/// @param after what it is now
/// @param skin where its points are now [m]
/// @return those of this body, for the points of `after`
std::vector<SurfaceContacts::Touch> carriedTouches(std::span<const SurfaceContacts::Touch> touches, std::uint32_t body,
                                                   const Aggregate& before, const VectorArray& position,
                                                   const Aggregate& after, std::span<const Vec3> skin,
                                                   std::span<const RigidSurface> surfaces);

} // namespace knead
