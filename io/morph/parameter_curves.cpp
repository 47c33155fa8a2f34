#include "io/morph/parameter_curves.h"

#include "io/morph/spline_geometry.h"

#include <Geom2dAdaptor_Curve.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt2d.hxx>

#include <cmath>
#include <functional>

namespace knead {

namespace {

constexpr std::size_t mostCurveSpans = 640;
constexpr double unitSpeed = 1e-12; // by which a line's may miss 1, which STEP takes it for

Vec2 placeOn(const Handle(Geom2d_Curve) & curve, double parameter)
{
    const gp_Pnt2d at = curve->Value(parameter);
    return {at.X(), at.Y()};
}

/// From one place to another one, evenly.
Handle(Geom2d_Curve) straightCurve(const Vec2& from, const Vec2& to, double first, double last)
{
    const Vec2 way = to - from;
    const double length = way.norm();
    if (length > 0 && std::abs(length / (last - first) - 1) < unitSpeed) {
        const Vec2 begin = from - first * way / length;
        return new Geom2d_Line(gp_Pnt2d(begin.x(), begin.y()), gp_Dir2d(way.x(), way.y()));
    }
    TColgp_Array1OfPnt2d poles(1, 2);
    poles(1) = {from.x(), from.y()};
    poles(2) = {to.x(), to.y()};
    TColStd_Array1OfReal knots(1, 2);
    knots(1) = first;
    knots(2) = last;
    TColStd_Array1OfInteger multiplicities(1, 2);
    multiplicities.Init(2);
    return new Geom2d_BSplineCurve(poles, knots, multiplicities, 1);
}

/// Whether a curve runs straight and evenly.
bool isStraight(const Handle(Geom2d_Curve) & curve)
{
    if (!Handle(Geom2d_Line)::DownCast(curve).IsNull())
        return true;
    const auto spline = Handle(Geom2d_BSplineCurve)::DownCast(curve);
    return !spline.IsNull() && spline->Degree() == 1 && spline->NbPoles() == 2 && !spline->IsRational();
}

Handle(Geom2d_BSplineCurve) copyOfPlainSpline(const Handle(Geom2d_Curve) & curve)
{
    const auto spline = Handle(Geom2d_BSplineCurve)::DownCast(curve);
    if (spline.IsNull() || spline->IsPeriodic() || spline->IsRational())
        return {};
    return Handle(Geom2d_BSplineCurve)::DownCast(spline->Copy());
}

/// A spline through what becomes of a curve's places.
Handle(Geom2d_Curve)
    fitted(const Handle(Geom2d_Curve) & curve, double first, double last, double newFirst, double newLast,
           const std::function<Vec2(const Vec2&)>& placeOf, const CurveFitting& fitting)
{
    const Geom2dAdaptor_Curve adaptor(curve, first, last);
    const double rate = (last - first) / (newLast - newFirst);
    const CurveTarget target = [&](std::span<const double> parameters, std::span<Vec3> places) {
        for (std::size_t i = 0; i < parameters.size(); ++i) {
            const gp_Pnt2d at = adaptor.Value(first + rate * (parameters[i] - newFirst));
            const Vec2 place = placeOf({at.X(), at.Y()}).cwiseProduct(fitting.scale);
            places[i] = Vec3(place.x(), place.y(), 0);
        }
    };
    SplineKnots knots = knotsOf(adaptor, first, last, fitting.degree);
    if (newFirst != first || newLast != last)
        for (double& knot : knots.values)
            knot = newFirst + (knot - first) / rate;
    const auto fit = fitCurve(target, knots, 0.3 * (newLast - newFirst),
                              {.degree = fitting.degree, .tolerance = fitting.tolerance, .mostSpans = mostCurveSpans});
    return toPlaneGeometry(fit.spline, fitting.scale);
}

} // namespace

Handle(Geom2d_Curve) withoutTrim(Handle(Geom2d_Curve) curve)
{
    for (;;) {
        const auto trimmed = Handle(Geom2d_TrimmedCurve)::DownCast(curve);
        if (trimmed.IsNull())
            return curve;
        curve = trimmed->BasisCurve();
    }
}

bool isPlain(const Handle(Geom2d_Curve) & curve)
{
    const Geom2dAdaptor_Curve adaptor(withoutTrim(curve));
    switch (adaptor.GetType()) {
    case GeomAbs_Line:
    case GeomAbs_Circle:
    case GeomAbs_Ellipse:
        return true;
    case GeomAbs_BSplineCurve:
        return !adaptor.IsPeriodic() && !adaptor.IsRational();
    default:
        return false;
    }
}

Handle(Geom2d_Curve)
    plainCurve(const Handle(Geom2d_Curve) & curve, double first, double last, const CurveFitting& fitting)
{
    return fitted(
        withoutTrim(curve), first, last, first, last, [](const Vec2& at) { return at; }, fitting);
}

Handle(Geom2d_Curve) carriedCurve(const Handle(Geom2d_Curve) & curve, double first, double last,
                                  const ParameterMap& map, const CurveFitting& fitting)
{
    const Handle(Geom2d_Curve) whole = withoutTrim(curve);
    if (isStraight(whole))
        return straightCurve(map.at(placeOn(whole, first)), map.at(placeOn(whole, last)), first, last);
    if (const Handle(Geom2d_BSplineCurve) spline = copyOfPlainSpline(whole); !spline.IsNull()) {
        for (int i = 1; i <= spline->NbPoles(); ++i) {
            const Vec2 pole = map.at({spline->Pole(i).X(), spline->Pole(i).Y()});
            spline->SetPole(i, {pole.x(), pole.y()});
        }
        return Handle(Geom2d_Curve)(spline);
    }
    return fitted(
        whole, first, last, first, last, [&](const Vec2& at) { return map.at(at); }, fitting);
}

Handle(Geom2d_Curve) rangedCurve(const Handle(Geom2d_Curve) & curve, double first, double last, double newFirst,
                                 double newLast, const CurveFitting& fitting)
{
    const Handle(Geom2d_Curve) whole = withoutTrim(curve);
    if (isStraight(whole))
        return straightCurve(placeOn(whole, first), placeOn(whole, last), newFirst, newLast);
    if (const Handle(Geom2d_BSplineCurve) spline = copyOfPlainSpline(whole); !spline.IsNull()) {
        TColStd_Array1OfReal knots(1, spline->NbKnots());
        for (int i = 1; i <= spline->NbKnots(); ++i)
            knots(i) = newFirst + (spline->Knot(i) - first) * (newLast - newFirst) / (last - first);
        spline->SetKnots(knots);
        return Handle(Geom2d_Curve)(spline);
    }
    return fitted(
        whole, first, last, newFirst, newLast, [](const Vec2& at) { return at; }, fitting);
}

} // namespace knead
