#include "io/brep/face_integral.h"

#include "core/task/parallel.h"
#include "io/brep/parameter_range.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace knead {

namespace {

constexpr double emptyRange = 1e-14; // of the range of a parameter

/// By Green's theorem the integral of f over a face is that of F dv around it, where F(u, v) is the integral of f from the
/// lowest u to u.
class FaceIntegration {
public:
    FaceIntegration(const TopoDS_Face& face, const gp_Pnt& reference)
        : m_face(TopoDS::Face(face.Oriented(TopAbs_FORWARD)))
        , m_surface(m_face)
        , m_reference(reference)
        , m_sign(face.Orientation() == TopAbs_FORWARD    ? 1
                 : face.Orientation() == TopAbs_REVERSED ? -1
                                                         : 0)
    {
    }

    FaceIntegrals run()
    {
        for (const double bound : {m_surface.FirstUParameter(), m_surface.LastUParameter(), m_surface.FirstVParameter(),
                                   m_surface.LastVParameter()})
            if (Precision::IsInfinite(bound))
                return {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
        m_u = uRangeOf(m_surface);
        m_v = vRangeOf(m_surface);
        if (!(m_u.width() > 0) || !(m_v.width() > 0))
            return {};
        if (m_face.NbChildren() == 0)
            addSide();
        for (TopExp_Explorer edges(m_face, TopAbs_EDGE); edges.More(); edges.Next())
            if (const TopAbs_Orientation side = edges.Current().Orientation();
                side == TopAbs_FORWARD || side == TopAbs_REVERSED)
                addEdge(TopoDS::Edge(edges.Current()));
        integrateRows();
        return {std::abs(m_area), m_sign * m_volume / 3};
    }

private:
    /// From the lowest u to this one, at v.
    struct Row {
        double u;
        double v;
        double weight; // dv
    };

    /// A face without edges is all of its surface: only the side of the largest u counts.
    void addSide()
    {
        const GaussRule rule = gaussRule(m_v.order);
        for (std::size_t i = 0; i + 1 < m_v.knots.size(); ++i) {
            const double half = 0.5 * (m_v.knots[i + 1] - m_v.knots[i]);
            for (std::size_t g = 0; g < rule.points.size(); ++g)
                m_rows.push_back({m_u.last(), m_v.knots[i] + half * (1 + rule.points[g]), half * rule.weights[g]});
        }
    }

    void addEdge(const TopoDS_Edge& edge)
    {
        double first = 0;
        double last = 0;
        const Handle(Geom2d_Curve) line = BRep_Tool::CurveOnSurface(edge, m_face, first, last);
        if (line.IsNull() || !(last > first))
            return;
        const Geom2dAdaptor_Curve curve(line, first, last);
        const double direction = edge.Orientation() == TopAbs_REVERSED ? -1 : 1;
        const ParameterRange pieces = rangeOf(curve);
        const std::vector<double> cuts = cutsOf(curve, pieces);
        const bool isPlane = m_surface.GetType() == GeomAbs_Plane;
        const int order = isPlane ? pieces.order : std::max({pieces.order, m_u.order, m_v.order});
        const GaussRule rule = gaussRule(orderFor(cuts.size() - 1, order));
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
            addPiece(curve, cuts[i], cuts[i + 1], direction, rule);
    }

    void addPiece(const Geom2dAdaptor_Curve& curve, double from, double to, double direction, const GaussRule& rule)
    {
        const double half = 0.5 * (to - from);
        for (std::size_t g = 0; g < rule.points.size(); ++g) {
            gp_Pnt2d point;
            gp_Vec2d tangent;
            curve.D1(from + half * (1 + rule.points[g]), point, tangent);
            const double weight = direction * half * rule.weights[g] * tangent.Y();
            const double u = std::clamp(point.X(), m_u.first(), m_u.last());
            if (std::abs(weight) > emptyRange * m_v.width() && u - m_u.first() > emptyRange * m_u.width())
                m_rows.push_back({u, std::clamp(point.Y(), m_v.first(), m_v.last()), weight});
        }
    }

    /// Where the curve has knots, and where it crosses those of the surface.
    std::vector<double> cutsOf(const Geom2dAdaptor_Curve& curve, const ParameterRange& pieces) const
    {
        std::vector<double> cuts = pieces.knots;
        if (m_surface.GetType() == GeomAbs_Plane)
            return cuts;
        for (std::size_t i = 0; i < pieces.pieces(); ++i) {
            addCrossings(curve, pieces.knots[i], pieces.knots[i + 1], &gp_Pnt2d::Y, m_v.knots, cuts);
            if (m_u.pieces() <= fewPieces)
                addCrossings(curve, pieces.knots[i], pieces.knots[i + 1], &gp_Pnt2d::X, m_u.knots, cuts);
        }
        std::sort(cuts.begin(), cuts.end());
        const double narrowest = narrowestPiece * (cuts.back() - cuts.front());
        cuts.erase(std::unique(cuts.begin(), cuts.end(), [&](double a, double b) { return b - a < narrowest; }),
                   cuts.end());
        return cuts;
    }

    /// Where a coordinate of a curve, which rises or falls between two parameters, is that of a knot.
    void addCrossings(const Geom2dAdaptor_Curve& curve, double from, double to, double (gp_Pnt2d::*coordinate)() const,
                      const std::vector<double>& knots, std::vector<double>& cuts) const
    {
        const auto at = [&](double parameter) { return (curve.Value(parameter).*coordinate)(); };
        const double begin = at(from);
        const double end = at(to);
        const auto [low, high] = std::minmax(begin, end);
        const double margin = narrowestPiece * (knots.back() - knots.front());
        for (auto knot = std::upper_bound(knots.begin(), knots.end(), low + margin);
             knot != knots.end() && *knot < high - margin; ++knot) {
            double below = begin < end ? from : to;
            double above = begin < end ? to : from;
            for (int step = 0; step < 40; ++step) {
                const double middle = 0.5 * (below + above);
                (at(middle) < *knot ? below : above) = middle;
            }
            cuts.push_back(0.5 * (below + above));
        }
    }

    /// Knot by knot, since a spline is quick to evaluate many times between the same ones.
    void integrateRows()
    {
        const GaussRule rule = gaussRule(m_u.order);
        for (std::size_t i = 0; i + 1 < m_u.knots.size(); ++i) {
            const double from = m_u.knots[i];
            for (const Row& row : m_rows) {
                const double to = std::min(row.u, m_u.knots[i + 1]);
                if (!(to > from))
                    continue;
                const double half = 0.5 * (to - from);
                for (std::size_t g = 0; g < rule.points.size(); ++g)
                    add(from + half * (1 + rule.points[g]), row.v, row.weight * half * rule.weights[g]);
            }
        }
    }

    void add(double u, double v, double weight)
    {
        gp_Pnt point;
        gp_Vec alongU;
        gp_Vec alongV;
        m_surface.D1(u, v, point, alongU, alongV);
        const gp_Vec normal = alongU.Crossed(alongV);
        m_area += weight * normal.Magnitude();
        m_volume += weight * gp_Vec(m_reference, point).Dot(normal);
    }

    TopoDS_Face m_face;
    BRepAdaptor_Surface m_surface;
    gp_Pnt m_reference;
    double m_sign;
    ParameterRange m_u;
    ParameterRange m_v;
    std::vector<Row> m_rows;
    double m_area = 0;
    double m_volume = 0;
};

/// The nearer, the smaller the numbers that cancel.
gp_Pnt middleOfVertices(const TopoDS_Shape& shape)
{
    gp_XYZ sum(0, 0, 0);
    int count = 0;
    for (TopExp_Explorer vertices(shape, TopAbs_VERTEX); vertices.More(); vertices.Next(), ++count)
        sum += BRep_Tool::Pnt(TopoDS::Vertex(vertices.Current())).XYZ();
    return count == 0 ? gp_Pnt() : gp_Pnt(sum / count);
}

} // namespace

FaceIntegrals faceIntegralsOf(const TopoDS_Shape& shape)
{
    std::vector<TopoDS_Face> faces;
    for (TopExp_Explorer found(shape, TopAbs_FACE); found.More(); found.Next())
        if (const TopoDS_Face& face = TopoDS::Face(found.Current()); !BRep_Tool::Surface(face).IsNull())
            faces.push_back(face);
    const gp_Pnt reference = middleOfVertices(shape);
    std::vector<FaceIntegrals> ofFaces(faces.size());
    forEachBlock(faces.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            ofFaces[i] = FaceIntegration(faces[i], reference).run();
    });
    FaceIntegrals sum;
    for (const FaceIntegrals& one : ofFaces) {
        sum.area += one.area;
        sum.volume += one.volume;
    }
    return sum;
}

} // namespace knead
