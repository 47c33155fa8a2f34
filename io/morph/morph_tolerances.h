#pragma once

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>

namespace knead {

/// Raises the tolerances of all edges and vertices of a shape to what their curves and surfaces really miss each other by, with
/// a small margin. In parallel.
/// @return the largest of an edge [mm]
double raiseTolerances(const TopoDS_Shape& shape);

/// Edges that leave a vertex almost in one direction may cross just outside its ball, which is the shape's tolerance for that;
/// doubles the tolerance of such vertices until the checks pass or nothing is left to widen.
/// @param most tolerance that a vertex may get [mm]
/// @param widened counts the vertices
/// @return whether the shape passes the checks
bool widenVertices(const TopoDS_Shape& shape, double most, int& widened);

} // namespace knead
