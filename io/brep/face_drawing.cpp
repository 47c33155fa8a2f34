#include "io/brep/face_drawing.h"

#include "core/geometry/planar_mesh.h"
#include "core/geometry/polygon_triangulation.h"

#include <BRepTools_WireExplorer.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Standard_Failure.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Wire.hxx>

#include <algorithm>
#include <cmath>
#include <utility>

namespace knead {

namespace {

using Vec2 = Eigen::Vector2d;

constexpr double closedShare = 1e-3;           // of the extent of a loop in its parameters: gaps that rounding makes
constexpr std::size_t mostPoints = 60'000;     // of a face
constexpr std::size_t mostBorderPoints = 6000; // the time to triangulate goes with their square
constexpr double normalAngleOfSides = 1.5;     // of the angle between chords, between the normals at the ends of a side
constexpr double leastSideOverDeflection = 20; // shorter sides are not divided for their normals

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
    FaceDrawing(const TopoDS_Face& face, SurfaceToDraw& surface, const DrawingFineness& fineness)
        : m_face(TopoDS::Face(face.Oriented(TopAbs_FORWARD)))
        , m_surface(surface)
        , m_fineness(fineness)
    {
    }

    /// @return none when the border does not close
    std::optional<DrawnFace> draw()
    {
        for (TopoDS_Iterator wires(m_face); wires.More(); wires.Next())
            if (wires.Value().ShapeType() == TopAbs_WIRE && !addWire(TopoDS::Wire(wires.Value())))
                return std::nullopt;
        if (m_loopEnds.empty() || m_border.size() > mostBorderPoints || !orderLoops())
            return std::nullopt;
        chooseScale();
        triangulateBorder();
        refine();
        return result();
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
        ends.reserve(edges.size());
        for (const TopoDS_Edge& edge : edges)
            ends.push_back(addEdge(edge));
        return isClosed(first, edges.size(), ends);
    }

    /// @return where the edge ends, in the parameters
    Vec2 addEdge(const TopoDS_Edge& edge)
    {
        const EdgePoints points = m_surface.pointsOf(edge);
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
        for (const BorderPoint& point : m_border)
            sum += m_surface.metricAt(point.parameters);
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
            m_normals.push_back(m_surface.normalAt(m_border[point].parameters));
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
        const bool isLarge = m_places[t[0]].Distance(m_places[t[1]]) > m_fineness.undividedSide() &&
                             m_places[t[1]].Distance(m_places[t[2]]) > m_fineness.undividedSide();
        if (isLarge && m_surface.placeAt(center).Distance(gp_Pnt(middle)) / m_fineness.deflection > worst)
            at = 3;
        if (at > 3)
            return {};
        std::vector<std::uint32_t> changed = at == 3 ? m_mesh->addInside(triangle) : m_mesh->addOnSide(triangle, at);
        const Vec2 parameters = m_mesh->points().back().cwiseQuotient(m_scale);
        m_places.push_back(m_surface.placeAt(parameters));
        m_normals.push_back(m_surface.normalAt(parameters));
        return changed;
    }

    /// How far the middle of a side is off the surface, as a multiple of what it may be; or its normals from each other.
    double excessOf(std::uint32_t a, std::uint32_t b) const
    {
        const double length = m_places[a].Distance(m_places[b]);
        if (length < m_fineness.undividedSide())
            return 0;
        const Vec2 middle = (m_mesh->points()[a] + m_mesh->points()[b]).cwiseQuotient(2 * m_scale);
        const gp_Pnt chord((m_places[a].XYZ() + m_places[b].XYZ()) / 2);
        double excess = m_surface.placeAt(middle).Distance(chord) / m_fineness.deflection;
        if (length > leastSideOverDeflection * m_fineness.deflection)
            excess = std::max(excess, m_normals[a].Angle(m_normals[b]) / (normalAngleOfSides * m_fineness.angle));
        return std::max(excess, length / m_fineness.longestSide);
    }

    DrawnFace result() const
    {
        DrawnFace drawn;
        for (const Vec2& point : m_mesh->points())
            drawn.parameters.emplace_back(point.cwiseQuotient(m_scale));
        drawn.places = m_places;
        drawn.triangles = m_mesh->triangles();
        constexpr std::uint32_t none = 0xffffffffU;
        std::vector<std::uint32_t> numbers(m_border.size(), none);
        for (std::uint32_t corner = 0; corner < m_pointOfCorner.size(); ++corner)
            numbers[m_pointOfCorner[corner]] = corner;
        for (std::size_t i = 0; i < m_runs.size(); ++i) {
            const Run& run = m_runs[i];
            const std::size_t count = run.parameters.size();
            DrawnFace::Run& along = drawn.runs.emplace_back();
            along.edge = run.edge;
            along.parameters = run.parameters;
            for (std::size_t k = 0; k < count; ++k) {
                const std::size_t step = run.isReversed ? count - 1 - k : k;
                along.points.push_back(numbers[step + 1 < count ? run.first + step : startAfter(i)]);
            }
            if (std::find(along.points.begin(), along.points.end(), none) !=
                along.points.end()) // of a loop of two points
                along.points.clear();
        }
        return drawn;
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
    SurfaceToDraw& m_surface;
    DrawingFineness m_fineness;
    Vec2 m_scale = Vec2::Ones();

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

std::optional<DrawnFace> drawFace(const TopoDS_Face& face, SurfaceToDraw& surface, const DrawingFineness& fineness)
{
    return FaceDrawing(face, surface, fineness).draw();
}

} // namespace knead
