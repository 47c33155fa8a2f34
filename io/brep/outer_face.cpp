#include "io/brep/outer_face.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Curve.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Vec2d.hxx>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace knead {

namespace {

constexpr double smallShare = 1e-6; // of a size, for what should be none
constexpr int samples = 16;

/// The ranges of the parameters of a surface.
struct Ranges {
    double u0 = 0;
    double u1 = 0;
    double v0 = 0;
    double v1 = 0;
};

Ranges rangesOf(const Handle(Geom_Surface) & surface)
{
    Ranges ranges;
    surface->Bounds(ranges.u0, ranges.u1, ranges.v0, ranges.v1);
    return ranges;
}

/// How large the circle is that a surface has at v.
double widthAt(const Handle(Geom_Surface) & surface, const Ranges& ranges, double v)
{
    double width = 0;
    const gp_Pnt begin = surface->Value(ranges.u0, v);
    for (int i = 1; i < samples; ++i)
        width = std::max(width, begin.Distance(surface->Value(ranges.u0 + (ranges.u1 - ranges.u0) * i / samples, v)));
    return width;
}

/// The next v from one on, in a direction, at which the surface shrinks to a point.
std::optional<double> poleFrom(const Handle(Geom_Surface) & surface, const Ranges& ranges, double v, double direction)
{
    constexpr int steps = 64;
    const double reach =
        surface->IsVPeriodic() ? ranges.v1 - ranges.v0 : std::abs((direction > 0 ? ranges.v1 : ranges.v0) - v);
    const double step = direction * reach / steps;
    double largest = widthAt(surface, ranges, v);
    for (int i = 1; i <= steps; ++i) {
        const double here = v + i * step;
        const double width = widthAt(surface, ranges, here);
        largest = std::max(largest, width);
        if (i == steps && !surface->IsVPeriodic())
            return width < smallShare * largest ? std::optional(here) : std::nullopt;
        const double next = widthAt(surface, ranges, here + step);
        if (width > next || width > widthAt(surface, ranges, here - step))
            continue;
        double low = here - step; // the least width is between these
        double high = here + step;
        for (int halving = 0; halving < 100; ++halving) {
            const double a = low + (high - low) / 3;
            const double b = high - (high - low) / 3;
            (widthAt(surface, ranges, a) < widthAt(surface, ranges, b) ? high : low) =
                widthAt(surface, ranges, a) < widthAt(surface, ranges, b) ? b : a;
        }
        if (widthAt(surface, ranges, 0.5 * (low + high)) < smallShare * largest)
            return 0.5 * (low + high);
    }
    return std::nullopt;
}

/// The same surface whose parameter u begins elsewhere. @param by which u grows less; a spline takes the next knot
/// @return null when there is none
Handle(Geom_Surface) turned(const Handle(Geom_Surface) & surface, double by)
{
    if (const auto ball = Handle(Geom_SphericalSurface)::DownCast(surface); !ball.IsNull()) {
        gp_Ax3 axes = ball->Position();
        axes.Rotate(axes.Axis(), axes.Direct() ? by : -by);
        return new Geom_SphericalSurface(axes, ball->Radius());
    }
    if (const auto turning = Handle(Geom_SurfaceOfRevolution)::DownCast(surface); !turning.IsNull()) {
        const auto section = Handle(Geom_Curve)::DownCast(turning->BasisCurve()->Rotated(turning->Axis(), by));
        return new Geom_SurfaceOfRevolution(section, turning->Axis());
    }
    if (const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface); !spline.IsNull()) {
        const auto copy = Handle(Geom_BSplineSurface)::DownCast(spline->Copy());
        const Ranges ranges = rangesOf(surface);
        copy->SetUPeriodic();
        copy->InsertUKnot(ranges.u0 + by, 1, smallShare * (ranges.u1 - ranges.u0));
        for (int i = copy->FirstUKnotIndex(); i <= copy->LastUKnotIndex(); ++i)
            if (std::abs(copy->UKnot(i) - ranges.u0 - by) < 2 * smallShare * (ranges.u1 - ranges.u0)) {
                copy->SetUOrigin(i);
                copy->SetUNotPeriodic();
                return Handle(Geom_Surface)(copy);
            }
    }
    return {};
}

/// An edge of a face, and where it lies in the parameters of the surface.
struct Border {
    TopoDS_Edge edge;
    Handle(Geom2d_Curve) line;
    double first = 0;
    double last = 0;
    double shift = 0; ///< of u, so that it begins where the one before ends

    gp_Pnt2d at(double share) const
    {
        const double along = edge.Orientation() == TopAbs_REVERSED ? 1 - share : share;
        const gp_Pnt2d place = line->Value(first + (last - first) * along);
        return {place.X() + shift, place.Y()};
    }
};

class OuterFace {
public:
    OuterFace(const TopoDS_Face& face, bool goesBack)
        : m_face(TopoDS::Face(face.Oriented(TopAbs_FORWARD)))
        , m_surface(BRep_Tool::Surface(m_face))
        , m_goesBack(goesBack)
    {
    }

    std::optional<TopoDS_Face> make()
    {
        if (const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(m_surface); !trimmed.IsNull())
            m_surface = trimmed->BasisSurface();
        if (m_surface.IsNull() || !m_surface->IsUClosed())
            return std::nullopt;
        const Ranges old = rangesOf(m_surface);
        const double period = old.u1 - old.u0;
        if (!takeBorder(period) || !isOuterMeant() || m_high - m_low > (1 - smallShare) * period)
            return std::nullopt;
        // The seam goes where it is farthest from the border.
        const double by = std::remainder(0.5 * (m_low + m_high) + 0.5 * period - old.u0, period);
        const Handle(Geom_Surface) other = turned(m_surface, by < 0 ? by + period : by);
        const std::optional<double> below = poleFrom(m_surface, old, m_middle, -1);
        const std::optional<double> above = poleFrom(m_surface, old, m_middle, 1);
        if (other.IsNull() || !below || !above)
            return std::nullopt;
        Ranges ranges = rangesOf(other);
        ranges.v0 = *below;
        ranges.v1 = *above;
        const double shift = 0.5 * (ranges.u0 + ranges.u1) - 0.5 * (m_low + m_high);
        return isInPlace(other, ranges, shift) ? std::optional(withHole(other, ranges, shift)) : std::nullopt;
    }

private:
    /// The edges that are neither seam nor pole, one after the other.
    /// @return whether they are one loop that does not reach around the surface
    bool takeBorder(double period)
    {
        std::vector<Border> left;
        for (TopExp_Explorer edges(m_face, TopAbs_EDGE); edges.More(); edges.Next()) {
            Border border{TopoDS::Edge(edges.Current()), {}, 0, 0, 0};
            if (BRep_Tool::Degenerated(border.edge) || BRep_Tool::IsClosed(border.edge, m_face))
                continue;
            border.line = BRep_Tool::CurveOnSurface(border.edge, m_face, border.first, border.last);
            if (border.line.IsNull())
                return false;
            left.push_back(border);
        }
        while (!left.empty()) {
            const auto isNext = [&](const Border& border) {
                return m_border.empty() ||
                       TopExp::FirstVertex(border.edge, true).IsSame(TopExp::LastVertex(m_border.back().edge, true));
            };
            const auto next = std::find_if(left.begin(), left.end(), isNext);
            if (next == left.end())
                return false;
            if (!m_border.empty())
                next->shift = period * std::round((m_border.back().at(1).X() - next->at(0).X()) / period);
            m_border.push_back(*next);
            left.erase(next);
        }
        return !m_border.empty() && std::abs(m_border.back().at(1).X() - m_border.front().at(0).X()) < 0.5 * period;
    }

    /// Whether the border has what is within it on its right.
    bool isOuterMeant()
    {
        double area = 0;
        double lowest = std::numeric_limits<double>::infinity();
        double highest = -lowest;
        gp_Pnt2d last = m_border.back().at(1);
        for (const Border& border : m_border)
            for (int i = 0; i <= samples; ++i) {
                const gp_Pnt2d place = border.at(static_cast<double>(i) / samples);
                area += 0.5 * (last.X() * place.Y() - place.X() * last.Y());
                m_low = std::min(m_low, place.X());
                m_high = std::max(m_high, place.X());
                lowest = std::min(lowest, place.Y());
                highest = std::max(highest, place.Y());
                last = place;
            }
        m_middle = 0.5 * (lowest + highest);
        return (area < 0) != m_goesBack;
    }

    /// Whether the border is where it was when it is shifted.
    bool isInPlace(const Handle(Geom_Surface) & other, const Ranges& ranges, double shift) const
    {
        const double size = widthAt(other, ranges, m_middle);
        return std::all_of(m_border.begin(), m_border.end(), [&](const Border& border) {
            const gp_Pnt2d place = border.at(0.5);
            const gp_Pnt before = m_surface->Value(place.X() - border.shift, place.Y());
            return before.Distance(other->Value(place.X() + shift, place.Y())) <
                   1e-5 * size + BRep_Tool::Tolerance(border.edge);
        });
    }

    TopoDS_Face withHole(const Handle(Geom_Surface) & surface, const Ranges& ranges, double shift) const
    {
        const BRep_Builder builder;
        TopoDS_Wire hole;
        builder.MakeWire(hole);
        for (const Border& border : m_border) {
            const Handle(Geom2d_Curve) line = Handle(Geom2d_Curve)::DownCast(border.line->Copy());
            line->Translate(gp_Vec2d(shift + border.shift, 0));
            builder.UpdateEdge(border.edge, line, surface, TopLoc_Location(), BRep_Tool::Tolerance(border.edge));
            builder.Range(border.edge, surface, TopLoc_Location(), border.first, border.last);
            builder.Add(hole, border.edge);
        }
        hole.Closed(true);
        TopoDS_Face all =
            BRepBuilderAPI_MakeFace(surface, ranges.u0, ranges.u1, ranges.v0, ranges.v1, BRep_Tool::Tolerance(m_face))
                .Face();
        builder.Add(all, m_goesBack ? hole.Reversed() : hole);
        builder.NaturalRestriction(all, false);
        return all;
    }

    TopoDS_Face m_face;
    Handle(Geom_Surface) m_surface;
    bool m_goesBack;
    std::vector<Border> m_border;
    double m_low = std::numeric_limits<double>::infinity(); // u of the border
    double m_high = -std::numeric_limits<double>::infinity();
    double m_middle = 0; // v of the border
};

} // namespace

std::optional<TopoDS_Face> outerFace(const TopoDS_Face& face, bool goesBack)
{
    std::optional<TopoDS_Face> outer = OuterFace(face, goesBack).make();
    if (outer && (face.Orientation() == TopAbs_REVERSED) != goesBack)
        outer->Reverse();
    return outer;
}

} // namespace knead
