#include "core/skin/crossings.h"

#include "core/aggregate/surface_cells.h"
#include "core/geometry/exact_orientation.h"
#include "core/task/parallel_progress.h"

#include <algorithm>
#include <array>
#include <tuple>

namespace knead {

namespace {

using Place = ExactOrientation::Place;
using Point = SurfaceCrossings::Point;

constexpr double margin = 1e-3; // [cells], well above the jitter of the cracks
constexpr std::size_t trianglesPerBlock = 1024;

/// Where two triangles cross, between two points.
struct Found {
    std::uint32_t skinTriangle;
    std::uint32_t crackTriangle;
    Point start;
    Point end;
};

auto keyOf(const Point& point)
{
    return std::tuple(point.isOnCrack, point.edge, point.along, point.triangle);
}

int signOf(double value)
{
    return value > 0 ? 1 : value < 0 ? -1 : 0;
}

/// Whether the line from p to q passes through the triangle between its edges.
bool passesThrough(const Place& p, const Place& q, const std::array<Place, 3>& triangle)
{
    const int first = signOf(ExactOrientation::sixVolumes(p, q, triangle[0], triangle[1]));
    const int second = signOf(ExactOrientation::sixVolumes(p, q, triangle[1], triangle[2]));
    const int third = signOf(ExactOrientation::sixVolumes(p, q, triangle[2], triangle[0]));
    if (first * second < 0 || first * third < 0 || second * third < 0)
        return false;
    if (first * second * third == 0)
        throw DegenerateCut();
    return true;
}

/// Corners of a triangle on either side of a plane; three equal signs: it does not cross it.
struct Sides {
    std::array<double, 3> height{}; // six volumes
    bool isFlat = false;            // the plane is that of a triangle without area

    bool crosses() const
    {
        return isFlat || !(signOf(height[0]) == signOf(height[1]) && signOf(height[1]) == signOf(height[2]));
    }
};

Sides sidesOf(const std::array<Place, 3>& plane, const std::array<Place, 3>& corners)
{
    Sides sides;
    for (std::size_t i = 0; i < 3; ++i)
        sides.height[i] = ExactOrientation::sixVolumes(plane[0], plane[1], plane[2], corners[i]);
    const auto zeros = std::ranges::count(sides.height, 0.0);
    sides.isFlat = zeros == 3;
    if (zeros == 1 || zeros == 2)
        throw DegenerateCut();
    return sides;
}

class Finder {
public:
    Finder(const TriangleMesh& skin, const HalfEdges& halfEdges, const CrackSurface& cracks, const Lattice& frame)
        : m_skin(skin)
        , m_halfEdges(halfEdges)
        , m_cracks(cracks)
        , m_frame(frame)
        , m_orientation(boxOfPlaces(skin.vertices).merged(boxOfPlaces(cracks.vertices)))
    {
        for (const Vec3& vertex : skin.vertices)
            m_skinPlaces.push_back(m_orientation.rounded(vertex));
        for (const Vec3& vertex : cracks.vertices)
            m_crackPlaces.push_back(m_orientation.rounded(vertex));
        for (const CrackSurface::Cell& cell : cracks.cells)
            m_cells.extend(Eigen::Vector3i(cell.lowest[0], cell.lowest[1], cell.lowest[2]));
    }

    void findOf(std::uint32_t skinTriangle, std::vector<Found>& found) const
    {
        std::array<Vec3, 3> corners;
        Eigen::AlignedBox3d box;
        for (std::size_t i = 0; i < 3; ++i) {
            corners[i] = m_frame.coordinates(m_skin.vertices[m_skin.triangles[skinTriangle][i]]);
            box.extend(corners[i]);
        }
        if (m_cells.isEmpty() || ((box.min().array() - margin) > (m_cells.max().cast<double>().array() + 1)).any() ||
            ((box.max().array() + margin) < m_cells.min().cast<double>().array()).any())
            return;
        forEachTouchedCell(corners, margin, [&](const Lattice::Node& lowest) {
            const auto cell = std::lower_bound(
                m_cracks.cells.begin(), m_cracks.cells.end(), lowest,
                [](const CrackSurface::Cell& c, const Lattice::Node& wanted) { return c.lowest < wanted; });
            if (cell == m_cracks.cells.end() || cell->lowest != lowest)
                return;
            for (std::uint32_t crack = cell->begin; crack < cell->end; ++crack)
                findPair(skinTriangle, crack, found);
        });
    }

private:
    void findPair(std::uint32_t skinTriangle, std::uint32_t crackTriangle, std::vector<Found>& found) const
    {
        const TriangleMesh::Triangle& skinCorners = m_skin.triangles[skinTriangle];
        const CrackSurface::Triangle& crack = m_cracks.triangles[crackTriangle];
        std::array<Place, 3> skin{};
        std::array<Place, 3> other{};
        for (std::size_t i = 0; i < 3; ++i) {
            skin[i] = m_skinPlaces[skinCorners[i]];
            other[i] = m_crackPlaces[crack.corners[i]];
        }
        const Sides ofSkin = sidesOf(other, skin);
        if (ofSkin.isFlat)
            throw DegenerateCut();
        if (!ofSkin.crosses())
            return;
        const Sides ofCrack = sidesOf(skin, other);
        if (!ofCrack.crosses())
            return;

        Found pair{.skinTriangle = skinTriangle, .crackTriangle = crackTriangle, .start = {}, .end = {}};
        int starts = 0;
        int ends = 0;
        const auto add = [&](bool isStart, const Point& point) {
            (isStart ? pair.start : pair.end) = point;
            (isStart ? starts : ends) += 1;
        };
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3;
            // An edge of the surface that passes to the front has the triangle, and so the segment, to its left.
            if (signOf(ofSkin.height[i]) != signOf(ofSkin.height[j]) && passesThrough(skin[i], skin[j], other))
                add(ofSkin.height[i] < 0, onSkinEdge(3 * skinTriangle + static_cast<std::uint32_t>(i), crackTriangle));
            // An edge of the crack that passes outwards has the end of the segment to its left.
            if (signOf(ofCrack.height[i]) != signOf(ofCrack.height[j]) && passesThrough(other[i], other[j], skin))
                add(ofCrack.height[i] > 0, onCrackEdge(crack.edges[i], skinTriangle));
        }
        if (starts == 0 && ends == 0)
            return;
        if (starts != 1 || ends != 1)
            throw DegenerateCut();
        found.push_back(pair);
    }

    /// Of the edge as it is named, so that both of its triangles find the same bits.
    Point onSkinEdge(std::uint32_t halfEdge, std::uint32_t crackTriangle) const
    {
        const std::uint32_t edge = edgeOf(m_halfEdges, halfEdge);
        const TriangleMesh::Triangle& corners = m_skin.triangles[edge / 3];
        const std::uint32_t from = corners[edge % 3];
        const std::uint32_t to = corners[(edge % 3 + 1) % 3];
        return pointOf(false, edge, crackTriangle, m_skin.vertices[from], m_skin.vertices[to], m_skinPlaces[from],
                       m_skinPlaces[to], placesOf(m_cracks.triangles[crackTriangle].corners, m_crackPlaces));
    }

    Point onCrackEdge(std::uint32_t edge, std::uint32_t skinTriangle) const
    {
        const auto [from, to] = m_cracks.edges[edge];
        return pointOf(true, edge, skinTriangle, m_cracks.vertices[from], m_cracks.vertices[to], m_crackPlaces[from],
                       m_crackPlaces[to], placesOf(m_skin.triangles[skinTriangle], m_skinPlaces));
    }

    static std::array<Place, 3> placesOf(const std::array<std::uint32_t, 3>& corners, const std::vector<Place>& places)
    {
        return {places[corners[0]], places[corners[1]], places[corners[2]]};
    }

    static Point pointOf(bool isOnCrack, std::uint32_t edge, std::uint32_t triangle, const Vec3& from, const Vec3& to,
                         const Place& fromPlace, const Place& toPlace, const std::array<Place, 3>& plane)
    {
        const double before = ExactOrientation::sixVolumes(plane[0], plane[1], plane[2], fromPlace);
        const double behind = ExactOrientation::sixVolumes(plane[0], plane[1], plane[2], toPlace);
        const double along = before / (before - behind);
        return {isOnCrack, edge, along, triangle, from + along * (to - from)};
    }

    const TriangleMesh& m_skin;
    const HalfEdges& m_halfEdges;
    const CrackSurface& m_cracks;
    const Lattice& m_frame;
    ExactOrientation m_orientation;
    std::vector<Place> m_skinPlaces;
    std::vector<Place> m_crackPlaces;
    Eigen::AlignedBox3i m_cells; // with cracks in them
};

} // namespace

SurfaceCrossings::Range SurfaceCrossings::on(bool isOnCrack, std::uint32_t edge) const
{
    const auto wanted = std::pair(isOnCrack, edge);
    const auto begin = std::lower_bound(points.begin(), points.end(), wanted, [](const Point& p, const auto& w) {
        return std::pair(p.isOnCrack, p.edge) < w;
    });
    auto end = begin;
    while (end != points.end() && std::pair(end->isOnCrack, end->edge) == wanted)
        ++end;
    return {static_cast<std::uint32_t>(begin - points.begin()), static_cast<std::uint32_t>(end - points.begin())};
}

SurfaceCrossings findCrossings(const TriangleMesh& skin, const HalfEdges& halfEdges, const CrackSurface& cracks,
                               const Lattice& frame, TaskControl& control)
{
    const Finder finder(skin, halfEdges, cracks, frame);
    const std::size_t count = skin.triangles.size();
    std::vector<std::vector<Found>> blocks((count + trianglesPerBlock - 1) / trianglesPerBlock);
    forEachBlock(count, trianglesPerBlock, control, "cutting the surface", [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t)
            finder.findOf(static_cast<std::uint32_t>(t), blocks[begin / trianglesPerBlock]);
    });

    SurfaceCrossings crossings;
    for (const std::vector<Found>& block : blocks)
        for (const Found& found : block) {
            crossings.points.push_back(found.start);
            crossings.points.push_back(found.end);
        }
    std::vector<Point>& points = crossings.points;
    std::ranges::sort(points, [](const Point& a, const Point& b) { return keyOf(a) < keyOf(b); });
    points.erase(
        std::unique(points.begin(), points.end(), [](const Point& a, const Point& b) { return keyOf(a) == keyOf(b); }),
        points.end());
    const auto numberOf = [&](const Point& point) {
        const auto found = std::lower_bound(points.begin(), points.end(), point,
                                            [](const Point& a, const Point& b) { return keyOf(a) < keyOf(b); });
        return static_cast<std::uint32_t>(found - points.begin());
    };
    for (const std::vector<Found>& block : blocks)
        for (const Found& found : block)
            crossings.segments.push_back(
                {found.skinTriangle, found.crackTriangle, numberOf(found.start), numberOf(found.end)});
    std::ranges::sort(crossings.segments, [](const auto& a, const auto& b) {
        return std::pair(a.skinTriangle, a.crackTriangle) < std::pair(b.skinTriangle, b.crackTriangle);
    });
    return crossings;
}

} // namespace knead
