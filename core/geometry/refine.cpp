#include "core/geometry/refine.h"

#include "core/message/message.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <optional>

namespace knead {

namespace {

using Triangle = TriangleMesh::Triangle;

// What carries a surface stretches it by no more than this; where it seems to, it jumps there, and splitting does not help.
constexpr double largestStretch = 16;
// Where it jumps along an edge, triangles on it would be split without end. Edges need few passes to be half as long.
constexpr int mostPasses = 16;

/// Numbers by pairs of others, of which no more than `most` come, and most of them twice. Open addressing: refining does hardly more than
/// ask.
class NumberOfPair {
public:
    explicit NumberOfPair(std::size_t most)
        : m_slots(std::bit_ceil(most + most / 4 + 1))
    {
    }

    /// @return that of the pair, and whether it is the one that is offered here
    std::pair<std::uint32_t, bool> find(std::uint64_t key, std::uint32_t offered)
    {
        constexpr std::uint64_t spread = 0x9e3779b97f4a7c15U; // 2^64 by the golden ratio
        const std::size_t mask = m_slots.size() - 1;
        std::size_t slot = (key * spread >> 32U) & mask;
        while (m_slots[slot].key != none && m_slots[slot].key != key)
            slot = (slot + 1) & mask;
        const bool isNew = m_slots[slot].key == none;
        if (isNew)
            m_slots[slot] = {key, offered};
        return {m_slots[slot].number, isNew};
    }

private:
    static constexpr std::uint64_t none = ~std::uint64_t{0};
    struct Slot {
        std::uint64_t key = none;
        std::uint32_t number = 0;
    };
    std::vector<Slot> m_slots;
};

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
        for (const Triangle& v : mesh.triangles)
            for (std::size_t i = 0; i < 3; ++i)
                m_longEdges += isLong(v[i], v[(i + 1) % 3]) ? 1 : 0;
    }

    bool splits() const { return m_longEdges > 0; }

    TriangleMesh split()
    {
        m_middle = NumberOfPair(m_longEdges);
        m_result.vertices.reserve(m_mesh.vertices.size() + m_longEdges / 2);
        m_result.vertices = m_mesh.vertices;
        m_result.triangles.reserve(m_mesh.triangles.size() + m_longEdges);
        if (!m_mesh.faceOfTriangle.empty())
            m_result.faceOfTriangle.reserve(m_mesh.triangles.size() + m_longEdges);
        for (std::size_t t = 0; t < m_mesh.triangles.size(); ++t)
            splitTriangle(t);
        return std::move(m_result);
    }

private:
    bool isLong(std::uint32_t a, std::uint32_t b) const
    {
        return !((m_places[a] - m_places[b]).squaredNorm() <= m_maximumSquared ||
                 (m_mesh.vertices[a] - m_mesh.vertices[b]).squaredNorm() < m_leastSquared);
    }

    std::optional<std::uint32_t> middle(std::uint32_t a, std::uint32_t b)
    {
        if (!isLong(a, b))
            return std::nullopt;
        const auto next = static_cast<std::uint32_t>(m_result.vertices.size());
        const auto [number, isNew] = m_middle.find(pairKey(a, b), next);
        if (isNew)
            m_result.vertices.push_back(0.5 * (m_mesh.vertices[a] + m_mesh.vertices[b]));
        return number;
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
    std::size_t m_longEdges = 0; ///< once for each triangle on them
    TriangleMesh m_result;
    NumberOfPair m_middle{0}; ///< of the new vertices, by the ends of their edges
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
        if (splitter.splits() && passes < mostPasses) {
            result = splitter.split();
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
