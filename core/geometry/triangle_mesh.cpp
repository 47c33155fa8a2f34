#include "core/geometry/triangle_mesh.h"

#include "core/geometry/disjoint_sets.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace knead {

namespace {

/// A hash grid of vertices. Cells are several tolerances wide, so that most look-ups touch one cell only.
/// Chains may hold vertices of other cells with the same hash: the distance decides anyway.
class VertexGrid {
public:
    VertexGrid(const std::vector<Vec3>& vertices, double tolerance)
        : m_vertices(vertices)
        , m_head(std::bit_ceil(2 * vertices.size() + 1), none)
        , m_next(vertices.size(), none)
    {
        const Box box = boxOfPlaces(vertices);
        m_origin = box.min();
        m_cell = std::max({8 * tolerance, 1e-9 * box.diagonal().norm(), 1e-300});
    }

    void insert(std::uint32_t v)
    {
        const Cell cell = cellOf(m_vertices[v]);
        std::uint32_t& head = m_head[hash(cell)];
        m_next[v] = head;
        head = v;
    }

    template <typename Visit>
    void forEachWithin(const Vec3& place, double radius, Visit&& visit) const
    {
        const Cell low = cellOf(place - Vec3::Constant(radius));
        const Cell high = cellOf(place + Vec3::Constant(radius));
        for (std::int64_t x = low[0]; x <= high[0]; ++x)
            for (std::int64_t y = low[1]; y <= high[1]; ++y)
                for (std::int64_t z = low[2]; z <= high[2]; ++z)
                    for (std::uint32_t v = m_head[hash({x, y, z})]; v != none; v = m_next[v])
                        if ((m_vertices[v] - place).squaredNorm() <= radius * radius)
                            visit(v);
    }

private:
    using Cell = std::array<std::int64_t, 3>;
    static constexpr std::uint32_t none = 0xffffffffU;

    Cell cellOf(const Vec3& place) const
    {
        const Vec3 scaled = (place - m_origin) / m_cell;
        return {static_cast<std::int64_t>(std::floor(scaled.x())), static_cast<std::int64_t>(std::floor(scaled.y())),
                static_cast<std::int64_t>(std::floor(scaled.z()))};
    }

    std::size_t hash(const Cell& cell) const
    {
        std::uint64_t h = 0;
        for (const std::int64_t c : cell) {
            h = (h ^ static_cast<std::uint64_t>(c)) * 0x9e3779b97f4a7c15ULL;
            h ^= h >> 29;
        }
        return h & (m_head.size() - 1);
    }

    const std::vector<Vec3>& m_vertices;
    std::vector<std::uint32_t> m_head;
    std::vector<std::uint32_t> m_next;
    Vec3 m_origin = Vec3::Zero();
    double m_cell = 1;
};

/// The lowest vertex of a set stands for it.
DisjointSets joinCloseVertices(const std::vector<Vec3>& vertices, double tolerance)
{
    DisjointSets sets(vertices.size());
    VertexGrid grid(vertices, tolerance);
    for (std::uint32_t v = 0; v < vertices.size(); ++v) {
        bool isCopy = false; // a vertex at the very place of an earlier one finds nothing that one did not
        grid.forEachWithin(vertices[v], tolerance, [&](std::uint32_t other) {
            sets.joinToLowest(v, other);
            isCopy = isCopy || vertices[other] == vertices[v];
        });
        if (!isCopy)
            grid.insert(v);
    }
    return sets;
}

} // namespace

TriangleMesh weld(const TriangleMesh& mesh, double tolerance)
{
    DisjointSets sets = joinCloseVertices(mesh.vertices, tolerance);
    TriangleMesh result;
    std::vector<std::uint32_t> place(mesh.vertices.size());
    for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
        const std::size_t first = sets.find(v);
        if (first == v) {
            place[v] = static_cast<std::uint32_t>(result.vertices.size());
            result.vertices.push_back(mesh.vertices[v]);
        } else {
            place[v] = place[first];
        }
    }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const TriangleMesh::Triangle& old = mesh.triangles[t];
        const TriangleMesh::Triangle triangle{place[old[0]], place[old[1]], place[old[2]]};
        if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0])
            continue;
        result.triangles.push_back(triangle);
        if (!mesh.faceOfTriangle.empty())
            result.faceOfTriangle.push_back(mesh.faceOfTriangle[t]);
    }
    return result;
}

} // namespace knead
