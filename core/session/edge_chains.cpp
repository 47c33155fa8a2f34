#include "core/session/edge_chains.h"

#include "core/geometry/disjoint_sets.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <unordered_map>

namespace knead {

namespace {

using Key = std::uint64_t; ///< two numbers, see pairKey()

/// The CAD faces on both sides of the feature edges, by their vertices in the mesh.
std::unordered_map<Key, Key> sidesOf(const TriangleMesh& mesh, const RenderMesh& render)
{
    std::unordered_map<Key, std::pair<std::uint32_t, std::uint32_t>> faces;
    faces.reserve(render.edges.size());
    for (const auto& edge : render.edges)
        faces[pairKey(render.source[edge[0]], render.source[edge[1]])] = {~0U, 0};
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i) {
            const auto found = faces.find(pairKey(mesh.triangles[t][i], mesh.triangles[t][(i + 1) % 3]));
            if (found == faces.end())
                continue;
            auto& [lowest, highest] = found->second;
            lowest = std::min(lowest, render.faceOfTriangle[t]);
            highest = std::max(highest, render.faceOfTriangle[t]);
        }
    std::unordered_map<Key, Key> sides;
    sides.reserve(faces.size());
    for (const auto& [edge, pair] : faces)
        sides[edge] = pairKey(pair.first, pair.second);
    return sides;
}

} // namespace

std::vector<std::uint32_t> chainsOf(const TriangleMesh& mesh, const RenderMesh& render)
{
    const auto sides = sidesOf(mesh, render);
    using End = std::tuple<std::uint32_t, Key, std::uint32_t>; // a vertex, the faces beside the edge, the edge
    std::vector<End> ends;
    for (std::uint32_t e = 0; e < render.edges.size(); ++e) {
        const std::uint32_t a = render.source[render.edges[e][0]];
        const std::uint32_t b = render.source[render.edges[e][1]];
        const Key side = sides.at(pairKey(a, b));
        ends.emplace_back(a, side, e);
        ends.emplace_back(b, side, e);
    }
    std::ranges::sort(ends);
    DisjointSets chains(render.edges.size());
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const auto& [vertex, side, edge] = ends[i];
        const auto isSame = [&](std::size_t j) {
            return j < ends.size() && std::get<0>(ends[j]) == vertex && std::get<1>(ends[j]) == side;
        };
        const bool areTwo = isSame(i + 1) && !isSame(i + 2) && !(i > 0 && isSame(i - 1));
        if (areTwo)
            chains.join(edge, std::get<2>(ends[i + 1]));
    }
    std::vector<std::uint32_t> result(render.edges.size());
    std::map<std::size_t, std::uint32_t> numbers;
    for (std::uint32_t e = 0; e < render.edges.size(); ++e)
        result[e] = numbers.try_emplace(chains.find(e), static_cast<std::uint32_t>(numbers.size())).first->second;
    return result;
}

} // namespace knead
