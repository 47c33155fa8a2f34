#include "core/skin/former_shape.h"

#include "core/aggregate/pieces.h"
#include "core/geometry/refine.h"
#include "core/skin/skin.h"

#include <algorithm>
#include <utility>

namespace knead {

namespace {

// There is one for each filling that something remembers.
constexpr std::size_t mostBytesKept = std::size_t{2} << 20;

double largestStretchOf(const Aggregate& aggregate, std::span<const Vec3> displacements)
{
    double most = 1;
    for (std::size_t d = 0; d < Lattice::isotropicCount; ++d) {
        const Vec3 step = aggregate.lattice.direction(static_cast<int>(d));
        for (const Lattice::Segment& segment : aggregate.lattice.segments[d])
            for (ObjectIndex i = segment.begin; i < segment.end; ++i) {
                const auto j = i + static_cast<ObjectIndex>(segment.offset);
                if (aggregate.weight[d][i] > 0)
                    most = std::max(most, (step + displacements[j] - displacements[i]).norm() / step.norm());
            }
    }
    return most;
}

} // namespace

FormerShape::FormerShape(std::shared_ptr<const Aggregate> carriers, std::vector<Vec3> displacements,
                         std::vector<BrokenConnection> broken)
    : m_carriers(std::move(carriers))
    , m_broken(std::move(broken))
    , m_connected(withoutBroken(m_carriers, m_broken))
    , m_map(*m_connected, std::move(displacements), mostBytesKept)
    , m_stretch(largestStretchOf(*m_connected, m_map.displacements()))
{
}

double FormerShape::largestStretch() const
{
    return m_stretch * (m_carriers->former ? m_carriers->former->largestStretch() : 1);
}

const Aggregate& firstFillingOf(const Aggregate& aggregate)
{
    return aggregate.former ? firstFillingOf(*aggregate.former->carriers()) : aggregate;
}

std::vector<Vec3> firstFillingWhenFilled(const Aggregate& aggregate)
{
    const Aggregate& first = firstFillingOf(aggregate);
    std::vector<Vec3> places = first.lattice.positions();
    if (!aggregate.former || !aggregate.former->isInPieces())
        return placesWhenFilled(aggregate, places);
    const std::vector<BrokenConnection>& broken = aggregate.former->broken();
    const std::vector<std::uint16_t> isBroken = brokenDirections(first, broken);
    std::vector<std::vector<ObjectIndex>> ofPiece;
    const Pieces pieces = findPieces(first, broken);
    ofPiece.resize(pieces.count);
    for (ObjectIndex i = 0; i < first.size(); ++i)
        ofPiece[pieces.ofObject[i]].push_back(i);
    for (const std::vector<ObjectIndex>& objects : ofPiece) {
        const Aggregate piece = extract(first, objects, isBroken);
        std::vector<Vec3> there = pickedOf(places, objects);
        const Skin skin(piece, there);
        skin.evaluate(pickedOf(aggregate.former->displacements(), objects), there);
        for (std::size_t i = 0; i < objects.size(); ++i)
            places[objects[i]] = there[i];
    }
    return places;
}

std::vector<Vec3> placesWhenFilled(const Aggregate& aggregate, std::span<const Vec3> points)
{
    std::vector<Vec3> places(points.begin(), points.end());
    if (aggregate.former)
        aggregate.former->evaluate(points, places);
    return places;
}

CarriedSurface carriedSurface(const TriangleMesh& mesh, const SmoothMap& map, double maximumEdge,
                              std::size_t mostTriangles)
{
    CarriedSurface surface;
    const auto carry = [&](const std::vector<Vec3>& vertices) -> const std::vector<Vec3>& {
        const std::size_t known = surface.places.size();
        surface.places.resize(vertices.size());
        map.evaluate({vertices.data() + known, vertices.size() - known},
                     {surface.places.data() + known, vertices.size() - known});
        return surface.places;
    };
    surface.mesh = refineWhereCarried(mesh, maximumEdge, mostTriangles, carry);
    carry(surface.mesh.vertices);
    return surface;
}

TriangleMesh carriedMesh(const TriangleMesh& mesh, const SmoothMap& map, double maximumEdge, std::size_t mostTriangles)
{
    CarriedSurface surface = carriedSurface(mesh, map, maximumEdge, mostTriangles);
    surface.mesh.vertices = std::move(surface.places);
    return std::move(surface.mesh);
}

} // namespace knead
