#include "core/geometry/half_edges.h"

#include <algorithm>
#include <numeric>
#include <span>

namespace knead {

namespace {

struct Ends {
    std::uint32_t from;
    std::uint32_t to;

    std::uint32_t low() const { return std::min(from, to); }
    std::uint32_t high() const { return std::max(from, to); }
    bool upward() const { return from < to; }
};

Ends endsOf(const TriangleMesh& mesh, std::uint32_t halfEdge)
{
    const TriangleMesh::Triangle& t = mesh.triangles[halfEdge / 3];
    return {t[halfEdge % 3], t[(halfEdge + 1) % 3]};
}

bool usesVertexTwice(const TriangleMesh::Triangle& t)
{
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

/// Half-edges grouped by the lower of their two vertices.
struct Fans {
    std::vector<std::size_t> first; // per vertex, and the end
    std::vector<std::uint32_t> halfEdges;
};

Fans groupByLowerVertex(const TriangleMesh& mesh)
{
    Fans fans{std::vector<std::size_t>(mesh.vertices.size() + 1, 0), {}};
    const auto forEachHalfEdge = [&](auto&& visit) {
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
            if (usesVertexTwice(mesh.triangles[t]))
                continue;
            for (std::uint32_t i = 0; i < 3; ++i)
                visit(3 * t + i);
        }
    };
    forEachHalfEdge([&](std::uint32_t h) { ++fans.first[endsOf(mesh, h).low() + 1]; });
    std::partial_sum(fans.first.begin(), fans.first.end(), fans.first.begin());
    fans.halfEdges.resize(fans.first.back());
    std::vector<std::size_t> next(fans.first.begin(), fans.first.end() - 1);
    forEachHalfEdge([&](std::uint32_t h) { fans.halfEdges[next[endsOf(mesh, h).low()]++] = h; });
    return fans;
}

} // namespace

HalfEdges findHalfEdges(const TriangleMesh& mesh)
{
    HalfEdges result;
    result.twin.assign(3 * mesh.triangles.size(), HalfEdges::none);
    Fans fans = groupByLowerVertex(mesh);
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        const std::span<std::uint32_t> fan(fans.halfEdges.data() + fans.first[v], fans.first[v + 1] - fans.first[v]);
        std::sort(fan.begin(), fan.end(), [&](std::uint32_t a, std::uint32_t b) {
            const std::uint32_t highA = endsOf(mesh, a).high();
            const std::uint32_t highB = endsOf(mesh, b).high();
            return highA != highB ? highA < highB : a < b;
        });
        for (std::size_t i = 0; i < fan.size();) {
            std::size_t end = i + 1;
            while (end < fan.size() && endsOf(mesh, fan[end]).high() == endsOf(mesh, fan[i]).high())
                ++end;
            const bool pair = end - i == 2 && endsOf(mesh, fan[i]).upward() != endsOf(mesh, fan[i + 1]).upward();
            if (pair) {
                result.twin[fan[i]] = fan[i + 1];
                result.twin[fan[i + 1]] = fan[i];
            } else {
                result.unpaired += end - i;
            }
            i = end;
        }
    }
    return result;
}

} // namespace knead
