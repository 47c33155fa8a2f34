#include "io/export/smooth_edges.h"

#include "io/morph/trimmed_face.h"

#include <Eigen/LU>

#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <Geom_Surface.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Pnt2d.hxx>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace knead {

namespace {

constexpr double meantSmoothAngle = 1e-3; // [rad]: normals closer than this were meant to be the same
constexpr int looksPerEdge = 7;
constexpr int newtonSteps = 3;
constexpr double exact = 1e-7;      // [mm]
constexpr double inwards = 1e-7;    // of the way to the middle of a face
constexpr double degenerate = 1e-9; // of the product of the lengths of two tangents: they have no normal

/// The angle between two lines, 0 .. pi/2.
double angleBetween(const Vec3& a, const Vec3& b)
{
    return std::atan2(a.cross(b).norm(), std::abs(a.dot(b)));
}

std::optional<Vec3> normalAt(const Geom_Surface& surface, const gp_Pnt2d& at)
{
    gp_Pnt point;
    gp_Vec alongU;
    gp_Vec alongV;
    surface.D1(at.X(), at.Y(), point, alongU, alongV);
    const Vec3 normal = toVec3(alongU.XYZ()).cross(toVec3(alongV.XYZ()));
    const double length = normal.norm();
    if (!(length > degenerate * alongU.Magnitude() * alongV.Magnitude()) || length == 0)
        return std::nullopt;
    return Vec3(normal / length);
}

/// The box of a face's parameters.
struct Bounds {
    double lowU = 0;
    double highU = 0;
    double lowV = 0;
    double highV = 0;

    gp_XY middle() const { return {0.5 * (lowU + highU), 0.5 * (lowV + highV)}; }
    gp_XY within(double u, double v) const { return {std::clamp(u, lowU, highU), std::clamp(v, lowV, highV)}; }
};

Bounds boundsOf(const TopoDS_Face& face)
{
    Bounds bounds;
    BRepTools::UVBounds(face, bounds.lowU, bounds.highU, bounds.lowV, bounds.highV);
    return bounds;
}

/// A few steps of Newton's method towards the place on a surface that is nearest to a point.
gp_Pnt2d nearestFrom(gp_Pnt2d at, const Bounds& bounds, const Geom_Surface& surface, const gp_Pnt& place)
{
    for (int step = 0; step < newtonSteps; ++step) {
        gp_Pnt point;
        gp_Vec alongU;
        gp_Vec alongV;
        surface.D1(at.X(), at.Y(), point, alongU, alongV);
        const gp_Vec rest(point, place);
        const double uu = alongU.SquareMagnitude();
        const double vv = alongV.SquareMagnitude();
        const double uv = alongU.Dot(alongV);
        const double determinant = uu * vv - uv * uv;
        if (rest.SquareMagnitude() < exact * exact || determinant <= degenerate * uu * vv)
            return at;
        at.SetXY(bounds.within(at.X() + (vv * alongU.Dot(rest) - uv * alongV.Dot(rest)) / determinant,
                               at.Y() + (uu * alongV.Dot(rest) - uv * alongU.Dot(rest)) / determinant));
    }
    return at;
}

/// One side of an edge: a face and the edge's curve in its parameters.
struct Side {
    std::size_t face = 0; ///< index into the faces of the shape
    Handle(Geom2d_Curve) curve;
    double first = 0;
    double last = 0;
    Bounds bounds; ///< of the face

    /// A hair inside of the edge: at a seam, a closed surface has one normal to the left and maybe another to the right.
    gp_Pnt2d at(double share) const
    {
        const gp_XY there = curve->Value(first + share * (last - first)).XY();
        return gp_Pnt2d(there + inwards * (bounds.middle() - there));
    }
};

Side sideOf(const TopoDS_Edge& edge, const TopoDS_Face& face, int index, const Bounds& bounds)
{
    Side side{.face = static_cast<std::size_t>(index), .bounds = bounds};
    side.curve = BRep_Tool::CurveOnSurface(edge, face, side.first, side.last);
    return side;
}

class Comparison {
public:
    Comparison(const TopoDS_Shape& source, const TopoDS_Shape& moved, const std::vector<std::uint32_t>& origin,
               const MillimetreMap& map, double tolerance)
        : m_map(map)
        , m_tolerance(tolerance)
    {
        TopExp::MapShapes(source, TopAbs_FACE, m_sources);
        TopTools_IndexedMapOfShape faces;
        TopExp::MapShapes(moved, TopAbs_FACE, faces);
        m_before = surfacesOf(m_sources);
        m_after = ofOrigins(surfacesOf(faces), origin);
        for (int i = 1; i <= m_sources.Extent(); ++i)
            m_bounds.push_back(boundsOf(TopoDS::Face(m_sources(i))));
        TopExp::MapShapesAndUniqueAncestors(source, TopAbs_EDGE, TopAbs_FACE, m_facesOfEdge);
    }

    SmoothEdges result()
    {
        if (m_before.size() == m_after.size())
            for (int i = 1; i <= m_facesOfEdge.Extent(); ++i)
                compare(TopoDS::Edge(m_facesOfEdge.FindKey(i).Oriented(TopAbs_FORWARD)), m_facesOfEdge(i));
        return m_result;
    }

private:
    using Surfaces = std::vector<Handle(Geom_Surface)>;

    static Surfaces surfacesOf(const TopTools_IndexedMapOfShape& faces)
    {
        Surfaces surfaces;
        for (int i = 1; i <= faces.Extent(); ++i)
            surfaces.push_back(BRep_Tool::Surface(TopoDS::Face(faces(i))));
        return surfaces;
    }

    /// Per face of the source; null for those that came in several ones. None when nothing says which is which.
    Surfaces ofOrigins(const Surfaces& moved, const std::vector<std::uint32_t>& origin) const
    {
        if (origin.empty())
            return moved;
        if (origin.size() != moved.size())
            return {};
        Surfaces surfaces(m_before.size());
        std::vector<int> counts(m_before.size(), 0);
        for (std::size_t i = 0; i < origin.size(); ++i)
            surfaces[origin[i]] = ++counts[origin[i]] == 1 ? moved[i] : Handle(Geom_Surface)();
        return surfaces;
    }

    std::vector<Side> sidesOf(const TopoDS_Edge& edge, const TopTools_ListOfShape& faces) const
    {
        std::vector<Side> sides;
        for (const TopoDS_Shape& shape : faces) {
            const TopoDS_Face face = TopoDS::Face(shape.Oriented(TopAbs_FORWARD));
            const int index = m_sources.FindIndex(shape) - 1;
            if (index < 0 || m_before[index].IsNull() || m_after[index].IsNull())
                return {};
            sides.push_back(sideOf(edge, face, index, m_bounds[index]));
            if (BRep_Tool::IsClosed(edge, face))
                sides.push_back(sideOf(TopoDS::Edge(edge.Reversed()), face, index, m_bounds[index]));
        }
        std::erase_if(sides, [](const Side& side) { return side.curve.IsNull(); });
        return sides;
    }

    void compare(const TopoDS_Edge& edge, const TopTools_ListOfShape& faces)
    {
        if (BRep_Tool::Degenerated(edge))
            return;
        const std::vector<Side> sides = sidesOf(edge, faces);
        if (sides.size() != 2 || !wasSmooth(sides))
            return;
        bool counted = false;
        for (int k = 0; k < looksPerEdge; ++k) {
            const double share = (k + 0.5) / looksPerEdge;
            const auto a = movedNormal(sides[0], share);
            const auto b = movedNormal(sides[1], share);
            if (!a || !b)
                continue;
            const double angle = angleBetween(*a, *b);
            if (angle > meantSmoothAngle && isCreaseOfMap(sides, share))
                continue;
            counted = true;
            note(angle, sides[0], share);
        }
        m_result.count += counted ? 1 : 0;
    }

    bool wasSmooth(const std::vector<Side>& sides) const
    {
        for (int k = 0; k < looksPerEdge; ++k) {
            const double share = (k + 0.5) / looksPerEdge;
            const auto a = restNormal(sides[0], share);
            const auto b = restNormal(sides[1], share);
            if (!a || !b || angleBetween(*a, *b) > meantSmoothAngle)
                return false;
        }
        return true;
    }

    std::optional<Vec3> restNormal(const Side& side, double share) const
    {
        return normalAt(*m_before[side.face], side.at(share));
    }

    Vec3 placeOf(const Side& side, double share) const
    {
        const gp_Pnt2d at = side.at(share);
        return m_map.at(toVec3(m_before[side.face]->Value(at.X(), at.Y()).XYZ()));
    }

    /// At the parameters of the source, or beside them; where the surface has others now, at the nearest place.
    std::optional<Vec3> movedNormal(const Side& side, double share) const
    {
        const Handle(Geom_Surface)& surface = m_after[side.face];
        const gp_Pnt place = toPoint(placeOf(side, share));
        const gp_Pnt2d same = side.at(share);
        if (surface->Value(same.X(), same.Y()).Distance(place) <= m_tolerance)
            return normalAt(*surface, nearestFrom(same, side.bounds, *surface, place));
        const GeomAPI_ProjectPointOnSurf projection(place, surface);
        if (projection.NbPoints() == 0 || projection.LowerDistance() > 3 * m_tolerance)
            return std::nullopt;
        double u = 0;
        double v = 0;
        projection.LowerDistanceParameters(u, v);
        return normalAt(*surface, {u, v});
    }

    /// Whether the map takes the faces beside an edge to an angle itself.
    bool isCreaseOfMap(const std::vector<Side>& sides, double share) const
    {
        std::vector<Vec3> normals;
        for (const Side& side : sides) {
            const auto normal = restNormal(side, share);
            if (!normal)
                return false;
            const MillimetreMap map = m_map.forFace(placesOnEdges(m_sources(static_cast<int>(side.face) + 1)));
            const gp_Pnt2d at = side.at(share);
            const Mat3 gradient = map.gradient(toVec3(m_before[side.face]->Value(at.X(), at.Y()).XYZ()));
            normals.push_back(gradient.determinant() * gradient.inverse().transpose() * *normal);
        }
        return angleBetween(normals[0], normals[1]) > meantSmoothAngle;
    }

    void note(double angle, const Side& side, double share)
    {
        if (angle <= m_result.largestAngle)
            return;
        m_result.largestAngle = angle;
        m_result.where = placeOf(side, share);
    }

    const MillimetreMap& m_map;
    double m_tolerance;
    TopTools_IndexedMapOfShape m_sources;
    Surfaces m_before;
    Surfaces m_after;
    std::vector<Bounds> m_bounds; // per face
    TopTools_IndexedDataMapOfShapeListOfShape m_facesOfEdge;
    SmoothEdges m_result;
};

} // namespace

SmoothEdges compareSmoothEdges(const TopoDS_Shape& source, const TopoDS_Shape& moved,
                               const std::vector<std::uint32_t>& origin, const MillimetreMap& map, double tolerance)
{
    try {
        return Comparison(source, moved, origin, map, tolerance).result();
    } catch (const Standard_Failure&) {
        return {}; // nothing is said rather than something wrong
    }
}

} // namespace knead
