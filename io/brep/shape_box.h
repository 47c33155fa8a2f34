#pragma once

#include "core/geometry/vec3.h"

class TopoDS_Shape;

namespace knead {

/// The box of the faces of a shape [m], without tolerances; empty when there is none or it is not finite.
/// Tight for planes, cylinders and the like. A free-form face counts with all of its patch, also what is trimmed away.
Box boxOfFaces(const TopoDS_Shape& shape);

/// The same, cut back where it reaches beyond the triangles of the shape by more than they can be off.
/// @param deflection of the triangles [m]
Box tightened(const Box& box, const Box& ofTriangles, double deflection);

} // namespace knead
