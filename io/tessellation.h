#pragma once

#include "core/geometry/triangle_mesh.h"
#include "io/importer.h"

class TopoDS_Shape;

namespace knead {

/// How fine triangles are.
struct Tessellation {
    double deflection = 0; ///< chord error [m]
    double angle = 0.2;    ///< between neighboring chords [rad]
};

/// What the options ask for a shape of this size.
Tessellation tessellationFor(double diagonal, const ImportOptions& options);

/// Triangles of the faces of a shape [m], as the faces are oriented, numbered by face in the order of
/// TopExp::MapShapes.
/// Neighbors share the vertices of their common edge because the topology says so, not because they lie close: a solid
/// with closed shells gives a mesh with closed indices whatever its tolerances. Where the two sides of an edge were cut
/// differently the mesh stays open.
/// @param shape lengths in mm
TriangleMesh tessellate(const TopoDS_Shape& shape, const Tessellation& tessellation);

} // namespace knead
