#include "io/morph/spline_geometry.h"

#include "io/morph/millimetre_map.h"

#include <Standard_Failure.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TColgp_Array2OfPnt.hxx>

#include <algorithm>
#include <array>
#include <map>

namespace knead {

namespace {

constexpr double sameKnot = 1e-7; // of the range

/// @param count of intervals of a continuity
/// @param list writes their bounds
template <typename Count, typename List>
SplineKnots knotsBetween(double a, double b, int degree, const Count& count, const List& list)
{
    const double same = sameKnot * (b - a);
    std::map<double, int> inner; // multiplicity by knot
    const std::array levels{GeomAbs_C1, GeomAbs_C2, GeomAbs_C3, GeomAbs_CN};
    for (std::size_t level = 0; level < levels.size(); ++level) {
        const int multiplicity = level + 1 < levels.size() ? std::max(1, degree - static_cast<int>(level)) : 1;
        try {
            const int intervals = count(levels[level]);
            if (intervals < 2)
                continue;
            TColStd_Array1OfReal bounds(1, intervals + 1);
            list(bounds, levels[level]);
            for (int i = 2; i <= intervals; ++i) {
                const double knot = bounds(i);
                if (knot < a + 10 * same || knot > b - 10 * same)
                    continue;
                const auto near = inner.lower_bound(knot - same);
                if (near != inner.end() && near->first <= knot + same)
                    near->second = std::max(near->second, multiplicity);
                else
                    inner.emplace(knot, multiplicity);
            }
        } catch (const Standard_Failure&) { // some surfaces do not know their intervals: the fit finds what matters
        }
    }
    SplineKnots knots{{a}, {1}};
    for (const auto& [knot, multiplicity] : inner) {
        knots.values.push_back(knot);
        knots.multiplicities.push_back(multiplicity);
    }
    knots.values.push_back(b);
    knots.multiplicities.push_back(1);
    return knots;
}

struct KnotArrays {
    TColStd_Array1OfReal values;
    TColStd_Array1OfInteger multiplicities;

    explicit KnotArrays(const SplineKnots& knots)
        : values(1, static_cast<int>(knots.values.size()))
        , multiplicities(1, static_cast<int>(knots.values.size()))
    {
        std::copy(knots.values.begin(), knots.values.end(), values.begin());
        std::copy(knots.multiplicities.begin(), knots.multiplicities.end(), multiplicities.begin());
    }
};

int polesOf(const SplineKnots& knots, int degree)
{
    int sum = -degree - 1;
    for (const int multiplicity : knots.multiplicities)
        sum += multiplicity;
    return sum;
}

} // namespace

SplineKnots knotsOf(const Adaptor3d_Curve& curve, double a, double b, int degree)
{
    return knotsBetween(
        a, b, degree, [&](GeomAbs_Shape level) { return curve.NbIntervals(level); },
        [&](TColStd_Array1OfReal& bounds, GeomAbs_Shape level) { curve.Intervals(bounds, level); });
}

SplineKnots knotsOf(const Adaptor2d_Curve2d& curve, double a, double b, int degree)
{
    return knotsBetween(
        a, b, degree, [&](GeomAbs_Shape level) { return curve.NbIntervals(level); },
        [&](TColStd_Array1OfReal& bounds, GeomAbs_Shape level) { curve.Intervals(bounds, level); });
}

SplineKnots knotsOf(const Adaptor3d_Surface& surface, SurfaceDirection direction, double a, double b, int degree)
{
    const bool alongU = direction == SurfaceDirection::u;
    return knotsBetween(
        a, b, degree,
        [&](GeomAbs_Shape level) { return alongU ? surface.NbUIntervals(level) : surface.NbVIntervals(level); },
        [&](TColStd_Array1OfReal& bounds, GeomAbs_Shape level) {
            alongU ? surface.UIntervals(bounds, level) : surface.VIntervals(bounds, level);
        });
}

Handle(Geom_BSplineCurve) toGeometry(const SplineCurve& curve)
{
    TColgp_Array1OfPnt poles(1, static_cast<int>(curve.poles.size()));
    std::transform(curve.poles.begin(), curve.poles.end(), poles.begin(), toPoint);
    const KnotArrays knots(curve.knots);
    return new Geom_BSplineCurve(poles, knots.values, knots.multiplicities, curve.degree);
}

Handle(Geom2d_BSplineCurve) toPlaneGeometry(const SplineCurve& curve, const Vec2& scale)
{
    TColgp_Array1OfPnt2d poles(1, static_cast<int>(curve.poles.size()));
    std::transform(curve.poles.begin(), curve.poles.end(), poles.begin(),
                   [&](const Vec3& pole) { return gp_Pnt2d(pole.x() / scale.x(), pole.y() / scale.y()); });
    const KnotArrays knots(curve.knots);
    return new Geom2d_BSplineCurve(poles, knots.values, knots.multiplicities, curve.degree);
}

Handle(Geom_BSplineSurface) toGeometry(const SplineSurface& surface)
{
    const int nu = polesOf(surface.u, surface.degree);
    const int nv = polesOf(surface.v, surface.degree);
    TColgp_Array2OfPnt poles(1, nu, 1, nv);
    std::size_t next = 0;
    for (int i = 1; i <= nu; ++i)
        for (int j = 1; j <= nv; ++j)
            poles(i, j) = toPoint(surface.poles[next++]);
    const KnotArrays u(surface.u);
    const KnotArrays v(surface.v);
    return new Geom_BSplineSurface(poles, u.values, v.values, u.multiplicities, v.multiplicities, surface.degree,
                                   surface.degree);
}

} // namespace knead
