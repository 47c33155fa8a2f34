#pragma once

#include <TopoDS_Shape.hxx>

namespace knead {

/// Brings the ranges of edges on circles and other periodic curves into the first period, with those of their curves on
/// faces. OpenCASCADE's check takes edges on circles from 2 pi on for wrong that have a fitted spline on a plane, however close
/// that is: of a thin tube with 1,018 faces, 75.
/// @param shape whose edges nothing else has: they are changed in place
void bringRangesIntoPeriod(const TopoDS_Shape& shape);

} // namespace knead
