#include "core/skin/former_shape.h"

#include "core/geometry/refine.h"

#include <algorithm>
#include <utility>

namespace knead {

namespace {

// There is one for each filling that something remembers.
constexpr std::size_t mostBytesKept = std::size_t{1} << 20;

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

FormerShape::FormerShape(std::shared_ptr<const Aggregate> carriers, std::vector<Vec3> displacements)
    : m_carriers(std::move(carriers))
    , m_map(*m_carriers, std::move(displacements), mostBytesKept)
    , m_stretch(largestStretchOf(*m_carriers, m_map.displacements()))
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

} // namespace knead
