#pragma once

#include "core/geometry/spline_fit.h"

#include <Eigen/Core>
#include <Geom2d_Curve.hxx>

namespace knead {

/// Takes parameters of one surface to those of another one that runs evenly with it: p -> linear p + shift.
struct ParameterMap {
    Eigen::Matrix2d linear = Eigen::Matrix2d::Identity();
    Vec2 shift = Vec2::Zero();

    Vec2 at(const Vec2& parameters) const { return linear * parameters + shift; }

    /// Whether what is to the left of a curve comes to its right.
    bool mirrors() const { return linear.determinant() < 0; }
};

/// How curves are drawn anew that STEP cannot hold as they are.
struct CurveFitting {
    int degree = 5;
    double tolerance = 1e-9; ///< [mm]
    Vec2 scale{1, 1};        ///< how far a step along u and v goes in space [mm]
};

/// The curve itself without ends of its own.
Handle(Geom2d_Curve) withoutTrim(Handle(Geom2d_Curve) curve);

/// Whether STEP can hold a curve as it is: lines, circles, ellipses and plain B-splines. Its readers fail on hyperbolas and
/// parabolas, and turn the others into curves with another parameter.
bool isPlain(const Handle(Geom2d_Curve) & curve);

/// A B-spline that is close to a curve, in the same parameter.
Handle(Geom2d_Curve)
    plainCurve(const Handle(Geom2d_Curve) & curve, double first, double last, const CurveFitting& fitting);

/// The same in the parameters of another surface. What is straight stays so exactly.
Handle(Geom2d_Curve) carriedCurve(const Handle(Geom2d_Curve) & curve, double first, double last,
                                  const ParameterMap& map, const CurveFitting& fitting);

/// The same curve over another range of its parameter, evenly.
Handle(Geom2d_Curve) rangedCurve(const Handle(Geom2d_Curve) & curve, double first, double last, double newFirst,
                                 double newLast, const CurveFitting& fitting);

} // namespace knead
