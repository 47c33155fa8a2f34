#include "core/geometry/planar_mesh.h"

#include <cmath>
#include <map>
#include <utility>

namespace knead {

namespace {

using Vec2 = Eigen::Vector2d;

double doubleArea(const Vec2& a, const Vec2& b, const Vec2& c)
{
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// Whether d lies inside the circle through a, b and c, by more than rounding.
bool isInCircle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d)
{
    constexpr double clearly = 1e-10;
    const Vec2 p = a - d;
    const Vec2 q = b - d;
    const Vec2 r = c - d;
    const double one = p.squaredNorm() * (q.x() * r.y() - q.y() * r.x());
    const double two = q.squaredNorm() * (r.x() * p.y() - r.y() * p.x());
    const double three = r.squaredNorm() * (p.x() * q.y() - p.y() * q.x());
    return one + two + three > clearly * (std::abs(one) + std::abs(two) + std::abs(three));
}

} // namespace

PlanarMesh::PlanarMesh(std::vector<Vec2> points, std::vector<Triangle> triangles)
    : m_points(std::move(points))
    , m_triangles(std::move(triangles))
    , m_neighbors(m_triangles.size(), {none, none, none})
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, Side> sides;
    for (std::uint32_t t = 0; t < m_triangles.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i)
            if (const auto [known, isNew] =
                    sides.try_emplace({m_triangles[t][i], m_triangles[t][(i + 1) % 3]}, Side{t, i});
                !isNew)
                known->second.triangle = none; // two triangles on the same side: none of them has a neighbor there
    for (const auto& [ends, side] : sides)
        if (const auto other = sides.find({ends.second, ends.first});
            side.triangle != none && other != sides.end() && other->second.triangle != none)
            m_neighbors[side.triangle][side.side] = other->second.triangle;
}

double PlanarMesh::turnOf(std::uint32_t triangle) const
{
    const Triangle& t = m_triangles[triangle];
    return doubleArea(m_points[t[0]], m_points[t[1]], m_points[t[2]]);
}

std::size_t PlanarMesh::sideFrom(std::uint32_t triangle, std::uint32_t from, std::uint32_t to) const
{
    const Triangle& t = m_triangles[triangle];
    return t[0] == from && t[1] == to ? 0 : t[1] == from && t[2] == to ? 1 : 2;
}

/// Makes what lies beyond a side know the triangle.
void PlanarMesh::tellNeighbor(std::uint32_t triangle, std::size_t side)
{
    const std::uint32_t neighbor = m_neighbors[triangle][side];
    if (neighbor != none)
        m_neighbors[neighbor][sideFrom(neighbor, m_triangles[triangle][(side + 1) % 3], m_triangles[triangle][side])] =
            triangle;
}

std::vector<std::uint32_t> PlanarMesh::addInside(std::uint32_t triangle)
{
    const auto [a, b, c] = m_triangles[triangle];
    const auto [beyondA, beyondB, beyondC] = m_neighbors[triangle];
    const auto point = static_cast<std::uint32_t>(m_points.size());
    m_points.emplace_back((m_points[a] + m_points[b] + m_points[c]) / 3);
    const auto second = static_cast<std::uint32_t>(m_triangles.size());
    const std::uint32_t third = second + 1;
    m_triangles[triangle] = {a, b, point};
    m_neighbors[triangle] = {beyondA, second, third};
    m_triangles.push_back({b, c, point});
    m_neighbors.push_back({beyondB, third, triangle});
    m_triangles.push_back({c, a, point});
    m_neighbors.push_back({beyondC, triangle, second});
    tellNeighbor(second, 0);
    tellNeighbor(third, 0);
    return settle({triangle, second, third}, {{triangle, 0}, {second, 0}, {third, 0}});
}

PlanarMesh::Pair PlanarMesh::pairAt(std::uint32_t triangle, std::size_t side) const
{
    const std::uint32_t other = m_neighbors[triangle][side];
    const std::uint32_t a = m_triangles[triangle][side];
    const std::uint32_t b = m_triangles[triangle][(side + 1) % 3];
    const std::size_t otherSide = sideFrom(other, b, a);
    return {.other = other,
            .a = a,
            .b = b,
            .c = m_triangles[triangle][(side + 2) % 3],
            .d = m_triangles[other][(otherSide + 2) % 3],
            .beyondBc = m_neighbors[triangle][(side + 1) % 3],
            .beyondCa = m_neighbors[triangle][(side + 2) % 3],
            .beyondAd = m_neighbors[other][(otherSide + 1) % 3],
            .beyondDb = m_neighbors[other][(otherSide + 2) % 3]};
}

std::vector<std::uint32_t> PlanarMesh::addOnSide(std::uint32_t triangle, std::size_t side)
{
    const auto [other, a, b, c, d, beyondBc, beyondCa, beyondAd, beyondDb] = pairAt(triangle, side);
    const auto point = static_cast<std::uint32_t>(m_points.size());
    m_points.emplace_back(0.5 * (m_points[a] + m_points[b]));
    const auto third = static_cast<std::uint32_t>(m_triangles.size());
    const std::uint32_t fourth = third + 1;
    m_triangles[triangle] = {b, c, point};
    m_neighbors[triangle] = {beyondBc, third, fourth};
    m_triangles[other] = {a, d, point};
    m_neighbors[other] = {beyondAd, fourth, third};
    m_triangles.push_back({c, a, point});
    m_neighbors.push_back({beyondCa, other, triangle});
    m_triangles.push_back({d, b, point});
    m_neighbors.push_back({beyondDb, triangle, other});
    tellNeighbor(third, 0);
    tellNeighbor(fourth, 0);
    return settle({triangle, other, third, fourth}, {{triangle, 0}, {other, 0}, {third, 0}, {fourth, 0}});
}

/// Flips sides opposite to a new point, the last corner of the triangles there, until all are Delaunay.
std::vector<std::uint32_t> PlanarMesh::settle(std::vector<std::uint32_t> changed, std::vector<Side> outer)
{
    while (!outer.empty()) {
        const auto [triangle, side] = outer.back();
        outer.pop_back();
        if (!shouldFlip(triangle, side))
            continue;
        const std::uint32_t other = m_neighbors[triangle][side];
        flip(triangle, side);
        changed.push_back(other);
        outer.push_back({triangle, 0});
        outer.push_back({other, 0});
    }
    return changed;
}

bool PlanarMesh::shouldFlip(std::uint32_t triangle, std::size_t side) const
{
    const std::uint32_t other = m_neighbors[triangle][side];
    if (other == none)
        return false;
    const std::uint32_t from = m_triangles[triangle][side];
    const std::uint32_t to = m_triangles[triangle][(side + 1) % 3];
    const Vec2& a = m_points[from];
    const Vec2& b = m_points[to];
    const Vec2& c = m_points[m_triangles[triangle][(side + 2) % 3]];
    const Vec2& d = m_points[m_triangles[other][(sideFrom(other, to, from) + 2) % 3]];
    return doubleArea(a, d, c) > 0 && doubleArea(d, b, c) > 0 && isInCircle(a, b, c, d);
}

/// Afterwards the point opposite to the side is the last corner of both triangles.
void PlanarMesh::flip(std::uint32_t triangle, std::size_t side)
{
    const auto [other, a, b, c, d, beyondBc, beyondCa, beyondAd, beyondDb] = pairAt(triangle, side);
    m_triangles[triangle] = {a, d, c};
    m_neighbors[triangle] = {beyondAd, other, beyondCa};
    m_triangles[other] = {d, b, c};
    m_neighbors[other] = {beyondDb, beyondBc, triangle};
    tellNeighbor(triangle, 0);
    tellNeighbor(other, 1);
}

} // namespace knead
