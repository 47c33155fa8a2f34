#include "core/geometry/half_edges.h"

#include "core/task/block_sums.h"

#include <algorithm>
#include <numeric>

namespace knead {

namespace {

constexpr std::size_t verticesPerBlock = 8192;

bool usesVertexTwice(const TriangleMesh::Triangle& t)
{
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

std::uint32_t endOf(const TriangleMesh& mesh, std::uint32_t halfEdge)
{
    return mesh.triangles[halfEdge / 3][(halfEdge + 1) % 3];
}

/// Fans in the order of the half-edges' numbers.
void gatherFans(const TriangleMesh& mesh, HalfEdges& result)
{
    const auto forEachHalfEdge = [&](auto&& visit) {
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
            const TriangleMesh::Triangle& triangle = mesh.triangles[t];
            if (usesVertexTwice(triangle))
                continue;
            for (std::uint32_t i = 0; i < 3; ++i)
                visit(3 * t + i, triangle[i]);
        }
    };
    result.fanBegin.assign(mesh.vertices.size() + 1, 0);
    forEachHalfEdge([&](std::uint32_t, std::uint32_t from) { ++result.fanBegin[from + 1]; });
    std::partial_sum(result.fanBegin.begin(), result.fanBegin.end(), result.fanBegin.begin());
    result.fans.resize(result.fanBegin.back());
    std::vector<std::uint32_t> next(result.fanBegin.begin(), result.fanBegin.end() - 1);
    forEachHalfEdge([&](std::uint32_t h, std::uint32_t from) { result.fans[next[from]++] = h; });
}

void sortFans(const TriangleMesh& mesh, HalfEdges& result)
{
    forEachBlock(mesh.vertices.size(), verticesPerBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v)
            std::sort(result.fans.begin() + result.fanBegin[v], result.fans.begin() + result.fanBegin[v + 1],
                      [&](std::uint32_t a, std::uint32_t b) {
                          const std::uint32_t endA = endOf(mesh, a);
                          const std::uint32_t endB = endOf(mesh, b);
                          return endA != endB ? endA < endB : a < b;
                      });
    });
}

/// The half-edges from one vertex to another.
std::span<const std::uint32_t> between(const TriangleMesh& mesh, const HalfEdges& halfEdges, std::uint32_t from,
                                       std::uint32_t to)
{
    const std::span<const std::uint32_t> fan = halfEdges.leaving(from);
    const auto first = std::lower_bound(fan.begin(), fan.end(), to, [&](std::uint32_t halfEdge, std::uint32_t vertex) {
        return endOf(mesh, halfEdge) < vertex;
    });
    auto last = first;
    while (last != fan.end() && endOf(mesh, *last) == to)
        ++last;
    return {first, last};
}

/// Gives the half-edges that leave a vertex their twins, and returns how many have none.
std::size_t pair(const TriangleMesh& mesh, std::uint32_t vertex, HalfEdges& result)
{
    std::size_t unpaired = 0;
    const std::span<const std::uint32_t> fan = result.leaving(vertex);
    for (std::size_t i = 0; i < fan.size();) {
        const std::uint32_t end = endOf(mesh, fan[i]);
        std::size_t next = i + 1;
        while (next < fan.size() && endOf(mesh, fan[next]) == end)
            ++next;
        const std::span<const std::uint32_t> back = between(mesh, result, end, vertex);
        if (next - i == 1 && back.size() == 1)
            result.twin[fan[i]] = back.front();
        else
            unpaired += next - i;
        i = next;
    }
    return unpaired;
}

} // namespace

HalfEdges findHalfEdges(const TriangleMesh& mesh)
{
    HalfEdges result;
    result.twin.assign(3 * mesh.triangles.size(), HalfEdges::none);
    gatherFans(mesh, result);
    sortFans(mesh, result);
    const auto unpaired =
        ofEachBlock<std::size_t>(mesh.vertices.size(), verticesPerBlock, [&](std::size_t begin, std::size_t end) {
            std::size_t count = 0;
            for (std::size_t v = begin; v < end; ++v)
                count += pair(mesh, static_cast<std::uint32_t>(v), result);
            return count;
        });
    result.unpaired = std::reduce(unpaired.begin(), unpaired.end());
    return result;
}

} // namespace knead
