#include "io/brep/parameter_range.h"

#include <BRepAdaptor_Surface.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <math.hxx>
#include <math_Vector.hxx>

#include <algorithm>
#include <cmath>
#include <utility>

namespace knead {

namespace {

constexpr double widestAngle = 1.6;   // [rad] of a piece of a round surface: a little over a quarter
constexpr int roundOrder = 7;         // of Gauss integration over it; exact to 1e-11
constexpr int extraOrder = 3;         // beyond the degree of a spline; the integrand has up to three times its degree
constexpr int extraRationalOrder = 7; // that of a rational one has no degree
constexpr int highestOrder = 24;
constexpr int unknownDegree = 7;       // taken for curves and surfaces that are no splines
constexpr int mostCuts = 64;           // of a piece, by angle
constexpr std::size_t somePieces = 48; // up to so many with three points each; more are so short that two will do

bool isRound(GeomAbs_SurfaceType type)
{
    return type == GeomAbs_Cylinder || type == GeomAbs_Cone || type == GeomAbs_Sphere || type == GeomAbs_Torus;
}

/// Cuts pieces that are wider than allowed.
void refine(ParameterRange& range, double widest)
{
    std::vector<double> knots;
    for (std::size_t i = 0; i + 1 < range.knots.size(); ++i) {
        const double width = range.knots[i + 1] - range.knots[i];
        const int count = std::clamp(static_cast<int>(std::ceil(width / widest)), 1, mostCuts);
        for (int cut = 0; cut < count; ++cut)
            knots.push_back(range.knots[i] + width * cut / count);
    }
    knots.push_back(range.knots.back());
    range.knots = std::move(knots);
}

/// The ends of a range and the knots between them. The adaptors' own lists of intervals lack knots of periodic splines.
/// @param period 0 for none
std::vector<double> knotsBetween(double first, double last, const TColStd_Array1OfReal& knots, double period)
{
    std::vector<double> result{first};
    const double margin = narrowestPiece * (last - first);
    const int turns = period > 0 ? 1 : 0;
    for (int turn = -turns; turn <= turns; ++turn)
        for (const double knot : knots)
            if (const double value = knot + turn * period; value > result.back() + margin && value < last - margin)
                result.push_back(value);
    result.push_back(last);
    return result;
}

std::vector<double> knotsOf(const Handle(Adaptor3d_Curve) & curve, double first, double last)
{
    if (curve->GetType() != GeomAbs_BSplineCurve)
        return {first, last};
    const Handle(Geom_BSplineCurve) spline = curve->BSpline();
    return knotsBetween(first, last, spline->Knots(), spline->IsPeriodic() ? spline->Period() : 0);
}

std::vector<double> knotsOf(const Geom2dAdaptor_Curve& curve)
{
    if (curve.GetType() != GeomAbs_BSplineCurve)
        return {curve.FirstParameter(), curve.LastParameter()};
    const Handle(Geom2d_BSplineCurve) spline = curve.BSpline();
    return knotsBetween(curve.FirstParameter(), curve.LastParameter(), spline->Knots(),
                        spline->IsPeriodic() ? spline->Period() : 0);
}

std::vector<double> uKnotsOf(const BRepAdaptor_Surface& surface)
{
    const double first = surface.FirstUParameter();
    const double last = surface.LastUParameter();
    if (surface.GetType() == GeomAbs_BSplineSurface) {
        const Handle(Geom_BSplineSurface) spline = surface.Surface().BSpline();
        return knotsBetween(first, last, spline->UKnots(), spline->IsUPeriodic() ? spline->UPeriod() : 0);
    }
    return surface.GetType() == GeomAbs_SurfaceOfExtrusion ? knotsOf(surface.BasisCurve(), first, last)
                                                           : std::vector<double>{first, last};
}

std::vector<double> vKnotsOf(const BRepAdaptor_Surface& surface)
{
    const double first = surface.FirstVParameter();
    const double last = surface.LastVParameter();
    if (surface.GetType() == GeomAbs_BSplineSurface) {
        const Handle(Geom_BSplineSurface) spline = surface.Surface().BSpline();
        return knotsBetween(first, last, spline->VKnots(), spline->IsVPeriodic() ? spline->VPeriod() : 0);
    }
    return surface.GetType() == GeomAbs_SurfaceOfRevolution ? knotsOf(surface.BasisCurve(), first, last)
                                                            : std::vector<double>{first, last};
}

int orderFor(int degree, bool isRational)
{
    return std::min(degree + (isRational ? extraRationalOrder : extraOrder), highestOrder);
}

bool isSpline(const BRepAdaptor_Surface& surface)
{
    return surface.GetType() == GeomAbs_BSplineSurface || surface.GetType() == GeomAbs_BezierSurface;
}

} // namespace

GaussRule gaussRule(int order)
{
    math_Vector points(1, order);
    math_Vector weights(1, order);
    math::GaussPoints(order, points);
    math::GaussWeights(order, weights);
    GaussRule rule;
    for (int i = 1; i <= order; ++i) {
        rule.points.push_back(points(i));
        rule.weights.push_back(weights(i));
    }
    return rule;
}

int orderFor(std::size_t pieces, int order)
{
    return pieces <= fewPieces ? order : std::min(order, pieces <= somePieces ? 3 : 2);
}

ParameterRange uRangeOf(const BRepAdaptor_Surface& surface)
{
    ParameterRange range{uKnotsOf(surface)};
    const GeomAbs_SurfaceType type = surface.GetType();
    if (type == GeomAbs_Plane)
        range.order = 1; // distance from a point and normal are the same all over a plane
    else if (isRound(type))
        range.order = roundOrder;
    else
        range.order =
            isSpline(surface) ? orderFor(surface.UDegree(), surface.IsURational()) : orderFor(unknownDegree, false);
    if (isRound(type) || type == GeomAbs_SurfaceOfRevolution)
        refine(range, widestAngle);
    range.order = orderFor(range.pieces(), range.order);
    return range;
}

ParameterRange vRangeOf(const BRepAdaptor_Surface& surface)
{
    ParameterRange range{vKnotsOf(surface)};
    const GeomAbs_SurfaceType type = surface.GetType();
    if (type == GeomAbs_Plane)
        range.order = 1;
    else if (isRound(type))
        range.order = roundOrder;
    else
        range.order =
            isSpline(surface) ? orderFor(surface.VDegree(), surface.IsVRational()) : orderFor(unknownDegree, false);
    if (type == GeomAbs_Sphere || type == GeomAbs_Torus)
        refine(range, widestAngle);
    range.order = orderFor(range.pieces(), range.order);
    return range;
}

ParameterRange rangeOf(const Geom2dAdaptor_Curve& curve)
{
    ParameterRange range{knotsOf(curve)};
    const GeomAbs_CurveType type = curve.GetType();
    if (type == GeomAbs_Line) {
        range.order = 2;
        return range;
    }
    const bool isSpline = type == GeomAbs_BSplineCurve || type == GeomAbs_BezierCurve;
    range.order = isSpline ? orderFor(curve.Degree(), curve.IsRational()) : orderFor(unknownDegree, false);
    const bool isAngle = type == GeomAbs_Circle || type == GeomAbs_Ellipse;
    refine(range, isAngle ? widestAngle : range.width() / 4); // a single rational piece may be half a circle
    return range;
}

} // namespace knead
