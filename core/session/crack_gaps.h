#pragma once

#include "core/session/filled_model.h"
#include "core/simulation/snapshot.h"

#include <cstdint>
#include <span>
#include <vector>

namespace knead {

/// Triangles of a drawn surface that do no more than span an open crack: where a crack could not be made a surface, or
/// has grown since that was done. They are not drawn, so that the crack is seen.
///
/// Such a triangle has an edge that is longer than when the body was filled, by half a spacing or more and by 1.3 times
/// as much as the connections that hold around it; and within two spacings of it a broken connection is stretched by half
/// or more.
/// @param body that carries the surface, with the objects of `state`
/// @param places of its vertices [m]
/// @return ascending; empty where nothing is broken
std::vector<std::uint32_t> trianglesAcrossCracks(const FilledBody& body, const Snapshot::BodyState& state,
                                                 std::span<const Vec3> places);

} // namespace knead
