#include "io/brep/free_edges.h"

#include "io/brep/millimeter.h"
#include "io/mesh/open_borders.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>

#include <algorithm>
#include <cstddef>

namespace knead {

namespace {

constexpr int segmentsPerEdge = 16;
constexpr int mostEdgesCompared = 2000; // each with each

/// Points along an edge [mm], as its faces run along it; empty for an edge without a curve.
Polyline pointsOf(const TopoDS_Edge& edge)
{
    if (!BRep_Tool::IsGeometric(edge))
        return {};
    const BRepAdaptor_Curve curve(edge);
    const double first = curve.FirstParameter();
    const double last = curve.LastParameter();
    if (Precision::IsInfinite(first) || Precision::IsInfinite(last))
        return {};
    const int segments = curve.GetType() == GeomAbs_Line ? 1 : segmentsPerEdge;
    Polyline points;
    for (int i = 0; i <= segments; ++i) {
        const gp_Pnt point = curve.Value(first + (last - first) * i / segments);
        points.emplace_back(point.X(), point.Y(), point.Z());
    }
    if (edge.Orientation() == TopAbs_REVERSED)
        std::reverse(points.begin(), points.end());
    return points;
}

double distanceToSegment(const Vec3& point, const Vec3& a, const Vec3& b)
{
    const Vec3 along = b - a;
    const double length2 = along.squaredNorm();
    const double t = length2 > 0 ? std::clamp((point - a).dot(along) / length2, 0.0, 1.0) : 0.0;
    return (point - a - t * along).norm();
}

bool isNear(const Vec3& point, const Polyline& line, double distance)
{
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        if (distanceToSegment(point, line[i], line[i + 1]) <= distance)
            return true;
    return false;
}

} // namespace

TopTools_ListOfShape freeEdgesOf(const TopoDS_Shape& shape)
{
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(shape, TopAbs_EDGE, edges);
    std::vector<int> balance(static_cast<std::size_t>(edges.Extent()), 0);
    for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next())
        for (TopExp_Explorer uses(faces.Current(), TopAbs_EDGE); uses.More(); uses.Next()) {
            const TopoDS_Edge& edge = TopoDS::Edge(uses.Current());
            if (BRep_Tool::Degenerated(edge))
                continue;
            const TopAbs_Orientation orientation = edge.Orientation();
            const int step = orientation == TopAbs_FORWARD ? 1 : orientation == TopAbs_REVERSED ? -1 : 0;
            balance[static_cast<std::size_t>(edges.FindIndex(edge)) - 1] += step;
        }
    TopTools_ListOfShape free;
    for (int i = 1; i <= edges.Extent(); ++i)
        if (const int uses = balance[static_cast<std::size_t>(i) - 1]; uses != 0)
            free.Append(edges(i).Oriented(uses > 0 ? TopAbs_FORWARD : TopAbs_REVERSED));
    return free;
}

std::vector<std::vector<Vec3>> freeBordersOf(const TopoDS_Shape& shape)
{
    std::vector<Polyline> lines;
    double tolerance = 0;
    for (const TopoDS_Shape& edge : freeEdgesOf(shape)) {
        Polyline points = pointsOf(TopoDS::Edge(edge));
        if (points.empty())
            continue;
        for (Vec3& point : points)
            point *= millimeter;
        lines.push_back(std::move(points));
        tolerance = std::max(tolerance, millimeter * BRep_Tool::Tolerance(TopoDS::Edge(edge)));
    }
    return chained(std::move(lines), tolerance);
}

bool canBeSewn(const TopoDS_Shape& shape, double distance)
{
    const TopTools_ListOfShape edges = freeEdgesOf(shape);
    if (edges.Extent() > mostEdgesCompared)
        return true;
    std::vector<Polyline> lines;
    for (const TopoDS_Shape& edge : edges)
        if (Polyline points = pointsOf(TopoDS::Edge(edge)); !points.empty())
            lines.push_back(std::move(points));
    std::vector<Box> boxes(lines.size());
    for (std::size_t i = 0; i < lines.size(); ++i)
        for (const Vec3& point : lines[i])
            boxes[i].extend(point);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const Polyline& line = lines[i];
        if (lengthOf(line) <= 2 * distance) // near its neighbors in any case; sewing would make a point of it
            continue;
        // A curve lies off its polyline by a share of a segment; two that coincide may be cut at different places.
        const double slack = distance + 0.02 * (line[1] - line[0]).norm();
        const Vec3 middle = line.size() == 2 ? Vec3(0.5 * (line[0] + line[1])) : line[line.size() / 2];
        for (std::size_t other = 0; other < lines.size(); ++other)
            if (other != i && boxes[other].squaredExteriorDistance(middle) <= slack * slack &&
                isNear(middle, lines[other], slack))
                return true;
    }
    return false;
}

} // namespace knead
