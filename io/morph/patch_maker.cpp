#include "io/morph/patch_maker.h"

#include "core/message/message.h"
#include "io/brep/face_redrawing.h"
#include "io/morph/trimmed_face.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_TangentialDeflection.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Wire.hxx>

#include <algorithm>

namespace knead {

namespace {

using Vec2 = Eigen::Vector2d;

constexpr double exactTolerance = 1e-7; // [mm]; what is needed is measured later
constexpr double edgeDeflection =
    0.1; // of that of triangles: pieces of edges are to be straighter than triangles are thin
constexpr double differences = 1e-4; // of the range of parameters, for derivatives
constexpr int piecesOfPole = 16;
constexpr double mostParts = 2000; // of a chord

/// Only what an edge needs of its curve, so that files do not hold the whole of it for each piece.
Handle(Geom_Curve) pieceOf(const Handle(Geom_Curve) & curve, double first, double last)
{
    const Handle(Geom_BSplineCurve) spline = Handle(Geom_BSplineCurve)::DownCast(curve);
    if (spline.IsNull() || spline->IsPeriodic())
        return curve;
    Handle(Geom_BSplineCurve) piece = Handle(Geom_BSplineCurve)::DownCast(spline->Copy());
    piece->Segment(first, last);
    return piece;
}

/// Whether some of its wires lie a period of the surface away from the others.
bool hasWiresApart(const TopoDS_Face& face)
{
    const TrimmedFace trimmed(face);
    return std::any_of(trimmed.edges().begin(), trimmed.edges().end(),
                       [](const FaceEdge& edge) { return edge.shift.Magnitude() > 0; });
}

gp_Pnt placeOf(const TopoDS_Vertex& vertex)
{
    return BRep_Tool::Pnt(vertex);
}

} // namespace

/// A face where the map takes it.
class PatchMaker::CarriedFace final : public SurfaceToDraw {
public:
    CarriedFace(const TopoDS_Face& face, const MillimetreMap& map, PatchMaker& maker)
        : m_map(map)
        , m_maker(maker)
        , m_face(face)
        , m_surface(face, false)
    {
        double uLow = 0;
        double uHigh = 0;
        double vLow = 0;
        double vHigh = 0;
        BRepTools::UVBounds(face, uLow, uHigh, vLow, vHigh);
        m_step = differences * Vec2(uHigh - uLow, vHigh - vLow);
    }

    gp_Pnt placeAt(const Vec2& parameters) const override { return toPoint(carried(parameters)); }

    gp_Vec normalAt(const Vec2& parameters) const override
    {
        const Vec3 normal = derivative(parameters, 0).cross(derivative(parameters, 1));
        return normal.norm() > 0 ? gp_Vec(normal.x(), normal.y(), normal.z()) : gp_Vec(0, 0, 1);
    }

    Vec2 metricAt(const Vec2& parameters) const override
    {
        return {derivative(parameters, 0).norm(), derivative(parameters, 1).norm()};
    }

    EdgePoints pointsOf(const TopoDS_Edge& edge) override
    {
        if (!BRep_Tool::Degenerated(edge))
            return m_maker.divisionOf(edge).points;
        double first = 0;
        double last = 0;
        BRep_Tool::Range(edge, m_face, first, last);
        const gp_Pnt place = placeOf(m_maker.divisionOf(edge).vertices.front());
        EdgePoints points;
        for (int i = 0; i <= piecesOfPole; ++i) {
            points.parameters.push_back(first + (last - first) * i / piecesOfPole);
            points.points.push_back(place);
        }
        return points;
    }

private:
    Vec3 carried(const Vec2& parameters) const
    {
        return m_map.at(toVec3(m_surface.Value(parameters.x(), parameters.y()).XYZ()));
    }

    Vec3 derivative(const Vec2& parameters, Eigen::Index axis) const
    {
        Vec2 before = parameters;
        Vec2 after = parameters;
        before[axis] -= m_step[axis];
        after[axis] += m_step[axis];
        return (carried(after) - carried(before)) / (2 * m_step[axis]);
    }

    const MillimetreMap& m_map;
    PatchMaker& m_maker;
    TopoDS_Face m_face;
    BRepAdaptor_Surface m_surface;
    Vec2 m_step;
};

PatchMaker::PatchMaker(const DrawingFineness& fineness, Surroundings surroundings)
    : m_fineness(fineness)
    , m_surroundings(std::move(surroundings))
{
}

std::vector<TopoDS_Face> PatchMaker::facesFor(const TopoDS_Face& face, const MillimetreMap& map)
try {
    const TopoDS_Face forward = TopoDS::Face(face.Oriented(TopAbs_FORWARD));
    if (!slitsOf(forward).IsEmpty() || hasWiresApart(forward))
        throw Problem(Message("Export", "its border cannot be drawn in its parameters"));
    CarriedFace carried(forward, map, *this);
    const auto drawn = drawFace(forward, carried, m_fineness);
    if (!drawn)
        throw Problem(Message("Export", "its border does not close in its parameters"));
    std::vector<TopoDS_Vertex> vertices(drawn->places.size());
    for (const DrawnFace::Run& run : drawn->runs) {
        const Division& division = divisionOf(run.edge);
        const bool isPole = BRep_Tool::Degenerated(run.edge);
        if (run.points.empty() || (!isPole && run.points.size() != division.vertices.size()))
            throw Problem(Message("Export", "its border is too short to be divided"));
        for (std::size_t i = 0; i < run.points.size(); ++i)
            vertices[run.points[i]] = isPole ? division.vertices.front() : division.vertices[i];
    }
    for (std::size_t i = 0; i < vertices.size(); ++i)
        if (vertices[i].IsNull())
            m_builder.MakeVertex(vertices[i], drawn->places[i], exactTolerance);
    std::vector<TopoDS_Face> faces;
    for (const auto& [a, b, c] : drawn->triangles) {
        if (vertices[a].IsSame(vertices[b]) || vertices[b].IsSame(vertices[c]) || vertices[c].IsSame(vertices[a]))
            continue; // at a pole
        faces.push_back(face.Orientation() == TopAbs_REVERSED ? triangle(vertices[a], vertices[c], vertices[b])
                                                              : triangle(vertices[a], vertices[b], vertices[c]));
    }
    return faces;
} catch (const Standard_Failure& failure) {
    throw Problem(Message("Export", "a face cannot be drawn: %1").with(failure.GetMessageString()));
}

const PatchMaker::Division& PatchMaker::divisionOf(const TopoDS_Edge& edge)
{
    Division& division = m_divisions[m_surroundings.numberOf(edge)];
    if (division.vertices.empty())
        division = divide(TopoDS::Edge(edge.Oriented(TopAbs_FORWARD)));
    return division;
}

PatchMaker::Division PatchMaker::divide(const TopoDS_Edge& edge)
{
    const TopoDS_Edge image = m_surroundings.imageOf(edge);
    const TopoDS_Vertex first = TopExp::FirstVertex(image);
    const TopoDS_Vertex last = TopExp::LastVertex(image);
    if (first.IsNull() || last.IsNull())
        throw Problem(Message("Export", "an edge does not end"));
    Division division;
    if (BRep_Tool::Degenerated(edge)) {
        division.vertices = {first, last};
        return division;
    }
    const BRepAdaptor_Curve curve(image);
    const GCPnts_TangentialDeflection chords(curve, m_fineness.angle, edgeDeflection * m_fineness.deflection, 2);
    std::vector<double>& parameters = division.points.parameters;
    for (int i = 1; i < chords.NbPoints(); ++i) {
        const double begin = chords.Parameter(i);
        const double end = chords.Parameter(i + 1);
        const double length = chords.Value(i).Distance(chords.Value(i + 1));
        const int parts = 1 + static_cast<int>(std::min(length / m_fineness.longestSide, mostParts));
        for (int part = 0; part < parts; ++part)
            parameters.push_back(begin + (end - begin) * part / parts);
    }
    parameters.push_back(chords.Parameter(chords.NbPoints()));
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        TopoDS_Vertex vertex = i == 0 ? first : last;
        if (i > 0 && i + 1 < parameters.size())
            m_builder.MakeVertex(vertex, curve.Value(parameters[i]), exactTolerance);
        division.vertices.push_back(vertex);
        division.points.points.push_back(placeOf(vertex));
    }
    if (m_surroundings.isBesideSmooth(edge))
        cut(edge, image, division);
    return division;
}

void PatchMaker::cut(const TopoDS_Edge& edge, const TopoDS_Edge& image, const Division& division)
{
    double first = 0;
    double last = 0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(image, first, last);
    std::vector<TopoDS_Edge>& pieces = m_pieces[m_surroundings.numberOf(edge)];
    for (std::size_t i = 0; i + 1 < division.vertices.size(); ++i) {
        const double begin = division.points.parameters[i];
        const double end = division.points.parameters[i + 1];
        TopoDS_Edge piece = TopoDS::Edge(image.EmptyCopied());
        m_builder.UpdateEdge(piece, pieceOf(curve, begin, end), BRep_Tool::Tolerance(image));
        m_builder.Add(piece, division.vertices[i].Oriented(TopAbs_FORWARD));
        m_builder.Add(piece, division.vertices[i + 1].Oriented(TopAbs_REVERSED));
        m_builder.Range(piece, begin, end);
        piece.Closed(false);
        pieces.push_back(piece);
        const Ends ends(vertexNumber(division.vertices[i]), vertexNumber(division.vertices[i + 1]));
        if (m_edges.contains(ends) || m_edges.contains({ends.second, ends.first}))
            throw Problem(Message("Export", "two of its edges are too short to be told apart"));
        m_edges[ends] = piece;
    }
}

std::size_t PatchMaker::vertexNumber(const TopoDS_Vertex& vertex)
{
    return m_numbers.try_emplace(vertex.TShape().get(), m_numbers.size()).first->second;
}

TopoDS_Edge PatchMaker::edgeBetween(const TopoDS_Vertex& from, const TopoDS_Vertex& to)
{
    const Ends ends(vertexNumber(from), vertexNumber(to));
    if (const auto found = m_edges.find({ends.second, ends.first}); found != m_edges.end())
        return TopoDS::Edge(found->second.Oriented(TopAbs_REVERSED));
    TopoDS_Edge& edge = m_edges[ends];
    if (edge.IsNull()) {
        const gp_Vec along(placeOf(from), placeOf(to));
        if (along.Magnitude() <= exactTolerance)
            throw Problem(Message("Export", "two of its points lie on each other"));
        m_builder.MakeEdge(edge, new Geom_Line(placeOf(from), gp_Dir(along)), exactTolerance);
        m_builder.Add(edge, from.Oriented(TopAbs_FORWARD));
        m_builder.Add(edge, to.Oriented(TopAbs_REVERSED));
        m_builder.Range(edge, 0, along.Magnitude());
    }
    return edge;
}

TopoDS_Face PatchMaker::triangle(const TopoDS_Vertex& a, const TopoDS_Vertex& b, const TopoDS_Vertex& c)
{
    const gp_Vec normal = gp_Vec(placeOf(a), placeOf(b)).Crossed(gp_Vec(placeOf(a), placeOf(c)));
    if (normal.Magnitude() <= exactTolerance * exactTolerance)
        throw Problem(Message("Export", "a triangle in its place has no width"));
    TopoDS_Wire wire;
    m_builder.MakeWire(wire);
    m_builder.Add(wire, edgeBetween(a, b));
    m_builder.Add(wire, edgeBetween(b, c));
    m_builder.Add(wire, edgeBetween(c, a));
    wire.Closed(true);
    TopoDS_Face face;
    m_builder.MakeFace(face, new Geom_Plane(placeOf(a), gp_Dir(normal)), exactTolerance);
    m_builder.Add(face, wire);
    return face;
}

} // namespace knead
