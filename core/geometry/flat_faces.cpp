#include "core/geometry/flat_faces.h"

#include "core/geometry/half_edges.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_set>
#include <utility>

namespace knead {

namespace {

constexpr std::uint32_t noGroup = 0xffffffffU;
constexpr double parallel = 0.9; // cosine of normals in one plane; smaller triangles can be tilted within the tolerance

using TriangleGroup = std::vector<std::uint32_t>;
using EdgeLoop = std::vector<std::uint32_t>; // of half-edges

std::uint32_t following(std::uint32_t halfEdge)
{
    return halfEdge % 3 == 2 ? halfEdge - 2 : halfEdge + 1;
}

/// Which triangles are one face.
class Grouping {
public:
    Grouping(const TriangleMesh& mesh, const HalfEdges& halfEdges, double tolerance)
        : m_mesh(mesh)
        , m_halfEdges(halfEdges)
        , m_tolerance(tolerance)
        , m_group(mesh.triangles.size(), noGroup)
    {
        for (const TriangleMesh::Triangle& t : mesh.triangles)
            m_area.push_back(crossOf(mesh.vertices, t));
        growAll();
        for (std::size_t i = 0; i < m_groups.size(); ++i) // more come while it goes on
            takeMeetingsApart(static_cast<std::uint32_t>(i));
    }

    const std::vector<TriangleGroup>& groups() const { return m_groups; }
    const Vec3& area(std::uint32_t triangle) const { return m_area[triangle]; } ///< twice

    bool isBorder(std::uint32_t halfEdge) const
    {
        const std::uint32_t twin = m_halfEdges.twin[halfEdge];
        return twin == HalfEdges::none || m_group[twin / 3] != m_group[halfEdge / 3];
    }

    std::uint32_t startOf(std::uint32_t halfEdge) const { return m_mesh.triangles[halfEdge / 3][halfEdge % 3]; }
    std::uint32_t endOf(std::uint32_t halfEdge) const { return startOf(following(halfEdge)); }

    /// The borders of a group, each once around.
    std::vector<EdgeLoop> loopsOf(std::uint32_t group) const
    {
        std::vector<EdgeLoop> loops;
        std::unordered_set<std::uint32_t> seen;
        for (const std::uint32_t triangle : m_groups[group])
            for (std::uint32_t h = 3 * triangle; h < 3 * triangle + 3; ++h) {
                if (!isBorder(h) || seen.contains(h))
                    continue;
                EdgeLoop loop;
                for (std::uint32_t at = h; seen.insert(at).second; at = nextOnBorder(at))
                    loop.push_back(at);
                loops.push_back(std::move(loop));
            }
        return loops;
    }

private:
    /// From the largest triangles, whose planes are the surest.
    void growAll()
    {
        TriangleGroup order(m_mesh.triangles.size());
        std::iota(order.begin(), order.end(), 0U);
        std::ranges::stable_sort(order,
                                 [this](auto a, auto b) { return m_area[a].squaredNorm() > m_area[b].squaredNorm(); });
        for (const std::uint32_t seed : order)
            if (m_group[seed] == noGroup)
                grow(seed, [this, seed](std::uint32_t t) { return m_group[t] == noGroup && isInPlane(t, seed); });
    }

    template <typename Accept>
    void grow(std::uint32_t seed, Accept accept)
    {
        const auto number = static_cast<std::uint32_t>(m_groups.size());
        TriangleGroup group{seed};
        m_group[seed] = number;
        for (std::size_t i = 0; i < group.size(); ++i)
            for (std::uint32_t h = 3 * group[i]; h < 3 * group[i] + 3; ++h) {
                const std::uint32_t twin = m_halfEdges.twin[h];
                if (twin == HalfEdges::none || !accept(twin / 3))
                    continue;
                m_group[twin / 3] = number;
                group.push_back(twin / 3);
            }
        m_groups.push_back(std::move(group));
    }

    bool isInPlane(std::uint32_t triangle, std::uint32_t seed) const
    {
        const double size = m_area[seed].norm();
        const std::vector<std::uint32_t>& faces = m_mesh.faceOfTriangle;
        if (m_tolerance <= 0 || size == 0 || (!faces.empty() && faces[triangle] != faces[seed]))
            return false;
        const Vec3 normal = m_area[seed] / size;
        const Vec3& point = m_mesh.vertices[m_mesh.triangles[seed][0]];
        double longest = 0;
        for (std::uint32_t h = 3 * triangle; h < 3 * triangle + 3; ++h) {
            const Vec3& corner = m_mesh.vertices[startOf(h)];
            if (std::abs(normal.dot(corner - point)) > m_tolerance)
                return false;
            longest = std::max(longest, (m_mesh.vertices[endOf(h)] - corner).norm());
        }
        const double along = normal.dot(m_area[triangle]);
        const double all = m_area[triangle].norm();
        const bool isNeedle = all < m_tolerance * longest; // which has no normal that one could trust
        return along >= (isNeedle ? 0 : parallel * all);
    }

    /// Triangles at vertices in which the border of a group meets itself get out of it, and what is left grows again.
    void takeMeetingsApart(std::uint32_t group)
    {
        const std::unordered_set<std::uint32_t> meetings = meetingsOf(group);
        if (meetings.empty())
            return;
        const TriangleGroup all = std::move(m_groups[group]);
        m_groups[group].clear();
        TriangleGroup rest;
        for (const std::uint32_t triangle : all) {
            const TriangleMesh::Triangle& t = m_mesh.triangles[triangle];
            if (std::ranges::any_of(t, [&](std::uint32_t vertex) { return meetings.contains(vertex); }))
                grow(triangle, [](std::uint32_t) { return false; });
            else
                rest.push_back(triangle);
        }
        for (const std::uint32_t seed : rest)
            if (m_group[seed] == group)
                grow(seed, [this, group](std::uint32_t t) { return m_group[t] == group; });
    }

    std::unordered_set<std::uint32_t> meetingsOf(std::uint32_t group) const
    {
        std::unordered_set<std::uint32_t> meetings;
        std::unordered_set<std::uint32_t> seen;
        for (const EdgeLoop& loop : loopsOf(group))
            for (const std::uint32_t halfEdge : loop)
                if (!seen.insert(startOf(halfEdge)).second)
                    meetings.insert(startOf(halfEdge));
        return meetings;
    }

    /// Around the end of a half-edge, through triangles of the group.
    std::uint32_t nextOnBorder(std::uint32_t halfEdge) const
    {
        std::uint32_t next = following(halfEdge);
        while (!isBorder(next))
            next = following(m_halfEdges.twin[next]);
        return next;
    }

    const TriangleMesh& m_mesh;
    const HalfEdges& m_halfEdges;
    double m_tolerance;
    std::vector<Vec3> m_area;
    std::vector<std::uint32_t> m_group;  // of triangles
    std::vector<TriangleGroup> m_groups; // those taken apart are empty
};

/// Which vertices the borders of groups need.
class Borders {
public:
    Borders(const TriangleMesh& mesh, const HalfEdges& halfEdges, const Grouping& grouping, double tolerance)
        : m_mesh(mesh)
        , m_halfEdges(halfEdges)
        , m_grouping(grouping)
        , m_tolerance(tolerance)
        , m_isNeeded(mesh.vertices.size(), 1)
        , m_isSeen(3 * mesh.triangles.size(), 0)
    {
        if (tolerance <= 0)
            return;
        // Borders between two vertices where more than two faces meet first; then those that close upon themselves.
        for (const bool fromNodes : {true, false})
            for (std::uint32_t h = 0; h < m_isSeen.size(); ++h)
                if (m_isSeen[h] == 0 && grouping.isBorder(h) && (!fromNodes || degree(grouping.startOf(h)) != 2))
                    straighten(chainFrom(h));
    }

    bool isNeeded(std::uint32_t vertex) const { return m_isNeeded[vertex] != 0; }
    void need(std::uint32_t vertex) { m_isNeeded[vertex] = 1; }

private:
    std::size_t degree(std::uint32_t vertex) const
    {
        const auto fan = m_halfEdges.leaving(vertex);
        return static_cast<std::size_t>(
            std::ranges::count_if(fan, [this](std::uint32_t h) { return m_grouping.isBorder(h); }));
    }

    void see(std::uint32_t halfEdge)
    {
        m_isSeen[halfEdge] = 1;
        if (m_halfEdges.twin[halfEdge] != HalfEdges::none)
            m_isSeen[m_halfEdges.twin[halfEdge]] = 1;
    }

    /// Vertices along a border, until it meets others or closes.
    std::vector<std::uint32_t> chainFrom(std::uint32_t first)
    {
        std::vector<std::uint32_t> chain{m_grouping.startOf(first)};
        for (std::uint32_t h = first; h != HalfEdges::none;) {
            see(h);
            const std::uint32_t vertex = m_grouping.endOf(h);
            chain.push_back(vertex);
            h = HalfEdges::none;
            if (degree(vertex) == 2)
                for (const std::uint32_t next : m_halfEdges.leaving(vertex))
                    if (m_grouping.isBorder(next) && m_isSeen[next] == 0)
                        h = next;
        }
        return chain;
    }

    void straighten(std::vector<std::uint32_t> chain)
    {
        if (chain.front() == chain.back())
            beginAtCorner(chain);
        std::size_t anchor = 0;
        for (std::size_t i = 1; i + 1 < chain.size(); ++i)
            if (isStraight(chain, anchor, i + 1))
                m_isNeeded[chain[i]] = 0;
            else
                anchor = i;
    }

    /// A closed chain is to begin where it turns most.
    void beginAtCorner(std::vector<std::uint32_t>& chain) const
    {
        chain.pop_back();
        const std::size_t count = chain.size();
        std::size_t corner = 0;
        double least = 2;
        for (std::size_t i = 0; i < count; ++i) {
            const Vec3& at = m_mesh.vertices[chain[i]];
            const Vec3 before = (at - m_mesh.vertices[chain[(i + count - 1) % count]]).normalized();
            const Vec3 after = (m_mesh.vertices[chain[(i + 1) % count]] - at).normalized();
            if (before.dot(after) < least) {
                least = before.dot(after);
                corner = i;
            }
        }
        std::rotate(chain.begin(), chain.begin() + static_cast<std::ptrdiff_t>(corner), chain.end());
        chain.push_back(chain.front());
    }

    /// Whether what lies between two vertices of a chain is on the line between them, one after the other.
    bool isStraight(const std::vector<std::uint32_t>& chain, std::size_t from, std::size_t to) const
    {
        const Vec3& begin = m_mesh.vertices[chain[from]];
        const Vec3 way = m_mesh.vertices[chain[to]] - begin;
        const double length = way.norm();
        double reached = 0;
        for (std::size_t i = from + 1; i < to; ++i) {
            const Vec3 here = m_mesh.vertices[chain[i]] - begin;
            const double along = here.dot(way) / length;
            if (!(along > reached && along < length) || (here - along / length * way).norm() > m_tolerance)
                return false;
            reached = along;
        }
        return length > 0;
    }

    const TriangleMesh& m_mesh;
    const HalfEdges& m_halfEdges;
    const Grouping& m_grouping;
    double m_tolerance;
    std::vector<std::uint8_t> m_isNeeded; // per vertex
    std::vector<std::uint8_t> m_isSeen;   // per half-edge
};

std::vector<std::uint32_t> neededCorners(const EdgeLoop& loop, const Grouping& grouping, const Borders& borders)
{
    std::vector<std::uint32_t> corners;
    for (const std::uint32_t halfEdge : loop)
        if (borders.isNeeded(grouping.startOf(halfEdge)))
            corners.push_back(grouping.startOf(halfEdge));
    return corners;
}

FlatFace faceOf(const TriangleMesh& mesh, const Grouping& grouping, const TriangleGroup& triangles)
{
    FlatFace face;
    face.triangle = triangles.front();
    Vec3 area = Vec3::Zero();
    Vec3 sum = Vec3::Zero();
    double weight = 0;
    for (const std::uint32_t triangle : triangles) {
        const TriangleMesh::Triangle& t = mesh.triangles[triangle];
        const double size = grouping.area(triangle).norm();
        area += grouping.area(triangle);
        sum += size / 3 * (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]);
        weight += size;
    }
    const TriangleMesh::Triangle& first = mesh.triangles[face.triangle];
    const Vec3 side = mesh.vertices[first[1]] - mesh.vertices[first[0]];
    const bool isFlat = area.norm() > 1e-12 * side.squaredNorm();
    face.point = isFlat && triangles.size() > 1 ? Vec3(sum / weight) : mesh.vertices[first[0]];
    face.normal = isFlat ? area.normalized() : side.unitOrthogonal(); // corners in a line: any plane through it will do
    return face;
}

} // namespace

std::vector<FlatFace> flatFaces(const TriangleMesh& mesh, double tolerance)
{
    const HalfEdges halfEdges = findHalfEdges(mesh);
    const Grouping grouping(mesh, halfEdges, tolerance);
    Borders borders(mesh, halfEdges, grouping, tolerance);
    std::vector<FlatFace> faces;
    std::vector<std::vector<EdgeLoop>> loops;
    for (std::uint32_t group = 0; group < grouping.groups().size(); ++group)
        if (!grouping.groups()[group].empty()) {
            faces.push_back(faceOf(mesh, grouping, grouping.groups()[group]));
            loops.push_back(grouping.loopsOf(group));
        }
    // A border that became a line or a point needs all of its vertices, and its neighbors then have them too.
    for (bool isChanged = true; isChanged;) {
        isChanged = false;
        for (const std::vector<EdgeLoop>& all : loops)
            for (const EdgeLoop& loop : all)
                if (const std::size_t left = neededCorners(loop, grouping, borders).size();
                    left < 3 && left < loop.size()) {
                    for (const std::uint32_t halfEdge : loop)
                        borders.need(grouping.startOf(halfEdge));
                    isChanged = true;
                }
    }
    for (std::size_t i = 0; i < faces.size(); ++i)
        for (const EdgeLoop& loop : loops[i])
            faces[i].loops.push_back(neededCorners(loop, grouping, borders));
    return faces;
}

} // namespace knead
