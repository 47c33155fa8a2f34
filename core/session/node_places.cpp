#include "core/session/node_places.h"

#include "core/geometry/shape_fit.h"
#include "core/geometry/surface_distance.h"
#include "core/task/parallel_progress.h"

#include <algorithm>
#include <map>
#include <utility>

namespace knead {

namespace {

constexpr std::size_t placesPerBlock = 256;
constexpr double reachOutside = 1;     // spacings from the surface, within which a node is taken for one of the piece
constexpr double touchingShare = 2e-3; // of a spacing: surfaces of two pieces as near to a node are both its own

/// Nodes on surfaces of several pieces.
struct SharedNode {
    std::size_t node = 0;
    std::vector<NodePlace> places; ///< by piece, ascending
};

Vec3 towards(const Box& box, const Vec3& place)
{
    return place.cwiseMax(box.min()).cwiseMin(box.max());
}

/// Of the others in its cells the piece that most belong to.
class CellVotes {
public:
    CellVotes(const NodeCells& cells, std::span<const NodePlace> places, const std::vector<std::uint32_t>& sharedOf)
        : m_votes(std::ranges::count_if(sharedOf, [](std::uint32_t n) { return n != NodePlace::none; }))
    {
        for (std::size_t c = 0; c + 1 < cells.offsets.size(); ++c) {
            const auto nodes =
                cells.connectivity.subspan(static_cast<std::size_t>(cells.offsets[c]),
                                           static_cast<std::size_t>(cells.offsets[c + 1] - cells.offsets[c]));
            std::map<std::uint32_t, int> ofCell;
            for (const std::int64_t node : nodes)
                if (const auto n = static_cast<std::size_t>(node); sharedOf[n] == NodePlace::none)
                    ++ofCell[places[n].piece];
            for (const std::int64_t node : nodes)
                if (const std::uint32_t shared = sharedOf[static_cast<std::size_t>(node)]; shared != NodePlace::none)
                    for (const auto& [piece, votes] : ofCell)
                        m_votes[shared][piece] += votes;
        }
    }

    /// Of the places of a shared node, the first one of the most votes.
    const NodePlace& winner(std::size_t shared, const SharedNode& node) const
    {
        const auto votesFor = [&](const NodePlace& place) {
            const auto found = m_votes[shared].find(place.piece);
            return found == m_votes[shared].end() ? 0 : found->second;
        };
        return *std::ranges::max_element(node.places, {}, votesFor);
    }

private:
    std::vector<std::map<std::uint32_t, int>> m_votes; ///< per shared node
};

void settleShared(std::vector<NodePlace>& places, const std::vector<SharedNode>& shared, const NodeCells& cells)
{
    if (shared.empty())
        return;
    std::vector<std::uint32_t> sharedOf(places.size(), NodePlace::none);
    for (std::uint32_t n = 0; n < shared.size(); ++n)
        sharedOf[shared[n].node] = n;
    const CellVotes votes(cells, places, sharedOf);
    for (std::size_t n = 0; n < shared.size(); ++n)
        places[shared[n].node] = votes.winner(n, shared[n]);
}

} // namespace

std::vector<NodePlace> nodePlaces(std::span<const CarriedPiece> pieces, std::span<const Vec3> nodes, NodesAt at,
                                  const NodeCells& cells, TaskControl& control)
{
    std::vector<NodePlace> places(nodes.size());
    std::vector<std::vector<NodePlace>> touching(pieces.size() > 1 ? nodes.size()
                                                                   : 0); // per node, those at its surface
    for (std::uint32_t p = 0; p < pieces.size(); ++p) {
        const CarriedPiece& piece = pieces[p];
        const double spacing = piece.aggregate->lattice.spacing;
        TriangleMesh mesh = piece.mesh;
        if (at == NodesAt::now)
            mesh.vertices = piece.now;
        const SurfaceDistance surface(mesh);
        const Box box = boxOfPlaces(mesh.vertices);
        TaskPortion portion = TaskPortion::ofItem(control, p, pieces.size());
        forEachBlock(nodes.size(), placesPerBlock, portion, "finding nodes", [&](std::size_t begin, std::size_t end) {
            for (std::size_t n = begin; n < end; ++n) {
                NodePlace& best = places[n];
                const double boxDistance = (towards(box, nodes[n]) - nodes[n]).norm();
                if (boxDistance > std::max(0.0, best.depth) + touchingShare * spacing)
                    continue;
                const SurfaceDistance::Hit hit = surface.nearest(nodes[n]);
                const NodePlace here{
                    .piece = hit.signedDistance <= reachOutside * spacing ? p : NodePlace::none,
                    .triangle = hit.triangle,
                    .depth = hit.signedDistance,
                    .shares = nearestShares(cornersOf(mesh.vertices, mesh.triangles[hit.triangle]), hit.point)};
                if (!touching.empty() && hit.distance <= touchingShare * spacing)
                    touching[n].push_back(here);
                if (here.depth < best.depth)
                    best = here;
            }
        });
    }
    std::vector<SharedNode> shared;
    for (std::size_t n = 0; n < touching.size(); ++n)
        if (touching[n].size() > 1 &&
            places[n].depth == std::ranges::min_element(touching[n], {}, &NodePlace::depth)->depth)
            shared.push_back({n, std::move(touching[n])});
    settleShared(places, shared, cells);
    return places;
}

} // namespace knead
