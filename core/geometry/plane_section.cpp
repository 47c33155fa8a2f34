#include "core/geometry/plane_section.h"

#include "core/geometry/polygon_triangulation.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

namespace knead {

namespace {

using Vec2 = Eigen::Vector2d;
using Loop = std::vector<Vec2>;

constexpr std::uint32_t noFace = 0xffffffffU;
constexpr double crossingDistance = 1e-12; // of the size: corners so near to each other are one

/// The sides of the outline, from crossing to crossing. A crossing belongs to an edge of the surface, so that triangles that
/// share it agree on it.
class PlaneCrossings {
public:
    PlaneCrossings(std::span<const Vec3> places, const CutPlane& plane, const Mat3& frame)
        : m_places(places)
        , m_plane(plane)
        , m_frame(frame)
    {
    }

    void add(const TriangleMesh::Triangle& t)
    {
        const std::array<bool, 3> isOff{isCutOff(t[0]), isCutOff(t[1]), isCutOff(t[2])};
        const int count = isOff[0] + isOff[1] + isOff[2];
        if (count == 0 || count == 3)
            return;
        const bool lonelyIsOff = count == 1;
        std::size_t lonely = 0; // the corner that is alone on its side
        while (isOff[lonely] != lonelyIsOff)
            ++lonely;
        const std::uint32_t onwards = crossing(t[lonely], t[(lonely + 1) % 3]);
        const std::uint32_t back = crossing(t[lonely], t[(lonely + 2) % 3]);
        if (lonelyIsOff)
            m_sides.emplace_back(onwards, back);
        else
            m_sides.emplace_back(back, onwards);
    }

    /// The sides one after the other.
    std::vector<Loop> loops()
    {
        std::ranges::sort(m_sides);
        std::vector<bool> isUsed(m_sides.size(), false);
        std::vector<Loop> loops;
        for (std::size_t first = 0; first < m_sides.size(); ++first) {
            Loop loop;
            for (std::size_t side = first; side < m_sides.size() && !isUsed[side]; side = sideFrom(side, isUsed)) {
                isUsed[side] = true;
                loop.push_back(m_points[m_sides[side].first]);
            }
            if (loop.size() >= 3)
                loops.push_back(std::move(loop));
        }
        return loops;
    }

private:
    bool isCutOff(std::uint32_t vertex) const { return m_plane.distance(m_places[vertex]) >= 0; }

    std::uint32_t crossing(std::uint32_t a, std::uint32_t b)
    {
        if (b < a)
            std::swap(a, b);
        const auto [known, isNew] =
            m_crossings.try_emplace(std::uint64_t{a} << 32U | b, static_cast<std::uint32_t>(m_points.size()));
        if (isNew) {
            const double before = m_plane.distance(m_places[a]);
            const double after = m_plane.distance(m_places[b]);
            const Vec3 place = m_places[a] + before / (before - after) * (m_places[b] - m_places[a]);
            m_points.emplace_back((m_frame.transpose() * place).head<2>());
        }
        return known->second;
    }

    /// The side that goes on from the end of one; none: m_sides.size().
    std::size_t sideFrom(std::size_t side, const std::vector<bool>& isUsed) const
    {
        const std::uint32_t end = m_sides[side].second;
        auto next = std::lower_bound(m_sides.begin(), m_sides.end(), std::pair(end, std::uint32_t{0}));
        for (; next != m_sides.end() && next->first == end; ++next)
            if (const auto place = static_cast<std::size_t>(next - m_sides.begin()); !isUsed[place])
                return place;
        return m_sides.size();
    }

    std::span<const Vec3> m_places;
    const CutPlane& m_plane;
    const Mat3& m_frame;
    std::unordered_map<std::uint64_t, std::uint32_t> m_crossings; ///< by edge, the lower vertex first
    std::vector<Vec2> m_points;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> m_sides;
};

double twiceArea(const Loop& loop)
{
    double sum = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec2& a = loop[i];
        const Vec2& b = loop[(i + 1) % loop.size()];
        sum += a.x() * b.y() - a.y() * b.x();
    }
    return sum;
}

double distanceFromLine(const Vec2& point, const Vec2& a, const Vec2& b)
{
    const Vec2 way = b - a;
    const double length = way.norm();
    const Vec2 from = point - a;
    return length > 0 ? std::abs(way.x() * from.y() - way.y() * from.x()) / length : from.norm();
}

/// Whether all corners between two lie on the straight way between these.
bool isStraight(const Loop& loop, std::size_t from, std::size_t to, double tolerance)
{
    for (std::size_t i = from + 1; i < to; ++i)
        if (distanceFromLine(loop[i], loop[from], loop[to]) > tolerance)
            return false;
    return true;
}

/// Without corners that say nothing: a flat face of many triangles gives many on one line.
Loop simplified(Loop loop, double tolerance)
{
    constexpr std::size_t longest = 64; // corners that are left out at a time: keeps it linear
    const auto first = std::ranges::max_element(loop, [](const Vec2& a, const Vec2& b) {
        return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y()); // certainly a corner
    });
    std::rotate(loop.begin(), first, loop.end());
    loop.push_back(loop.front());
    Loop kept{loop.front()};
    std::size_t from = 0;
    for (std::size_t to = 2; to < loop.size(); ++to)
        if (to - from > longest || !isStraight(loop, from, to, tolerance)) {
            from = to - 1;
            kept.push_back(loop[from]);
        }
    return kept;
}

bool isInside(const Loop& loop, const Vec2& point)
{
    bool inside = false;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec2& a = loop[i];
        const Vec2& b = loop[(i + 1) % loop.size()];
        if ((a.y() > point.y()) != (b.y() > point.y()) &&
            point.x() < a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
            inside = !inside;
    }
    return inside;
}

/// The loops of each connected face: the outline, then its holes.
std::vector<std::vector<const Loop*>> facesOf(const std::vector<Loop>& loops, const std::vector<double>& areas)
{
    std::vector<std::vector<const Loop*>> faces;
    std::vector<std::size_t> faceOf(loops.size(), noFace);
    for (std::size_t i = 0; i < loops.size(); ++i)
        if (areas[i] > 0) {
            faceOf[i] = faces.size();
            faces.push_back({&loops[i]});
        }
    for (std::size_t hole = 0; hole < loops.size(); ++hole) {
        if (areas[hole] >= 0)
            continue;
        std::size_t around = loops.size();
        for (std::size_t i = 0; i < loops.size(); ++i)
            if (areas[i] > -areas[hole] && isInside(loops[i], loops[hole].front()) &&
                (around == loops.size() || areas[i] < areas[around]))
                around = i;
        if (around < loops.size())
            faces[faceOf[around]].push_back(&loops[hole]);
    }
    return faces;
}

void addFace(PlaneSection& section, const std::vector<const Loop*>& loops, const Mat3& frame, double offset)
{
    std::vector<Vec2> corners;
    std::vector<std::size_t> ends;
    for (const Loop* loop : loops) {
        corners.insert(corners.end(), loop->begin(), loop->end());
        ends.push_back(corners.size());
    }
    const auto first = static_cast<std::uint32_t>(section.points.size());
    for (const Vec2& corner : corners)
        section.points.emplace_back(frame * Vec3(corner.x(), corner.y(), offset));
    for (const auto& t : triangulate(corners, ends))
        section.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    std::size_t begin = 0;
    for (const std::size_t end : ends) {
        for (std::size_t i = begin; i < end; ++i)
            section.outline.push_back({first + static_cast<std::uint32_t>(i),
                                       first + static_cast<std::uint32_t>(i + 1 < end ? i + 1 : begin)});
        begin = end;
    }
}

} // namespace

double PlaneSection::area() const
{
    Vec3 sum = Vec3::Zero();
    for (const auto& t : triangles)
        sum += crossOf(points, t);
    return sum.norm() / 2;
}

Mat3 frameOf(const CutPlane& plane)
{
    const Vec3& n = plane.normal;
    const Vec3 up = std::abs(n.z()) < 0.9 ? Vec3::UnitZ() : Vec3::UnitY();
    Mat3 frame;
    frame.col(2) = n;
    frame.col(0) = up.cross(n).normalized();
    frame.col(1) = n.cross(frame.col(0));
    return frame;
}

PlaneSection planeSection(std::span<const Vec3> places, std::span<const TriangleMesh::Triangle> triangles,
                          const CutPlane& plane, double tolerance)
{
    const Mat3 frame = frameOf(plane);
    PlaneCrossings crossings(places, plane, frame);
    for (const TriangleMesh::Triangle& triangle : triangles)
        crossings.add(triangle);
    std::vector<Loop> loops;
    std::vector<double> areas;
    for (Loop& loop : crossings.loops()) {
        const double reach = loop.front().norm() + (loop[loop.size() / 2] - loop.front()).norm();
        Loop simple = simplified(std::move(loop), std::max(tolerance, crossingDistance * reach));
        if (simple.size() < 3)
            continue;
        areas.push_back(twiceArea(simple));
        loops.push_back(std::move(simple));
    }
    PlaneSection section;
    for (const auto& face : facesOf(loops, areas))
        addFace(section, face, frame, plane.offset);
    return section;
}

} // namespace knead
