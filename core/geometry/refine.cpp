#include "core/geometry/refine.h"

#include "core/message/message.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <unordered_map>

namespace knead {

namespace {

using Triangle = TriangleMesh::Triangle;

// What carries a surface stretches it by no more than this; where it seems to, it jumps there, and splitting does not help.
constexpr double largestStretch = 16;
// Where it jumps along an edge, triangles on it would be split without end. Edges need few passes to be half as long.
constexpr int mostPasses = 16;

/// One pass: every edge that is too long gets a vertex in its middle, shared by its triangles.
class Splitter {
public:
    /// @param places of the vertices, which lengths are of
    /// @param leastEdge of the mesh itself: shorter ones stay
    Splitter(const TriangleMesh& mesh, const std::vector<Vec3>& places, double maximumEdge, double leastEdge)
        : m_mesh(mesh)
        , m_places(places)
        , m_maximumSquared(maximumEdge * maximumEdge)
        , m_leastSquared(leastEdge * leastEdge)
    {
        m_result.vertices = mesh.vertices;
        m_result.triangles.reserve(mesh.triangles.size() * 2);
    }

    bool hasSplit() const { return !m_middle.empty(); }

    TriangleMesh split()
    {
        for (std::size_t t = 0; t < m_mesh.triangles.size(); ++t)
            splitTriangle(t);
        return std::move(m_result);
    }

private:
    std::optional<std::uint32_t> middle(std::uint32_t a, std::uint32_t b)
    {
        if ((m_places[a] - m_places[b]).squaredNorm() <= m_maximumSquared ||
            (m_mesh.vertices[a] - m_mesh.vertices[b]).squaredNorm() < m_leastSquared)
            return std::nullopt;
        const auto next = static_cast<std::uint32_t>(m_result.vertices.size());
        const auto [place, isNew] = m_middle.try_emplace(pairKey(a, b), next);
        if (isNew)
            m_result.vertices.push_back(0.5 * (m_mesh.vertices[a] + m_mesh.vertices[b]));
        return place->second;
    }

    void add(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::size_t parent)
    {
        m_result.triangles.push_back({a, b, c});
        if (!m_mesh.faceOfTriangle.empty())
            m_result.faceOfTriangle.push_back(m_mesh.faceOfTriangle[parent]);
    }

    void splitTriangle(std::size_t t)
    {
        Triangle v = m_mesh.triangles[t];
        std::array<std::optional<std::uint32_t>, 3> m; // m[i] lies between v[i] and v[i+1]
        for (std::size_t i = 0; i < 3; ++i)
            m[i] = middle(v[i], v[(i + 1) % 3]);
        const auto count = std::ranges::count_if(m, [](const auto& x) { return x.has_value(); });
        if (count == 0)
            return add(v[0], v[1], v[2], t);
        if (count == 3) {
            for (std::size_t i = 0; i < 3; ++i)
                add(v[i], *m[i], *m[(i + 2) % 3], t);
            return add(*m[0], *m[1], *m[2], t);
        }
        // Turn until the first edge is split and the last one is not.
        while (!m[0] || m[2]) {
            std::rotate(v.begin(), v.begin() + 1, v.end());
            std::rotate(m.begin(), m.begin() + 1, m.end());
        }
        if (!m[1]) {
            add(v[0], *m[0], v[2], t);
            return add(*m[0], v[1], v[2], t);
        }
        add(*m[0], v[1], *m[1], t);
        splitQuadrangle({v[0], *m[0], *m[1], v[2]}, t);
    }

    /// Along the shorter diagonal, which keeps triangles from becoming slivers.
    void splitQuadrangle(const std::array<std::uint32_t, 4>& q, std::size_t t)
    {
        const auto length = [&](std::size_t i, std::size_t j) {
            return (m_result.vertices[q[i]] - m_result.vertices[q[j]]).squaredNorm();
        };
        if (length(0, 2) <= length(1, 3)) {
            add(q[0], q[1], q[2], t);
            add(q[0], q[2], q[3], t);
        } else {
            add(q[0], q[1], q[3], t);
            add(q[1], q[2], q[3], t);
        }
    }

    const TriangleMesh& m_mesh;
    const std::vector<Vec3>& m_places;
    double m_maximumSquared;
    double m_leastSquared;
    TriangleMesh m_result;
    std::unordered_map<std::uint64_t, std::uint32_t> m_middle;
};

double longestEdge(const TriangleMesh& mesh, const std::vector<Vec3>& places)
{
    double squared = 0;
    for (const Triangle& t : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i)
            squared = std::max(squared, (places[t[i]] - places[t[(i + 1) % 3]]).squaredNorm());
    return std::sqrt(squared);
}

double areaOf(const TriangleMesh& mesh, const std::vector<Vec3>& places)
{
    double area = 0;
    for (const Triangle& t : mesh.triangles)
        area += 0.5 * crossOf(places, t).norm();
    return area;
}

} // namespace

TriangleMesh refine(const TriangleMesh& mesh, double maximumEdge, std::size_t maximumTriangles)
{
    return refineWhereCarried(mesh, maximumEdge, maximumTriangles,
                              [](const std::vector<Vec3>& vertices) -> const std::vector<Vec3>& { return vertices; });
}

TriangleMesh refineWhereCarried(const TriangleMesh& mesh, double maximumEdge, std::size_t maximumTriangles,
                                const std::function<const std::vector<Vec3>&(const std::vector<Vec3>&)>& carry)
{
    assert(maximumEdge > 0);
    const std::vector<Vec3>& places = carry(mesh.vertices);
    // Split triangles have edges around 0.7 of the longest allowed, hence about a quarter of its square as area.
    const double smallestArea = areaOf(mesh, places) / static_cast<double>(maximumTriangles);
    const double edge = std::max(maximumEdge, 2 * std::sqrt(smallestArea));

    // The longest edges first: fewer slivers come of them, and where there may be no more triangles all edges are about as long.
    const std::size_t most = std::max(maximumTriangles, mesh.triangles.size() + maximumTriangles / 2);
    TriangleMesh result = mesh;
    double longest = std::max(edge, longestEdge(mesh, places));
    if (!std::isfinite(longest))
        throw Problem(Message("Filling", "A point of the surface is nowhere."));
    int passes = 0;
    while (result.triangles.size() < most) {
        Splitter splitter(result, carry(result.vertices), std::max(edge, 0.5 * longest), maximumEdge / largestStretch);
        TriangleMesh next = splitter.split();
        if (splitter.hasSplit() && passes < mostPasses) {
            result = std::move(next);
            ++passes;
        } else if (0.5 * longest <= edge) {
            break;
        } else {
            longest *= 0.5;
            passes = 0;
        }
    }
    return result;
}

TriangleMesh halveEdges(const TriangleMesh& mesh)
{
    return Splitter(mesh, mesh.vertices, 0, 0).split();
}

} // namespace knead
