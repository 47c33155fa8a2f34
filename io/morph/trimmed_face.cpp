#include "io/morph/trimmed_face.h"

#include "core/message/message.h"
#include "io/morph/millimetre_map.h"
#include "io/morph/wire_periods.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <GeomLib.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>

#include <algorithm>
#include <cmath>
#include <span>

namespace knead {

namespace {

constexpr double samePart = 1e-6; // of a range: parameters so close are the same

int samplesOf(const Handle(Geom2d_Curve) & curve, double first, double last)
{
    const Geom2dAdaptor_Curve adaptor(curve, first, last);
    if (adaptor.GetType() == GeomAbs_Line)
        return 1;
    return adaptor.GetType() == GeomAbs_BSplineCurve ? std::max(40, 4 * adaptor.NbKnots() * adaptor.Degree()) : 40;
}

/// How often an edge occurs in a face, forward and reversed.
struct Occurrences {
    int forward = 0;
    int reversed = 0;
};

Occurrences occurrencesOf(const TopoDS_Edge& edge, const TopoDS_Face& face)
{
    Occurrences count;
    for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next())
        if (edges.Current().IsSame(edge))
            ++(edges.Current().Orientation() == TopAbs_REVERSED ? count.reversed : count.forward);
    return count;
}

Handle(Geom2d_Curve) curveOn(const TopoDS_Face& face, const TopoDS_Edge& edge, double& first, double& last)
{
    Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
    if (curve.IsNull())
        throw Problem(Message("Export", "an edge has no curve on its face"));
    return curve;
}

/// Brings the curves to the range of the edge's curve in space; both were made for each other.
void takeRangeInSpace(FaceEdge& edge)
{
    if (BRep_Tool::Degenerated(edge.edge))
        return;
    double first = 0;
    double last = 0;
    if (BRep_Tool::Curve(edge.edge, first, last).IsNull())
        return;
    const double same = 1e-9 * std::max({1.0, std::abs(first), std::abs(last)});
    if (std::abs(first - edge.first) <= same && std::abs(last - edge.last) <= same)
        return;
    for (Handle(Geom2d_Curve) & curve : edge.curves) {
        if (curve.IsNull())
            continue;
        Handle(Geom2d_Curve) ranged;
        try {
            GeomLib::SameRange(1e-9, curve, edge.first, edge.last, first, last, ranged);
        } catch (const Standard_Failure&) {
            throw Problem(Message("Export", "an edge has a curve on its face that does not match it"));
        }
        if (!ranged.IsNull())
            curve = ranged;
    }
    edge.first = first;
    edge.last = last;
}

} // namespace

struct TrimmedFace::WireBox {
    Vec2 low = Vec2::Constant(1e100);
    Vec2 high = Vec2::Constant(-1e100);
    std::size_t firstEdge = 0;
    std::size_t lastEdge = 0;

    double area() const { return (high - low).prod(); }
};

std::vector<Handle(Geom2d_Curve)> FaceEdge::shifted() const
{
    std::vector<Handle(Geom2d_Curve)> result;
    for (const Handle(Geom2d_Curve) & curve : curves)
        if (!curve.IsNull())
            result.push_back(shift.Magnitude() > 0 ? Handle(Geom2d_Curve)::DownCast(curve->Translated(shift)) : curve);
    return result;
}

TrimmedFace::TrimmedFace(const TopoDS_Face& face)
    : m_face(face)
{
    TopLoc_Location location;
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(face, location);
    if (surface.IsNull())
        throw Problem(Message("Export", "a face has no surface"));
    m_surface.Load(surface);
    m_location = location.Transformation();
    std::vector<WireBox> wires;
    for (TopoDS_Iterator wire(face); wire.More(); wire.Next())
        if (wire.Value().ShapeType() == TopAbs_WIRE)
            addWire(wire.Value(), wires.emplace_back());
    if (m_edges.empty()) {
        surface->Bounds(m_low[0], m_high[0], m_low[1], m_high[1]);
        for (const double bound : {m_low[0], m_high[0], m_low[1], m_high[1]})
            if (Precision::IsInfinite(bound))
                throw Problem(Message("Export", "a face has no border"));
        return;
    }
    bringTogether(wires);
    snapToBounds();
    if (!(m_high[0] > m_low[0] && m_high[1] > m_low[1]))
        throw Problem(Message("Export", "a face is degenerate"));
}

void TrimmedFace::addWire(const TopoDS_Shape& wire, WireBox& box)
{
    box.firstEdge = m_edges.size();
    for (TopoDS_Iterator child(wire); child.More(); child.Next()) {
        const TopoDS_Edge edge = TopoDS::Edge(child.Value().Oriented(TopAbs_FORWARD));
        if (std::any_of(m_edges.begin(), m_edges.end(), [&](const FaceEdge& e) { return e.edge.IsSame(edge); }))
            continue;
        FaceEdge found;
        found.edge = edge;
        const Occurrences count = occurrencesOf(edge, m_face);
        const bool isClosed = BRep_Tool::IsClosed(edge, m_face);
        // The sides of a seam may belong to two faces that share a surface; then each has one of the two curves.
        const bool isSeam = isClosed && count.forward + count.reversed > 1;
        const bool otherSide = isClosed && !isSeam && count.reversed == 1;
        found.curves[0] = curveOn(m_face, otherSide ? TopoDS::Edge(edge.Reversed()) : edge, found.first, found.last);
        if (isSeam) {
            double first = 0;
            double last = 0;
            found.curves[1] = curveOn(m_face, TopoDS::Edge(edge.Reversed()), first, last);
        }
        takeRangeInSpace(found);
        m_edges.push_back(found);
    }
    box.lastEdge = m_edges.size();
    const std::span<FaceEdge> edges = std::span(m_edges).subspan(box.firstEdge);
    bringIntoOnePeriod(edges, period());
    for (const FaceEdge& edge : edges)
        for (const Handle(Geom2d_Curve) & curve : edge.shifted()) {
            const int samples = samplesOf(curve, edge.first, edge.last);
            for (int i = 0; i <= samples; ++i) {
                const gp_Pnt2d at = curve->Value(edge.first + (edge.last - edge.first) * i / samples);
                box.low = box.low.cwiseMin(Vec2(at.X(), at.Y()));
                box.high = box.high.cwiseMax(Vec2(at.X(), at.Y()));
            }
        }
    m_low = m_low.cwiseMin(box.low);
    m_high = m_high.cwiseMax(box.high);
}

/// Of the surface, along u and v; 0 where it has none.
Vec2 TrimmedFace::period() const
{
    const Handle(Geom_Surface)& surface = m_surface.Surface();
    return {surface->IsUPeriodic() ? surface->UPeriod() : 0, surface->IsVPeriodic() ? surface->VPeriod() : 0};
}

/// Shifts wires that lie a period away into the box of the largest one.
void TrimmedFace::bringTogether(std::vector<WireBox>& wires)
{
    const Vec2 period = this->period();
    const auto isTooWide = [&](Eigen::Index axis) {
        return period[axis] > 0 && m_high[axis] - m_low[axis] > period[axis] * (1 + samePart);
    };
    if (!isTooWide(0) && !isTooWide(1))
        return;
    const auto largest = std::max_element(wires.begin(), wires.end(),
                                          [](const WireBox& a, const WireBox& b) { return a.area() < b.area(); });
    m_low = largest->low;
    m_high = largest->high;
    for (const WireBox& wire : wires) {
        if (&wire == &*largest)
            continue;
        Vec2 shift = Vec2::Zero();
        for (Eigen::Index axis = 0; axis < 2; ++axis) {
            if (period[axis] == 0)
                continue;
            const bool goesAround = largest->high[axis] - largest->low[axis] > 0.9 * period[axis];
            const double begin = goesAround ? largest->low[axis] : largest->high[axis] - period[axis];
            const double middle = 0.5 * (wire.low[axis] + wire.high[axis]);
            shift[axis] = -period[axis] * std::floor((middle - begin) / period[axis]);
        }
        for (std::size_t edge = wire.firstEdge; edge < wire.lastEdge; ++edge)
            m_edges[edge].shift += gp_Vec2d(shift[0], shift[1]);
        m_low = m_low.cwiseMin(wire.low + shift);
        m_high = m_high.cwiseMax(wire.high + shift);
    }
}

/// What misses a natural bound of the surface, or a whole period, by rounding only is meant to meet it.
void TrimmedFace::snapToBounds()
{
    const Handle(Geom_Surface)& surface = m_surface.Surface();
    Vec2 low;
    Vec2 high;
    surface->Bounds(low[0], high[0], low[1], high[1]);
    const Vec2 period = this->period();
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
        const double same = samePart * (m_high[axis] - m_low[axis]);
        if (period[axis] > 0) {
            if (std::abs(m_high[axis] - m_low[axis] - period[axis]) < samePart * period[axis])
                m_high[axis] = m_low[axis] + period[axis];
            continue;
        }
        if (m_low[axis] > low[axis] - 10 * same && m_low[axis] < low[axis] + same)
            m_low[axis] = low[axis];
        if (m_high[axis] < high[axis] + 10 * same && m_high[axis] > high[axis] - same)
            m_high[axis] = high[axis];
    }
}

Vec3 TrimmedFace::at(const Vec2& parameters) const
{
    gp_Pnt place = m_surface.Value(parameters[0], parameters[1]);
    place.Transform(m_location);
    return toVec3(place.XYZ());
}

Vec2 TrimmedFace::lengths() const
{
    constexpr int lines = 5;
    constexpr int pieces = 12;
    Vec2 longest = Vec2::Zero();
    for (Eigen::Index axis = 0; axis < 2; ++axis)
        for (int line = 0; line < lines; ++line) {
            const auto point = [&](int piece) {
                Vec2 share = Vec2::Constant(static_cast<double>(line) / (lines - 1));
                share[axis] = static_cast<double>(piece) / pieces;
                return at(m_low + share.cwiseProduct(m_high - m_low));
            };
            double length = 0;
            for (int piece = 0; piece < pieces; ++piece)
                length += (point(piece + 1) - point(piece)).norm();
            longest[axis] = std::max(longest[axis], length);
        }
    return longest;
}

std::vector<Vec2> TrimmedFace::borderSamples(int perEdge) const
{
    std::vector<Vec2> samples;
    for (const FaceEdge& edge : m_edges)
        for (const Handle(Geom2d_Curve) & curve : edge.shifted())
            for (int i = 0; i <= perEdge; ++i) {
                const gp_Pnt2d at = curve->Value(edge.first + (edge.last - edge.first) * i / perEdge);
                samples.emplace_back(at.X(), at.Y());
            }
    return samples;
}

std::vector<Vec3> placesOnEdges(const TopoDS_Shape& face)
{
    constexpr int perEdge = 8;
    std::vector<Vec3> places;
    for (TopExp_Explorer edge(face, TopAbs_EDGE); edge.More(); edge.Next()) {
        if (BRep_Tool::Degenerated(TopoDS::Edge(edge.Current())))
            continue;
        const BRepAdaptor_Curve curve(TopoDS::Edge(edge.Current()));
        for (int i = 0; i <= perEdge; ++i)
            places.push_back(toVec3(
                curve.Value(curve.FirstParameter() + (curve.LastParameter() - curve.FirstParameter()) * i / perEdge)
                    .XYZ()));
    }
    return places;
}

} // namespace knead
