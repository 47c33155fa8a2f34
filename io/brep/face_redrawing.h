#pragma once

#include "io/brep/tessellation.h"

#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_MapOfShape.hxx>

#include <set>

class Poly_PolygonOnTriangulation;
class TopoDS_Edge;
class TopoDS_Face;

namespace knead {

/// The nodes of the triangles of a face along one of its edges; none where the face has no triangles.
/// @param edge as the face has it: a seam has two lines of nodes
Handle(Poly_PolygonOnTriangulation) polygonOf(const TopoDS_Edge& edge, const TopoDS_Face& face);

/// The edges on both sides of which a face lies, and that are no seams: its triangles join across them.
TopTools_MapOfShape slitsOf(const TopoDS_Face& face);

/// Gives a face triangles, drawn between the points that its neighbors have on common edges, and writes these points to its
/// edges.
/// @param facesOfEdges of the shape that the face is of; lengths in mm
/// @param badFaces those (by TShape) whose triangles say nothing of their edges
/// @return false when its wires do not close in the parameters, or run along an edge twice; then nothing has changed
bool redrawFace(const TopoDS_Face& face, const TopTools_IndexedDataMapOfShapeListOfShape& facesOfEdges,
                const std::set<const void*>& badFaces, const Tessellation& tessellation);

} // namespace knead
