#include "io/brep/shape_box.h"

#include "io/brep/millimeter.h"
#include "io/document/size_limits.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include <algorithm>
#include <array>
#include <cstddef>

namespace knead {

namespace {

constexpr int boxSamplesPerEdge = 8;

Box toBox(const Bnd_Box& bounds)
{
    if (bounds.IsVoid() || bounds.IsOpen())
        return {};
    const gp_Pnt low = bounds.CornerMin();
    const gp_Pnt high = bounds.CornerMax();
    return {millimeter * Vec3(low.X(), low.Y(), low.Z()), millimeter * Vec3(high.X(), high.Y(), high.Z())};
}

/// Points of edges lie on faces, so their box is inside the box of the faces.
Box boxOfEdges(const TopoDS_Shape& shape)
{
    Box box;
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(shape, TopAbs_EDGE, edges);
    for (int i = 1; i <= edges.Extent(); ++i) {
        const TopoDS_Edge& edge = TopoDS::Edge(edges(i));
        if (BRep_Tool::Degenerated(edge) || !BRep_Tool::IsGeometric(edge))
            continue;
        const BRepAdaptor_Curve curve(edge);
        const double first = curve.FirstParameter();
        const double last = curve.LastParameter();
        if (Precision::IsInfinite(first) || Precision::IsInfinite(last))
            continue;
        for (int sample = 0; sample <= boxSamplesPerEdge; ++sample) {
            const gp_Pnt point = curve.Value(first + (last - first) * sample / boxSamplesPerEdge);
            box.extend(millimeter * Vec3(point.X(), point.Y(), point.Z()));
        }
    }
    return box;
}

/// For these the modeler has formulas; for others it searches with tens of thousands of points.
bool hasFormula(GeomAbs_SurfaceType type)
{
    return type == GeomAbs_Plane || type == GeomAbs_Cylinder || type == GeomAbs_Cone || type == GeomAbs_Sphere;
}

/// How far a patch reaches along the axes: the outermost of a grid of points, from where a search climbs on.
class PatchBox {
public:
    explicit PatchBox(const BRepAdaptor_Surface& surface)
        : m_surface(surface)
        , m_u{surface.FirstUParameter(), surface.LastUParameter()}
        , m_v{surface.FirstVParameter(), surface.LastVParameter()}
        , m_uSteps(stepsFor(surface.NbUIntervals(GeomAbs_C2)))
        , m_vSteps(stepsFor(surface.NbVIntervals(GeomAbs_C2)))
    {
    }

    Box run()
    {
        for (const double bound : {m_u.first, m_u.last, m_v.first, m_v.last})
            if (Precision::IsInfinite(bound))
                return {};
        std::array<Place, 6> outermost;
        for (int i = 0; i <= m_uSteps; ++i)
            for (int j = 0; j <= m_vSteps; ++j) {
                const Place place = at(m_u.first + i * stepOf(m_u, m_uSteps), m_v.first + j * stepOf(m_v, m_vSteps));
                for (std::size_t direction = 0; direction < outermost.size(); ++direction)
                    if (isFirst(i, j) || reach(place, direction) > reach(outermost[direction], direction))
                        outermost[direction] = place;
            }
        Box box;
        for (std::size_t direction = 0; direction < outermost.size(); ++direction)
            box.extend(millimeter * climbed(outermost[direction], direction).point);
        return box;
    }

private:
    struct Range {
        double first;
        double last;
    };

    struct Place {
        double u = 0;
        double v = 0;
        Vec3 point = Vec3::Zero();
    };

    static int stepsFor(int intervals) { return std::clamp(stepsPerInterval * intervals, leastSteps, mostSteps); }
    static double stepOf(const Range& range, int steps) { return (range.last - range.first) / steps; }
    static bool isFirst(int i, int j) { return i == 0 && j == 0; }

    /// Along +x, -x, +y, -y, +z, -z.
    static double reach(const Place& place, std::size_t direction)
    {
        const double coordinate = place.point[static_cast<Eigen::Index>(direction / 2)];
        return direction % 2 == 0 ? coordinate : -coordinate;
    }

    Place at(double u, double v) const
    {
        u = std::clamp(u, m_u.first, m_u.last);
        v = std::clamp(v, m_v.first, m_v.last);
        const gp_Pnt point = m_surface.Value(u, v);
        return {u, v, {point.X(), point.Y(), point.Z()}};
    }

    /// Goes to the best of four neighbors, and nearer ones when none is better.
    Place climbed(Place place, std::size_t direction) const
    {
        double uStep = 0.5 * stepOf(m_u, m_uSteps);
        double vStep = 0.5 * stepOf(m_v, m_vSteps);
        for (int halvings = 0; halvings < mostHalvings;) {
            Place best = place;
            for (const Place& next : {at(place.u + uStep, place.v), at(place.u - uStep, place.v),
                                      at(place.u, place.v + vStep), at(place.u, place.v - vStep)})
                if (reach(next, direction) > reach(best, direction))
                    best = next;
            if (reach(best, direction) > reach(place, direction)) {
                place = best;
                continue;
            }
            uStep /= 2;
            vStep /= 2;
            ++halvings;
        }
        return place;
    }

    static constexpr int stepsPerInterval = 3;
    static constexpr int leastSteps = 8;
    static constexpr int mostSteps = 40;
    static constexpr int mostHalvings = 16; // the height is flat at a summit: half of the digits are enough

    const BRepAdaptor_Surface& m_surface;
    Range m_u;
    Range m_v;
    int m_uSteps;
    int m_vSteps;
};

Box tightBox(const TopoDS_Face& face)
{
    if (const BRepAdaptor_Surface surface(face); !hasFormula(surface.GetType()))
        return PatchBox(surface).run();
    Bnd_Box box;
    BRepBndLib::AddOptimal(face, box, false, false);
    return toBox(box);
}

} // namespace

Box boxOfFaces(const TopoDS_Shape& shape)
{
    Box box = boxOfEdges(shape);
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(shape, TopAbs_FACE, faces);
    for (int i = 1; i <= faces.Extent(); ++i) {
        Bnd_Box loose; // of control points: quick, and enough for faces inside of what is known already
        BRepBndLib::Add(faces(i), loose, false);
        if (!loose.IsVoid() && !loose.IsOpen() && box.contains(toBox(loose)))
            continue;
        const Box ofFace = tightBox(TopoDS::Face(faces(i)));
        if (ofFace.isEmpty())
            return {};
        if (isWithinReach(box) && !isWithinReach(ofFace)) // damaged edges lead off the patch; triangles will tell
            continue;
        box.extend(ofFace);
    }
    return box;
}

Box tightened(const Box& box, const Box& ofTriangles, double deflection)
{
    Box result = box;
    for (int axis = 0; axis < 3; ++axis) {
        if (ofTriangles.min()[axis] - box.min()[axis] > 2 * deflection)
            result.min()[axis] = ofTriangles.min()[axis];
        if (box.max()[axis] - ofTriangles.max()[axis] > 2 * deflection)
            result.max()[axis] = ofTriangles.max()[axis];
    }
    return result;
}

} // namespace knead
