#pragma once

#include "core/geometry/spline_fit.h"

#include <Adaptor2d_Curve2d.hxx>
#include <Adaptor3d_Curve.hxx>
#include <Adaptor3d_Surface.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>

namespace knead {

/// Knots at a .. b for splines of a degree that are as rough where the source is, and smooth elsewhere: a jump of the first
/// derivative of the source gives a knot of multiplicity degree, one of the second derivative degree - 1, and so on.
SplineKnots knotsOf(const Adaptor3d_Curve& curve, double a, double b, int degree);
SplineKnots knotsOf(const Adaptor2d_Curve2d& curve, double a, double b, int degree);

enum class SurfaceDirection { u, v };
SplineKnots knotsOf(const Adaptor3d_Surface& surface, SurfaceDirection direction, double a, double b, int degree);

Handle(Geom_BSplineCurve) toGeometry(const SplineCurve& curve);
Handle(Geom_BSplineSurface) toGeometry(const SplineSurface& surface);

/// In the plane: x and y of the poles, each divided by its scale.
Handle(Geom2d_BSplineCurve) toPlaneGeometry(const SplineCurve& curve, const Vec2& scale);

} // namespace knead
