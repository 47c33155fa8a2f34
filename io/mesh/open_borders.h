#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/message/message.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace knead {

/// A closed walk along edges where triangles end.
struct OpenLoop {
    std::vector<std::uint32_t> vertices; ///< in the order of the missing triangles; the last one is joined to the first
    std::uint32_t face = 0;              ///< of a neighbor, as in TriangleMesh::faceOfTriangle
};

/// Every edge along which the triangles of a mesh end belongs to one loop.
std::vector<OpenLoop> openLoopsOf(const TriangleMesh& mesh);

using Polyline = std::vector<Vec3>; ///< [m]

double lengthOf(const Polyline& line); ///< [m]

/// The loops as polylines that end where they began.
std::vector<Polyline> openBordersOf(const TriangleMesh& mesh);

/// Joins polylines at ends closer than `tolerance` [m]; each runs on as long as there is a next one.
std::vector<std::vector<Vec3>> chained(std::vector<std::vector<Vec3>> lines, double tolerance);

/// "25 open edges in 1 border, 364 mm long in all; the largest opening is 123 mm across and flat".
Message describeBorders(std::size_t edges, const std::vector<std::vector<Vec3>>& borders);

/// The same for borders of a mesh, where each segment is an edge.
Message describeBorders(const std::vector<std::vector<Vec3>>& borders);

} // namespace knead
