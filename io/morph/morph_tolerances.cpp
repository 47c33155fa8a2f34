#include "io/morph/morph_tolerances.h"

#include "core/task/parallel.h"

#include <BRepCheck_Analyzer.hxx>
#include <BRepCheck_Wire.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListIteratorOfListOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Vertex.hxx>

#include <algorithm>
#include <vector>

namespace knead {

namespace {

constexpr double leastTolerance = 1e-7; // [mm], what modelers call exact
constexpr double edgeMargin = 1.15;     // the largest miss lies between the places looked at
constexpr double vertexMargin = 1.3;
constexpr double rounding = 1e-9; // [mm]
constexpr int leastLooksAlong = 120;
constexpr int mostLooksAlong = 2000;
constexpr int mostRounds = 10;

/// What an edge and the vertices at its ends are off by [mm].
struct Misses {
    double edge = 0;
    double firstVertex = 0;
    double lastVertex = 0;
};

class EdgeMeasure {
public:
    EdgeMeasure(const TopoDS_Edge& edge, const TopTools_ListOfShape& faces)
        : m_edge(edge)
        , m_isDegenerated(BRep_Tool::Degenerated(edge))
        , m_firstVertex(TopExp::FirstVertex(edge))
        , m_lastVertex(TopExp::LastVertex(edge))
    {
        m_curve = BRep_Tool::Curve(edge, m_first, m_last);
        if (!m_curve.IsNull()) {
            note(m_misses.firstVertex, m_firstVertex, m_curve->Value(m_first));
            note(m_misses.lastVertex, m_lastVertex, m_curve->Value(m_last));
        }
        for (TopTools_ListIteratorOfListOfShape face(faces); face.More(); face.Next())
            lookAt(TopoDS::Face(face.Value().Oriented(TopAbs_FORWARD)));
    }

    const Misses& misses() const { return m_misses; }

private:
    static void note(double& miss, const TopoDS_Vertex& vertex, const gp_Pnt& place)
    {
        if (!vertex.IsNull())
            miss = std::max(miss, BRep_Tool::Pnt(vertex).Distance(place));
    }

    int looks(const Handle(Geom_Surface) & surface) const
    {
        if (m_isDegenerated)
            return 20;
        int count = leastLooksAlong;
        if (const auto spline = Handle(Geom_BSplineCurve)::DownCast(m_curve); !spline.IsNull())
            count = std::max(count, 8 * spline->NbKnots());
        if (const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface); !spline.IsNull())
            count = std::max(count, 4 * (spline->NbUKnots() + spline->NbVKnots()));
        return std::min(count, mostLooksAlong);
    }

    void lookAt(const TopoDS_Face& face)
    {
        const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
        const GeomAdaptor_Surface adaptor(surface);
        const bool isSeam = BRep_Tool::IsClosed(m_edge, face);
        const int count = looks(surface);
        for (int side = 0; side < (isSeam ? 2 : 1); ++side) {
            double first = 0;
            double last = 0;
            const Handle(Geom2d_Curve) curve =
                BRep_Tool::CurveOnSurface(side == 0 ? m_edge : TopoDS::Edge(m_edge.Reversed()), face, first, last);
            if (curve.IsNull())
                continue;
            for (int i = 0; i <= count; ++i) {
                const double share = static_cast<double>(i) / count;
                const gp_Pnt2d at = curve->Value(first + share * (last - first));
                const gp_Pnt place = adaptor.Value(at.X(), at.Y());
                if (m_isDegenerated)
                    note(m_misses.firstVertex, m_firstVertex, place);
                else if (!m_curve.IsNull())
                    m_misses.edge =
                        std::max(m_misses.edge, place.Distance(m_curve->Value(m_first + share * (m_last - m_first))));
                if (i == 0)
                    note(m_misses.firstVertex, m_firstVertex, place);
                if (i == count)
                    note(m_misses.lastVertex, m_lastVertex, place);
            }
        }
    }

    TopoDS_Edge m_edge;
    bool m_isDegenerated;
    TopoDS_Vertex m_firstVertex;
    TopoDS_Vertex m_lastVertex;
    Handle(Geom_Curve) m_curve;
    double m_first = 0;
    double m_last = 0;
    Misses m_misses;
};

/// Doubles the tolerance of a vertex if it may grow so far.
bool widen(const TopoDS_Shape& vertex, double most)
{
    const double wider = 2 * BRep_Tool::Tolerance(TopoDS::Vertex(vertex));
    if (wider > most)
        return false;
    const BRep_Builder builder;
    builder.UpdateVertex(TopoDS::Vertex(vertex), wider);
    return true;
}

/// Vertices that two edges of a wire share beside which they cross.
void findCrossings(const TopoDS_Face& face, TopTools_IndexedMapOfShape& vertices)
{
    for (TopoDS_Iterator wire(face); wire.More(); wire.Next()) {
        if (wire.Value().ShapeType() != TopAbs_WIRE)
            continue;
        BRepCheck_Wire check(TopoDS::Wire(wire.Value()));
        TopoDS_Edge first;
        TopoDS_Edge second;
        if (check.SelfIntersect(face, first, second, true) == BRepCheck_NoError || first.IsNull() || second.IsNull())
            continue;
        for (TopoDS_Iterator a(first); a.More(); a.Next())
            for (TopoDS_Iterator b(second); b.More(); b.Next())
                if (a.Value().IsSame(b.Value()))
                    vertices.Add(a.Value());
    }
}

/// Vertices at which two wires of a face touch.
void findTouchingWires(const TopoDS_Face& face, TopTools_IndexedMapOfShape& vertices)
{
    TopTools_MapOfShape seen;
    for (TopoDS_Iterator wire(face); wire.More(); wire.Next()) {
        TopTools_IndexedMapOfShape ofWire;
        TopExp::MapShapes(wire.Value(), TopAbs_VERTEX, ofWire);
        for (int i = 1; i <= ofWire.Extent(); ++i)
            if (seen.Contains(ofWire(i)))
                vertices.Add(ofWire(i));
        for (int i = 1; i <= ofWire.Extent(); ++i)
            seen.Add(ofWire(i));
    }
}

} // namespace

double raiseTolerances(const TopoDS_Shape& shape)
{
    TopTools_IndexedDataMapOfShapeListOfShape facesOfEdge;
    TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, facesOfEdge);
    std::vector<Misses> misses(static_cast<std::size_t>(facesOfEdge.Extent()));
    forEachBlock(misses.size(), 4, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const int index = static_cast<int>(i) + 1;
            const TopoDS_Edge edge = TopoDS::Edge(facesOfEdge.FindKey(index).Oriented(TopAbs_FORWARD));
            misses[i] = EdgeMeasure(edge, facesOfEdge(index)).misses();
        }
    });
    double largest = 0;
    const BRep_Builder builder;
    for (std::size_t i = 0; i < misses.size(); ++i) {
        const TopoDS_Edge edge = TopoDS::Edge(facesOfEdge.FindKey(static_cast<int>(i) + 1).Oriented(TopAbs_FORWARD));
        const double tolerance = std::max(leastTolerance, edgeMargin * misses[i].edge + rounding);
        builder.UpdateEdge(edge, tolerance); // keeps a larger one
        largest = std::max(largest, BRep_Tool::Tolerance(edge));
        const auto update = [&](const TopoDS_Vertex& vertex, double miss) {
            if (!vertex.IsNull())
                builder.UpdateVertex(vertex, std::max(tolerance, vertexMargin * miss + rounding));
        };
        update(TopExp::FirstVertex(edge), misses[i].firstVertex);
        update(TopExp::LastVertex(edge), misses[i].lastVertex);
    }
    return largest;
}

bool widenVertices(const TopoDS_Shape& shape, double most, int& widened)
{
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(shape, TopAbs_FACE, faces);
    for (int round = 0; round < mostRounds; ++round) {
        const BRepCheck_Analyzer check(shape, true, true);
        if (check.IsValid())
            return true;
        TopTools_IndexedMapOfShape crossings;
        TopTools_IndexedMapOfShape touching;
        for (int i = 1; i <= faces.Extent(); ++i)
            if (!check.IsValid(faces(i))) {
                findCrossings(TopoDS::Face(faces(i)), crossings);
                findTouchingWires(TopoDS::Face(faces(i)), touching);
            }
        int count = 0;
        for (const TopTools_IndexedMapOfShape* vertices : {&crossings, &touching}) {
            if (count > 0)
                break;
            for (int i = 1; i <= vertices->Extent(); ++i)
                count += widen((*vertices)(i), most) ? 1 : 0;
        }
        if (count == 0)
            return false;
        widened += count;
    }
    return BRepCheck_Analyzer(shape, true, true).IsValid();
}

} // namespace knead
