#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace knead {

/// Triangles between the corners of a polygon, counter-clockwise; all corners are used, none is added.
///
/// Holes are joined to the outline by bridges; then corners are cut off one after the other, the best shaped triangle first,
/// and diagonals exchanged where that makes better ones. A polygon that overlaps itself, by rounding for instance, still gets a full set of triangles with each side of
/// it used once: some of them face the other way then.
/// @param corners the outline, counter-clockwise, then the holes, clockwise
/// @param loopEnds for the outline and for each hole: one past its last corner
std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Eigen::Vector2d> corners,
                                                      std::span<const std::size_t> loopEnds);

} // namespace knead
