#pragma once

#include "io/brep/tessellation.h"

class TopoDS_Shape;

namespace knead {

/// Gives triangles to faces of a shape that the modeler found none for, or whose triangles do not end at its edges or meet
/// those of the neighbor there. Other faces keep theirs. Where a face cannot be drawn in its parameters, as when its wires
/// do not close there, it stays as it is.
/// @param shape lengths in mm; as BRepMesh left it
void mendTriangles(const TopoDS_Shape& shape, const Tessellation& tessellation);

/// Draws the faces anew whose triangles have another area than they: on some long swept faces the modeler's lie far off.
/// @return whether there were any
bool redrawFacesOfWrongArea(const TopoDS_Shape& shape, const Tessellation& tessellation);

} // namespace knead
