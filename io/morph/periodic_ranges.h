#pragma once

#include <TopoDS_Shape.hxx>

namespace knead {

/// Brings the ranges of edges on circles and other periodic curves to where the first period begins, with those of their curves on
/// faces. OpenCASCADE's check does so with the former alone, and takes an edge for wrong that has a spline on a face then.
/// @param shape whose edges nothing else has: they are changed in place
void bringRangesIntoPeriod(const TopoDS_Shape& shape);

} // namespace knead
