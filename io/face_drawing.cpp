#include "io/face_drawing.h"

#include "core/geometry/planar_mesh.h"
#include "core/geometry/polygon_triangulation.h"
#include "io/millimeter.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepTools_WireExplorer.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_TangentialDeflection.hxx>
#include <Geom2d_Curve.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Wire.hxx>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

namespace knead {

namespace {

using Vec2 = Eigen::Vector2d;

constexpr double closedShare = 1e-3;           // of the extent of a loop in its parameters: gaps that rounding makes
constexpr std::size_t mostPoints = 60'000;     // of a face
constexpr std::size_t mostBorderPoints = 6000; // the time to triangulate goes with their square
constexpr double coarsestPole = 8;             // pieces of an edge without length, where no angle says more
constexpr double normalAngleOfSides = 1.5;     // of the angle between chords, between the normals at the ends of a side
constexpr double leastSideOverDeflection = 20; // shorter sides are not divided for their normals

/// The points that divide an edge, from its first to its last parameter.
struct EdgePoints {
    std::vector<double> parameters;
    std::vector<gp_Pnt> points; ///< where the edge lies in the shape [mm]
};

/// A point of the border of a face.
struct BorderPoint {
    Vec2 parameters;
    gp_Pnt place; ///< [mm]
};

/// An edge as a wire of the face runs along it.
struct Run {
    TopoDS_Edge edge;
    std::vector<double> parameters; ///< of the points, as the edge itself runs
    std::size_t first = 0;          ///< of its points in the border
    bool isReversed = false;
};

/// Draws one face: its border in the parameters, triangles between the points of the border, then points inside where
/// triangles lie too far off the surface.
class FaceDrawing {
public:
    FaceDrawing(const TopoDS_Face& face, const TopTools_IndexedDataMapOfShapeListOfShape& facesOfEdges,
                const std::set<const void*>& badFaces, const Tessellation& tessellation)
        : m_face(TopoDS::Face(face.Oriented(TopAbs_FORWARD)))
        , m_facesOfEdges(facesOfEdges)
        , m_badFaces(badFaces)
        , m_deflection(tessellation.deflection / millimeter)
        , m_angle(tessellation.angle)
        , m_surface(m_face, false)
    {
    }

    /// @return false when the border does not close
    bool draw()
    {
        if (!slitsOf(m_face).IsEmpty())
            return false;
        for (TopoDS_Iterator wires(m_face); wires.More(); wires.Next())
            if (wires.Value().ShapeType() == TopAbs_WIRE && !addWire(TopoDS::Wire(wires.Value())))
                return false;
        if (m_loopEnds.empty() || m_border.size() > mostBorderPoints || !orderLoops())
            return false;
        chooseScale();
        triangulateBorder();
        refine();
        store();
        return true;
    }

private:
    bool addWire(const TopoDS_Wire& wire)
    {
        std::vector<TopoDS_Edge> edges;
        for (BRepTools_WireExplorer along(wire, m_face); along.More(); along.Next())
            edges.push_back(along.Current());
        std::size_t count = 0;
        for (TopoDS_Iterator all(wire); all.More(); all.Next())
            count +=
                all.Value().Orientation() == TopAbs_FORWARD || all.Value().Orientation() == TopAbs_REVERSED ? 1 : 0;
        if (edges.size() != count)
            return false;
        if (edges.empty())
            return true;
        const std::size_t first = m_border.size();
        std::vector<Vec2> ends; // of the runs, in the parameters
        for (const TopoDS_Edge& edge : edges)
            ends.push_back(addEdge(edge));
        return isClosed(first, edges.size(), ends);
    }

    /// @return where the edge ends, in the parameters
    Vec2 addEdge(const TopoDS_Edge& edge)
    {
        const EdgePoints points = pointsOf(edge);
        double first = 0;
        double last = 0;
        const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, m_face, first, last);
        if (curve.IsNull())
            throw Standard_Failure("an edge without a curve in the parameters");
        const std::size_t count = points.parameters.size();
        const double range = points.parameters.back() - points.parameters.front();
        const auto at = [&](std::size_t i) {
            const double share = range == 0 ? 0 : (points.parameters[i] - points.parameters.front()) / range;
            const gp_Pnt2d point = curve->Value(first + share * (last - first));
            return Vec2(point.X(), point.Y());
        };
        const bool isReversed = edge.Orientation() == TopAbs_REVERSED;
        m_runs.push_back({edge, points.parameters, m_border.size(), isReversed});
        for (std::size_t i = 0; i + 1 < count; ++i) {
            const std::size_t k = isReversed ? count - 1 - i : i;
            m_border.push_back({at(k), points.points[k]});
        }
        return at(isReversed ? 0 : count - 1);
    }

    /// Those of the neighbor, or else of our own.
    EdgePoints pointsOf(const TopoDS_Edge& edge)
    {
        EdgePoints& known = m_pointsOfEdge[edge.TShape().get()];
        if (known.points.empty())
            if (const auto ofNeighbor = pointsOfNeighbor(edge))
                known = *ofNeighbor;
        if (known.points.empty())
            known = BRep_Tool::Degenerated(edge) ? pointsOfPole(edge) : ownPoints(edge);
        return known;
    }

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
        const GCPnts_TangentialDeflection division(curve, m_angle, m_deflection, 2);
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
        const double pieces = isRound ? std::abs(curve->Value(last).X() - start.X()) / m_angle : coarsestPole;
        const auto count = static_cast<int>(std::clamp(std::ceil(pieces), 1.0, 100.0));
        const gp_Pnt place = m_surface.Value(start.X(), start.Y());
        EdgePoints points;
        for (int i = 0; i <= count; ++i) {
            points.parameters.push_back(first + (last - first) * i / count);
            points.points.push_back(place);
        }
        return points;
    }

    /// Whether each of the last runs ends where the next one begins.
    bool isClosed(std::size_t firstPoint, std::size_t runs, const std::vector<Vec2>& ends)
    {
        Vec2 low = m_border[firstPoint].parameters;
        Vec2 high = low;
        for (std::size_t i = firstPoint; i < m_border.size(); ++i) {
            low = low.cwiseMin(m_border[i].parameters);
            high = high.cwiseMax(m_border[i].parameters);
        }
        const Vec2 extent = high - low;
        const std::size_t firstRun = m_runs.size() - runs;
        for (std::size_t i = 0; i < runs; ++i) {
            const Vec2 gap = m_border[m_runs[firstRun + (i + 1) % runs].first].parameters - ends[i];
            if (std::abs(gap.x()) > closedShare * extent.x() + 1e-9 ||
                std::abs(gap.y()) > closedShare * extent.y() + 1e-9)
                return false;
        }
        m_loopEnds.push_back(m_border.size());
        return true;
    }

    double areaOf(std::size_t first, std::size_t end) const
    {
        double area = 0;
        for (std::size_t i = first; i < end; ++i) {
            const Vec2& a = m_border[i].parameters;
            const Vec2& b = m_border[i + 1 < end ? i + 1 : first].parameters;
            area += 0.5 * (a.x() * b.y() - a.y() * b.x());
        }
        return area;
    }

    /// The outline comes first. @return false when there is none
    bool orderLoops()
    {
        std::size_t first = 0;
        std::vector<std::pair<std::size_t, std::size_t>> loops;
        for (const std::size_t end : m_loopEnds) {
            if (end - first >= 3)
                loops.emplace_back(first, end);
            first = end;
        }
        const auto outline = std::max_element(loops.begin(), loops.end(), [&](const auto& a, const auto& b) {
            return areaOf(a.first, a.second) < areaOf(b.first, b.second);
        });
        if (outline == loops.end() || areaOf(outline->first, outline->second) <= 0)
            return false;
        std::iter_swap(loops.begin(), outline);
        for (const auto& [begin, end] : loops) {
            for (std::size_t i = begin; i < end; ++i)
                m_pointOfCorner.push_back(static_cast<std::uint32_t>(i));
            m_cornerLoopEnds.push_back(m_pointOfCorner.size());
        }
        return true;
    }

    /// Parameters times scale are about lengths.
    void chooseScale()
    {
        Vec2 sum = Vec2::Zero();
        for (const BorderPoint& point : m_border) {
            gp_Pnt place;
            gp_Vec alongU;
            gp_Vec alongV;
            m_surface.D1(point.parameters.x(), point.parameters.y(), place, alongU, alongV);
            sum += Vec2(alongU.Magnitude(), alongV.Magnitude());
        }
        m_scale = sum / static_cast<double>(m_border.size());
        for (int i = 0; i < 2; ++i)
            if (!(m_scale[i] > 0))
                m_scale[i] = 1;
    }

    /// A border that passes over itself is triangulated all the same: each of its sides gets one triangle.
    void triangulateBorder()
    {
        std::vector<Vec2> corners;
        for (const std::uint32_t point : m_pointOfCorner)
            corners.emplace_back(m_border[point].parameters.cwiseProduct(m_scale));
        m_mesh.emplace(corners, triangulate(corners, m_cornerLoopEnds));
        for (const std::uint32_t point : m_pointOfCorner) {
            m_places.push_back(m_border[point].place);
            m_normals.push_back(normalAt(m_border[point].parameters));
        }
    }

    void refine()
    {
        std::vector<std::uint32_t> open;
        for (std::uint32_t t = 0; t < m_mesh->triangles().size(); ++t)
            open.push_back(t);
        while (!open.empty() && m_places.size() < mostPoints) {
            const std::uint32_t triangle = open.back();
            open.pop_back();
            const std::vector<std::uint32_t> changed = divide(triangle);
            open.insert(open.end(), changed.begin(), changed.end());
        }
    }

    /// Puts a point where a triangle is farthest off the surface, if that is too far.
    std::vector<std::uint32_t> divide(std::uint32_t triangle)
    {
        if (!(m_mesh->turnOf(triangle) > 0))
            return {};
        const PlanarMesh::Triangle& t = m_mesh->triangles()[triangle];
        double worst = 1;
        std::size_t at = 4;
        for (std::size_t side = 0; side < 3; ++side)
            if (const double share = m_mesh->isBorder(triangle, side) ? 0 : excessOf(t[side], t[(side + 1) % 3]);
                share > worst) {
                worst = share;
                at = side;
            }
        const Vec2 center =
            (m_mesh->points()[t[0]] + m_mesh->points()[t[1]] + m_mesh->points()[t[2]]).cwiseQuotient(3 * m_scale);
        const gp_XYZ middle = (m_places[t[0]].XYZ() + m_places[t[1]].XYZ() + m_places[t[2]].XYZ()) / 3;
        const bool isLarge = m_places[t[0]].Distance(m_places[t[1]]) > m_deflection &&
                             m_places[t[1]].Distance(m_places[t[2]]) > m_deflection;
        if (isLarge && valueAt(center).Distance(gp_Pnt(middle)) / m_deflection > worst)
            at = 3;
        if (at > 3)
            return {};
        const std::vector<std::uint32_t> changed =
            at == 3 ? m_mesh->addInside(triangle) : m_mesh->addOnSide(triangle, at);
        const Vec2 parameters = m_mesh->points().back().cwiseQuotient(m_scale);
        m_places.push_back(valueAt(parameters));
        m_normals.push_back(normalAt(parameters));
        return changed;
    }

    /// How far the middle of a side is off the surface, as a multiple of what it may be; or its normals from each other.
    double excessOf(std::uint32_t a, std::uint32_t b) const
    {
        const double length = m_places[a].Distance(m_places[b]);
        if (length < m_deflection)
            return 0;
        const Vec2 middle = (m_mesh->points()[a] + m_mesh->points()[b]).cwiseQuotient(2 * m_scale);
        const gp_Pnt chord((m_places[a].XYZ() + m_places[b].XYZ()) / 2);
        double excess = valueAt(middle).Distance(chord) / m_deflection;
        if (length > leastSideOverDeflection * m_deflection)
            excess = std::max(excess, m_normals[a].Angle(m_normals[b]) / (normalAngleOfSides * m_angle));
        return excess;
    }

    gp_Pnt valueAt(const Vec2& parameters) const { return m_surface.Value(parameters.x(), parameters.y()); }

    gp_Vec normalAt(const Vec2& parameters) const
    {
        gp_Pnt place;
        gp_Vec alongU;
        gp_Vec alongV;
        m_surface.D1(parameters.x(), parameters.y(), place, alongU, alongV);
        const gp_Vec normal = alongU.Crossed(alongV);
        return normal.Magnitude() > 0 ? normal : gp_Vec(0, 0, 1);
    }

    /// Writes the triangles to the face and the points of the border to its edges.
    void store() const
    {
        TopLoc_Location location = m_face.Location();
        const gp_Trsf back = location.Transformation().Inverted();
        const Handle(Poly_Triangulation) triangulation = new Poly_Triangulation(
            static_cast<int>(m_places.size()), static_cast<int>(m_mesh->triangles().size()), true);
        for (std::size_t i = 0; i < m_places.size(); ++i) {
            const Vec2 parameters = m_mesh->points()[i].cwiseQuotient(m_scale);
            triangulation->SetNode(static_cast<int>(i) + 1, m_places[i].Transformed(back));
            triangulation->SetUVNode(static_cast<int>(i) + 1, gp_Pnt2d(parameters.x(), parameters.y()));
        }
        for (std::size_t t = 0; t < m_mesh->triangles().size(); ++t) {
            const auto [a, b, c] = m_mesh->triangles()[t];
            triangulation->SetTriangle(
                static_cast<int>(t) + 1,
                Poly_Triangle(static_cast<int>(a) + 1, static_cast<int>(b) + 1, static_cast<int>(c) + 1));
        }
        triangulation->Deflection(m_deflection);
        BRep_Builder().UpdateFace(m_face, triangulation);
        storeEdges(triangulation, location);
    }

    void storeEdges(const Handle(Poly_Triangulation) & triangulation, const TopLoc_Location& location) const
    {
        std::vector<int> nodeOfPoint(m_border.size(), 0);
        for (std::size_t corner = 0; corner < m_pointOfCorner.size(); ++corner)
            nodeOfPoint[m_pointOfCorner[corner]] = static_cast<int>(corner) + 1;
        std::map<const void*, std::vector<std::pair<bool, Handle(Poly_PolygonOnTriangulation)>>> polygons;
        for (std::size_t i = 0; i < m_runs.size(); ++i) {
            const Run& run = m_runs[i];
            const std::size_t count = run.parameters.size();
            TColStd_Array1OfInteger nodes(1, static_cast<int>(count));
            TColStd_Array1OfReal parameters(1, static_cast<int>(count));
            for (std::size_t k = 0; k < count; ++k) {
                const std::size_t step = run.isReversed ? count - 1 - k : k;
                const std::size_t point = step + 1 < count ? run.first + step : startAfter(i);
                nodes.SetValue(static_cast<int>(k) + 1, nodeOfPoint[point]);
                parameters.SetValue(static_cast<int>(k) + 1, run.parameters[k]);
            }
            if (std::find(nodes.begin(), nodes.end(), 0) != nodes.end()) // of a loop of two points
                continue;
            Handle(Poly_PolygonOnTriangulation) polygon = new Poly_PolygonOnTriangulation(nodes, parameters);
            polygon->Deflection(m_deflection);
            polygons[run.edge.TShape().get()].emplace_back(run.isReversed, polygon);
        }
        for (const Run& run : m_runs) {
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

    /// The first point of the run that follows in the same wire.
    std::size_t startAfter(std::size_t run) const
    {
        std::size_t loopBegin = 0;
        for (const std::size_t end : m_loopEnds) {
            if (m_runs[run].first < end)
                return run + 1 < m_runs.size() && m_runs[run + 1].first < end ? m_runs[run + 1].first : loopBegin;
            loopBegin = end;
        }
        return loopBegin;
    }

    TopoDS_Face m_face;
    const TopTools_IndexedDataMapOfShapeListOfShape& m_facesOfEdges;
    const std::set<const void*>& m_badFaces;
    double m_deflection; // [mm]
    double m_angle;
    BRepAdaptor_Surface m_surface;
    Vec2 m_scale = Vec2::Ones();

    std::map<const void*, EdgePoints> m_pointsOfEdge;
    std::vector<BorderPoint> m_border; // of all wires, one after the other
    std::vector<std::size_t> m_loopEnds;
    std::vector<Run> m_runs;
    std::vector<std::uint32_t> m_pointOfCorner; // of the border; outline first
    std::vector<std::size_t> m_cornerLoopEnds;

    std::optional<PlanarMesh> m_mesh;
    std::vector<gp_Pnt> m_places; // by point of the mesh [mm]
    std::vector<gp_Vec> m_normals;
};

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

bool drawFace(const TopoDS_Face& face, const TopTools_IndexedDataMapOfShapeListOfShape& facesOfEdges,
              const std::set<const void*>& badFaces, const Tessellation& tessellation)
try {
    return FaceDrawing(face, facesOfEdges, badFaces, tessellation).draw();
} catch (const Standard_Failure&) {
    return false; // what cannot be evaluated stays as it is
}

} // namespace knead
