#pragma once

#include <TopAbs_ShapeEnum.hxx>

class TopoDS_Shape;

namespace knead {

/// How many different solids, shells, faces ... a shape holds.
int countDistinct(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind);

/// Of the box of control points, quick and somewhat large [mm]; 0 for an empty shape.
double diagonalOf(const TopoDS_Shape& shape);

} // namespace knead
