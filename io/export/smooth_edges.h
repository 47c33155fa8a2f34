#pragma once

#include "core/geometry/vec3.h"
#include "io/morph/millimetre_map.h"

#include <TopoDS_Shape.hxx>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace knead {

/// What became of edges at which two faces, or the two ends of a closed one, had the same normal.
struct SmoothEdges {
    std::size_t count = 0;     ///< that could be compared
    double largestAngle = 0;   ///< between the two normals now [rad]
    Vec3 where = Vec3::Zero(); ///< that is [mm]
};

/// Compares normals across the smooth edges of a shape after it was carried along, at places spread over each edge.
/// @param source at rest [mm]
/// @param moved with the same faces, where `map` takes those of the source
/// @param origin per face of `moved`, which of the source it is; none: they are in the same order. Edges of faces that came
/// in several ones are not compared
/// @param tolerance of the faces that were moved [mm]
SmoothEdges compareSmoothEdges(const TopoDS_Shape& source, const TopoDS_Shape& moved,
                               const std::vector<std::uint32_t>& origin, const MillimetreMap& map, double tolerance);

} // namespace knead
