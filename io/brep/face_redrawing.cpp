#include "io/brep/face_redrawing.h"

#include "io/brep/face_drawing.h"
#include "io/brep/millimeter.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_TangentialDeflection.hxx>
#include <Geom2d_Curve.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace knead {

namespace {

constexpr double coarsestPole = 8; // pieces of an edge without length, where no angle says more

/// A face where it lies, between the points of its neighbors.
class FaceInPlace final : public SurfaceToDraw {
public:
    FaceInPlace(const TopoDS_Face& face, const TopTools_IndexedDataMapOfShapeListOfShape& facesOfEdges,
                const std::set<const void*>& badFaces, const DrawingFineness& fineness)
        : m_face(TopoDS::Face(face.Oriented(TopAbs_FORWARD)))
        , m_facesOfEdges(facesOfEdges)
        , m_badFaces(badFaces)
        , m_fineness(fineness)
        , m_surface(m_face, false)
    {
    }

    gp_Pnt placeAt(const Eigen::Vector2d& parameters) const override
    {
        return m_surface.Value(parameters.x(), parameters.y());
    }

    gp_Vec normalAt(const Eigen::Vector2d& parameters) const override
    {
        const auto [alongU, alongV] = derivativesAt(parameters);
        const gp_Vec normal = alongU.Crossed(alongV);
        return normal.Magnitude() > 0 ? normal : gp_Vec(0, 0, 1);
    }

    Eigen::Vector2d metricAt(const Eigen::Vector2d& parameters) const override
    {
        const auto [alongU, alongV] = derivativesAt(parameters);
        return {alongU.Magnitude(), alongV.Magnitude()};
    }

    /// Those of the neighbor, or else of our own.
    EdgePoints pointsOf(const TopoDS_Edge& edge) override
    {
        EdgePoints& known = m_pointsOfEdge[edge.TShape().get()];
        if (known.points.empty())
            if (const auto ofNeighbor = pointsOfNeighbor(edge))
                known = *ofNeighbor;
        if (known.points.empty())
            known = BRep_Tool::Degenerated(edge) ? pointsOfPole(edge) : ownPoints(edge);
        return known;
    }

private:
    std::optional<EdgePoints> pointsOfNeighbor(const TopoDS_Edge& edge) const
    {
        const int index = m_facesOfEdges.FindIndex(edge);
        if (index == 0 || BRep_Tool::Degenerated(edge))
            return std::nullopt;
        for (const TopoDS_Shape& other : m_facesOfEdges(index)) {
            const TopoDS_Face& neighbor = TopoDS::Face(other);
            if (neighbor.IsSame(m_face) || m_badFaces.contains(neighbor.TShape().get()))
                continue;
            const Handle(Poly_PolygonOnTriangulation) polygon = polygonOf(edge, neighbor);
            if (polygon.IsNull() || !polygon->HasParameters() || polygon->NbNodes() < 2)
                continue;
            TopLoc_Location location;
            const Handle(Poly_Triangulation)& triangulation = BRep_Tool::Triangulation(neighbor, location);
            EdgePoints points;
            for (int i = 1; i <= polygon->NbNodes(); ++i) {
                points.parameters.push_back(polygon->Parameter(i));
                points.points.push_back(triangulation->Node(polygon->Node(i)).Transformed(location.Transformation()));
            }
            return points;
        }
        return std::nullopt;
    }

    EdgePoints ownPoints(const TopoDS_Edge& edge) const
    {
        const BRepAdaptor_Curve curve(edge);
        const GCPnts_TangentialDeflection division(curve, m_fineness.angle, m_fineness.deflection, 2);
        EdgePoints points;
        for (int i = 1; i <= division.NbPoints(); ++i) {
            points.parameters.push_back(division.Parameter(i));
            points.points.push_back(division.Value(i));
        }
        return points;
    }

    /// An edge without length: a pole or an apex.
    EdgePoints pointsOfPole(const TopoDS_Edge& edge) const
    {
        double first = 0;
        double last = 0;
        const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, m_face, first, last);
        if (curve.IsNull())
            throw Standard_Failure("an edge without a curve in the parameters");
        const gp_Pnt2d start = curve->Value(first);
        const bool isRound = m_surface.IsUPeriodic();
        const double pieces = isRound ? std::abs(curve->Value(last).X() - start.X()) / m_fineness.angle : coarsestPole;
        const auto count = static_cast<int>(std::clamp(std::ceil(pieces), 1.0, 100.0));
        const gp_Pnt place = m_surface.Value(start.X(), start.Y());
        EdgePoints points;
        for (int i = 0; i <= count; ++i) {
            points.parameters.push_back(first + (last - first) * i / count);
            points.points.push_back(place);
        }
        return points;
    }

    std::pair<gp_Vec, gp_Vec> derivativesAt(const Eigen::Vector2d& parameters) const
    {
        gp_Pnt place;
        gp_Vec alongU;
        gp_Vec alongV;
        m_surface.D1(parameters.x(), parameters.y(), place, alongU, alongV);
        return {alongU, alongV};
    }

    TopoDS_Face m_face;
    const TopTools_IndexedDataMapOfShapeListOfShape& m_facesOfEdges;
    const std::set<const void*>& m_badFaces;
    DrawingFineness m_fineness;
    BRepAdaptor_Surface m_surface;
    std::map<const void*, EdgePoints> m_pointsOfEdge;
};

/// Writes the points of the border to the edges.
void storeEdges(const DrawnFace& drawn, const Handle(Poly_Triangulation) & triangulation,
                const TopLoc_Location& location)
{
    std::map<const void*, std::vector<std::pair<bool, Handle(Poly_PolygonOnTriangulation)>>> polygons;
    for (const DrawnFace::Run& run : drawn.runs) {
        if (run.points.empty())
            continue;
        const auto count = static_cast<int>(run.points.size());
        TColStd_Array1OfInteger nodes(1, count);
        TColStd_Array1OfReal parameters(1, count);
        for (int k = 0; k < count; ++k) {
            nodes.SetValue(k + 1, static_cast<int>(run.points[static_cast<std::size_t>(k)]) + 1);
            parameters.SetValue(k + 1, run.parameters[static_cast<std::size_t>(k)]);
        }
        Handle(Poly_PolygonOnTriangulation) polygon = new Poly_PolygonOnTriangulation(nodes, parameters);
        polygon->Deflection(triangulation->Deflection());
        polygons[run.edge.TShape().get()].emplace_back(run.edge.Orientation() == TopAbs_REVERSED, polygon);
    }
    for (const DrawnFace::Run& run : drawn.runs) {
        const auto& ofEdge = polygons[run.edge.TShape().get()];
        if (ofEdge.size() == 1)
            BRep_Builder().UpdateEdge(run.edge, ofEdge.front().second, triangulation, location);
        else if (ofEdge.size() == 2) {
            const std::size_t forward = ofEdge.front().first ? 1 : 0;
            BRep_Builder().UpdateEdge(TopoDS::Edge(run.edge.Oriented(TopAbs_FORWARD)), ofEdge[forward].second,
                                      ofEdge[1 - forward].second, triangulation, location);
        }
    }
}

/// Writes the triangles to the face and the points of the border to its edges.
void store(const TopoDS_Face& face, const DrawnFace& drawn, double deflection)
{
    const TopLoc_Location& location = face.Location();
    const gp_Trsf back = location.Transformation().Inverted();
    const Handle(Poly_Triangulation) triangulation =
        new Poly_Triangulation(static_cast<int>(drawn.places.size()), static_cast<int>(drawn.triangles.size()), true);
    for (std::size_t i = 0; i < drawn.places.size(); ++i) {
        triangulation->SetNode(static_cast<int>(i) + 1, drawn.places[i].Transformed(back));
        triangulation->SetUVNode(static_cast<int>(i) + 1, gp_Pnt2d(drawn.parameters[i].x(), drawn.parameters[i].y()));
    }
    for (std::size_t t = 0; t < drawn.triangles.size(); ++t) {
        const auto [a, b, c] = drawn.triangles[t];
        triangulation->SetTriangle(
            static_cast<int>(t) + 1,
            Poly_Triangle(static_cast<int>(a) + 1, static_cast<int>(b) + 1, static_cast<int>(c) + 1));
    }
    triangulation->Deflection(deflection);
    BRep_Builder().UpdateFace(face, triangulation);
    storeEdges(drawn, triangulation, location);
}

} // namespace

TopTools_MapOfShape slitsOf(const TopoDS_Face& face)
{
    TopTools_MapOfShape seen;
    TopTools_MapOfShape slits;
    for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next())
        if (!seen.Add(edges.Current()) && !BRep_Tool::IsClosed(TopoDS::Edge(edges.Current()), face))
            slits.Add(edges.Current());
    return slits;
}

Handle(Poly_PolygonOnTriangulation) polygonOf(const TopoDS_Edge& edge, const TopoDS_Face& face)
{
    TopLoc_Location location;
    const Handle(Poly_Triangulation)& triangulation = BRep_Tool::Triangulation(face, location);
    if (triangulation.IsNull())
        return {};
    return BRep_Tool::PolygonOnTriangulation(edge, triangulation, location);
}

bool redrawFace(const TopoDS_Face& face, const TopTools_IndexedDataMapOfShapeListOfShape& facesOfEdges,
                const std::set<const void*>& badFaces, const Tessellation& tessellation)
try {
    const TopoDS_Face forward = TopoDS::Face(face.Oriented(TopAbs_FORWARD));
    if (!slitsOf(forward).IsEmpty())
        return false;
    const DrawingFineness fineness{.deflection = tessellation.deflection / millimeter, .angle = tessellation.angle};
    FaceInPlace surface(forward, facesOfEdges, badFaces, fineness);
    const auto drawn = drawFace(forward, surface, fineness);
    if (!drawn)
        return false;
    store(forward, *drawn, fineness.deflection);
    return true;
} catch (const Standard_Failure&) {
    return false; // what cannot be evaluated stays as it is
}

} // namespace knead
