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

/// Where the vertices of triangles lie.
enum class VertexPlace {
    onFaces,    ///< exactly
    volumeTrue, ///< moved off curved faces, by the deflection at most, so that the triangles hold the volume of the shape
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

/// The triangles that tessellate() left on the faces of the shape, with the vertices elsewhere.
TriangleMesh collectTriangles(const TopoDS_Shape& shape, const Tessellation& tessellation, VertexPlace place);

} // namespace knead
