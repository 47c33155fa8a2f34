#include "core/skin/surface_cut.h"

#include "core/geometry/half_edges.h"
#include "core/geometry/polygon_triangulation.h"
#include "core/geometry/winding_number.h"
#include "core/skin/crack_surface.h"
#include "core/skin/crossings.h"
#include "core/skin/face_set.h"
#include "core/skin/specks.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace knead {

namespace {

using Vec2 = Eigen::Vector2d;
using Triangle = TriangleMesh::Triangle;
constexpr std::uint32_t none = 0xffffffffU;
constexpr std::uint32_t outside = 0; // tags of lines on cracks
constexpr std::uint32_t inside = 1;

constexpr double leastShell = 0.5; // smaller ones beside the main shell of a label are given away [cells]

/// Coordinates in the plane of a triangle, which is counter-clockwise in them.
class PlaneOf {
public:
    PlaneOf(const Vec3& a, const Vec3& b, const Vec3& c)
        : m_origin(a)
        , m_x((b - a).normalized())
        , m_y((b - a).cross(c - a).normalized().cross(m_x))
    {
    }
    Vec2 operator()(const Vec3& place) const { return {m_x.dot(place - m_origin), m_y.dot(place - m_origin)}; }

private:
    Vec3 m_origin;
    Vec3 m_x;
    Vec3 m_y;
};

/// Points are the vertices of the surface, then those of the cracks, then those where the two cross.
class SurfaceCutter {
public:
    SurfaceCutter(const TriangleMesh& skin, const LabeledNodes& nodes, std::uint64_t salt, TaskControl& control)
        : m_skin(skin)
        , m_nodes(nodes)
        , m_halfEdges(findHalfEdges(skin))
        , m_cracks(findCrackSurface(nodes, salt, control))
        , m_crossings(findCrossings(skin, m_halfEdges, m_cracks, nodes.lattice(), control))
    {
    }

    std::vector<SewnMesh> cut(const LabelSeams& seams, TaskControl& control)
    {
        addSkin();
        control.throwIfCancelled();
        addCracks();
        control.throwIfCancelled();
        const double cell = std::pow(m_nodes.lattice().spacing, 3);
        const auto place = [&](std::uint32_t point) { return placeOf(point); };
        joinSpecks(m_cut, place, leastShell * cell);
        control.throwIfCancelled();
        return sewn(m_cut, place, seams);
    }

private:
    Vec3 placeOf(std::uint32_t point) const
    {
        if (point < m_skin.vertices.size())
            return m_skin.vertices[point];
        const std::size_t next = point - m_skin.vertices.size();
        return next < m_cracks.vertices.size() ? m_cracks.vertices[next]
                                               : m_crossings.points[next - m_cracks.vertices.size()].place;
    }
    std::uint32_t crackPoint(std::uint32_t vertex) const
    {
        return static_cast<std::uint32_t>(m_skin.vertices.size()) + vertex;
    }
    std::uint32_t crossingPoint(std::uint32_t crossing) const
    {
        return static_cast<std::uint32_t>(m_skin.vertices.size() + m_cracks.vertices.size()) + crossing;
    }
    Triangle crackCorners(std::size_t triangle) const
    {
        const auto& corners = m_cracks.triangles[triangle].corners;
        return {crackPoint(corners[0]), crackPoint(corners[1]), crackPoint(corners[2])};
    }

    /// Where the stretches of an edge are counted from. One stretch more than there are points on it.
    std::vector<std::size_t> stretchBegins(bool onCrack, std::size_t edges) const
    {
        std::vector<std::size_t> begins(edges + 1, 1);
        begins[0] = 0;
        for (const SurfaceCrossings::Point& point : m_crossings.points)
            if (point.isOnCrack == onCrack)
                ++begins[point.edge + 1];
        std::partial_sum(begins.begin(), begins.end(), begins.begin());
        return begins;
    }

    struct Side {
        std::uint32_t edge;
        bool isReversed; // runs against its edge
    };
    Side skinSide(std::size_t triangle, std::size_t side) const
    {
        const auto halfEdge = static_cast<std::uint32_t>(3 * triangle + side);
        const std::uint32_t edge = edgeOf(m_halfEdges, halfEdge);
        return {edge, edge != halfEdge};
    }
    Side crackSide(std::size_t triangle, std::size_t side) const
    {
        const CrackSurface::Triangle& t = m_cracks.triangles[triangle];
        return {t.edges[side], t.corners[side] > t.corners[(side + 1) % 3]};
    }

    std::vector<std::uint32_t> pointsOn(bool onCrack, const Side& side) const
    {
        const SurfaceCrossings::Range range = m_crossings.on(onCrack, side.edge);
        std::vector<std::uint32_t> points;
        for (std::uint32_t i = range.begin; i < range.end; ++i)
            points.push_back(crossingPoint(i));
        if (side.isReversed)
            std::ranges::reverse(points);
        return points;
    }

    /// Segments of one triangle after the other.
    std::vector<FaceSet::Divided> divideAll(bool onCrack, const std::vector<SurfaceCrossings::Segment>& segments) const
    {
        const auto triangleOf = [&](std::size_t i) {
            return onCrack ? segments[i].crackTriangle : segments[i].skinTriangle;
        };
        std::vector<FaceSet::Divided> divided;
        for (std::size_t i = 0; i < segments.size();) {
            const std::uint32_t number = triangleOf(i);
            DividedTriangle triangle;
            triangle.corners = onCrack ? crackCorners(number) : m_skin.triangles[number];
            for (std::size_t side = 0; side < 3; ++side)
                triangle.onSides[side] = pointsOn(onCrack, onCrack ? crackSide(number, side) : skinSide(number, side));
            for (; i < segments.size() && triangleOf(i) == number; ++i) {
                const CrackSurface::Triangle& crack = m_cracks.triangles[segments[i].crackTriangle];
                triangle.lines.push_back({crossingPoint(segments[i].start), crossingPoint(segments[i].end),
                                          onCrack ? outside : crack.back, onCrack ? inside : crack.front});
            }
            const PlaneOf plane = planeOf(triangle.corners);
            for (TriangleFace& face : divide(triangle, [&](std::uint32_t p) { return plane(placeOf(p)); }))
                divided.push_back({number, std::move(face)});
        }
        return divided;
    }

    PlaneOf planeOf(const Triangle& corners) const
    {
        return {placeOf(corners[0]), placeOf(corners[1]), placeOf(corners[2])};
    }

    template <typename SideOf>
    static void joinOverEdges(FaceSet& faces, std::size_t triangles, const std::vector<std::size_t>& begins,
                              SideOf&& sideOf)
    {
        for (std::size_t t = 0; t < triangles; ++t)
            for (std::size_t side = 0; side < 3 && !faces.isDivided(t); ++side)
                faces.touch(static_cast<std::uint32_t>(t), begins[sideOf(t, side).edge]);
        for (std::size_t i = 0; i < faces.divided().size(); ++i)
            for (const TriangleFace::Border& border : faces.divided()[i].face.borders) {
                const Side side = sideOf(faces.divided()[i].triangle, border.side);
                const std::size_t points = begins[side.edge + 1] - begins[side.edge] - 1;
                const std::size_t stretch = side.isReversed ? points - border.stretch : border.stretch;
                faces.touch(faces.numberOf(i), begins[side.edge] + stretch);
            }
    }

    std::vector<Triangle> trianglesOf(const FaceSet::Divided& divided, const Triangle& corners) const
    {
        const PlaneOf plane = planeOf(corners);
        std::vector<std::uint32_t> points;
        std::vector<Vec2> places;
        std::vector<std::size_t> ends;
        for (const std::vector<std::uint32_t>& loop : divided.face.loops) {
            points.insert(points.end(), loop.begin(), loop.end());
            ends.push_back(points.size());
        }
        for (const std::uint32_t point : points)
            places.push_back(plane(placeOf(point)));
        std::vector<Triangle> triangles;
        for (const auto& t : triangulate(places, ends))
            triangles.push_back({points[t[0]], points[t[1]], points[t[2]]});
        return triangles;
    }

    void addSkin()
    {
        const std::size_t count = m_skin.triangles.size();
        const std::vector<std::size_t> begins = stretchBegins(false, 3 * count);
        FaceSet faces(count, divideAll(false, m_crossings.segments), begins.back());
        joinOverEdges(faces, count, begins, [&](std::size_t t, std::size_t side) { return skinSide(t, side); });
        std::vector<std::uint32_t> labels = faces.tags();
        labelWhole(faces, labels);
        const auto faceOf = [&](std::size_t t) {
            return m_skin.faceOfTriangle.empty() ? Aggregate::noFace : m_skin.faceOfTriangle[t];
        };
        for (std::size_t t = 0; t < count; ++t)
            if (!faces.isDivided(t) && !isFolded(m_skin.triangles[t]))
                m_cut.skin.push_back({m_skin.triangles[t], faceOf(t), labels[faces.find(t)]});
        for (std::size_t i = 0; i < faces.divided().size(); ++i) {
            const FaceSet::Divided& divided = faces.divided()[i];
            for (const Triangle& t : trianglesOf(divided, m_skin.triangles[divided.triangle]))
                m_cut.skin.push_back({t, faceOf(divided.triangle), labels[faces.find(faces.numberOf(i))]});
        }
    }

    static bool isFolded(const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

    /// Parts of the surface that no crack crosses have the label of the material around them.
    void labelWhole(FaceSet& faces, std::vector<std::uint32_t>& labels) const
    {
        std::vector<std::uint8_t> isSure(labels.size(), 0);
        for (std::size_t i = 0; i < labels.size(); ++i)
            isSure[i] = labels[i] != none ? 1 : 0;
        for (std::size_t t = 0; t < m_skin.triangles.size(); ++t) {
            const std::size_t set = faces.find(t);
            if (faces.isDivided(t) || isSure[set] != 0)
                continue;
            const LabeledNodes::Found found = m_nodes.find(m_skin.vertices[m_skin.triangles[t][0]]);
            if (found.isSure || labels[set] == none) {
                labels[set] = found.label;
                isSure[set] = found.isSure ? 1 : 0;
            }
        }
        for (std::size_t t = 0; t < m_skin.triangles.size(); ++t)
            if (!faces.isDivided(t) && labels[faces.find(t)] == none)
                throw DegenerateCut();
    }

    void addCracks()
    {
        const std::size_t count = m_cracks.triangles.size();
        std::vector<SurfaceCrossings::Segment> segments = m_crossings.segments;
        std::ranges::stable_sort(segments,
                                 [](const auto& a, const auto& b) { return a.crackTriangle < b.crackTriangle; });
        const std::vector<std::size_t> begins = stretchBegins(true, m_cracks.edges.size());
        FaceSet faces(count, divideAll(true, segments), begins.back());
        joinOverEdges(faces, count, begins, [&](std::size_t t, std::size_t side) { return crackSide(t, side); });
        std::vector<std::uint32_t> where = faces.tags();
        std::optional<WindingNumber> winding;
        for (std::size_t t = 0; t < count; ++t) {
            if (faces.isDivided(t))
                continue;
            std::uint32_t& side = where[faces.find(t)];
            if (side == none) { // a whole crack surface that does not reach the skin
                if (!winding)
                    winding.emplace(m_skin);
                const Triangle corners = crackCorners(t);
                const Vec3 middle = (placeOf(corners[0]) + placeOf(corners[1]) + placeOf(corners[2])) / 3;
                side = winding->at(middle) > 0.5 ? inside : outside;
            }
            if (side == inside)
                addCrack(t, crackCorners(t));
        }
        for (std::size_t i = 0; i < faces.divided().size(); ++i) {
            const FaceSet::Divided& divided = faces.divided()[i];
            if (where[faces.find(faces.numberOf(i))] == inside)
                for (const Triangle& t : trianglesOf(divided, crackCorners(divided.triangle)))
                    addCrack(divided.triangle, t);
        }
    }

    void addCrack(std::size_t crackTriangle, const Triangle& t)
    {
        m_cut.cracks.push_back({t, m_cracks.triangles[crackTriangle].back, m_cracks.triangles[crackTriangle].front});
    }

    const TriangleMesh& m_skin;
    const LabeledNodes& m_nodes;
    HalfEdges m_halfEdges;
    CrackSurface m_cracks;
    SurfaceCrossings m_crossings;
    CutTriangles m_cut;
};

} // namespace

std::vector<SewnMesh> cutByLabels(const TriangleMesh& skin, const LabeledNodes& nodes, const LabelSeams& seams,
                                  std::uint64_t salt, TaskControl& control)
{
    return SurfaceCutter(skin, nodes, salt, control).cut(seams, control);
}

} // namespace knead
