#include "core/skin/enclosed_volume.h"

#include "core/geometry/clustered.h"
#include "core/geometry/refine.h"
#include "core/skin/former_shape.h"
#include "core/skin/refilled.h"
#include "core/task/block_sums.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace knead {

namespace {

// Edges of triangles; shorter ones where a part is too small for them [spacings].
constexpr double longestEdge = 2;
constexpr double shortestEdge = 0.5;
// What it encloses and what was filled may differ by so much [1].
constexpr double mostUnlike = 0.1;

constexpr std::size_t trianglesPerBlock = 4096;

/// @param middle of the places, about which rounding is least
double volumeOf(std::span<const Vec3> places, const std::vector<TriangleMesh::Triangle>& triangles, const Vec3& middle)
{
    return sumOverBlocks(triangles.size(), trianglesPerBlock, [&](std::size_t begin, std::size_t end) {
        double sum = 0;
        for (std::size_t n = begin; n < end; ++n) {
            const auto [a, b, c] = cornersOf(places, triangles[n]);
            sum += (a - middle).dot((b - middle).cross(c - middle)) / 6;
        }
        return sum;
    });
}

double richardson(std::span<const Vec3> places, const std::vector<TriangleMesh::Triangle>& coarse,
                  const std::vector<TriangleMesh::Triangle>& fine)
{
    Vec3 middle = Vec3::Zero();
    for (const Vec3& place : places)
        middle += place;
    middle /= static_cast<double>(places.size());
    return (4 * volumeOf(places, fine, middle) - volumeOf(places, coarse, middle)) / 3;
}

/// As often in one direction as in the other, at every edge: however many triangles meet there, they bound a volume.
bool isClosed(const TriangleMesh& mesh)
{
    std::vector<std::pair<std::uint64_t, int>> edges;
    edges.reserve(3 * mesh.triangles.size());
    for (const TriangleMesh::Triangle& t : mesh.triangles)
        for (std::size_t n = 0; n < 3; ++n) {
            const std::uint32_t from = t[n];
            const std::uint32_t to = t[(n + 1) % 3];
            edges.emplace_back(pairKey(from, to), from < to ? 1 : -1);
        }
    std::sort(edges.begin(), edges.end());
    for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
        int sum = 0;
        for (; end < edges.size() && edges[end].first == edges[begin].first; ++end)
            sum += edges[end].second;
        if (sum != 0)
            return false;
    }
    return true;
}

} // namespace

EnclosedVolume::EnclosedVolume(TriangleMesh coarse, const TriangleMesh& fine, const Aggregate& aggregate)
    : m_coarse(std::move(coarse.triangles))
    , m_fine(fine.triangles)
    , m_skin(Skin::ofPlacesWhenFilled(aggregate, fine.vertices))
    , m_whenFilled(richardson(m_skin.points(), m_coarse, m_fine))
{
}

std::unique_ptr<const EnclosedVolume> EnclosedVolume::of(const TriangleMesh& surface, const Aggregate& aggregate)
{
    if (aggregate.former && aggregate.former->isInPieces())
        return nullptr;
    for (double share = longestEdge; share >= shortestEdge; share /= 2) {
        const double edge = share * aggregate.lattice.spacing;
        const TriangleMesh whole = surfaceWhenFilled(surface, aggregate, share);
        TriangleMesh coarse = refine(clustered(whole, edge), edge);
        if (coarse.empty() || !isClosed(coarse))
            return nullptr;
        const TriangleMesh fine = halveEdges(coarse);
        const double volume = richardson(fine.vertices, coarse.triangles, fine.triangles);
        if (std::abs(volume / aggregate.filledVolume - 1) < mostUnlike)
            // NOLINTNEXTLINE(cppcoreguidelines-owning-memory): the constructor is private
            return std::unique_ptr<const EnclosedVolume>(new EnclosedVolume(std::move(coarse), fine, aggregate));
    }
    return nullptr;
}

double EnclosedVolume::ratio(std::span<const Vec3> displacements) const
{
    std::vector<Vec3> places(m_skin.size());
    m_skin.evaluate(displacements, places);
    return richardson(places, m_coarse, m_fine) / m_whenFilled;
}

} // namespace knead
