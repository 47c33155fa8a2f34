#include "core/skin/skin_map.h"

#include "core/skin/former_shape.h"
#include "core/skin/neighborhood_cache.h"
#include "core/skin/point_weights.h"
#include "core/task/parallel.h"

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <utility>

namespace knead {

namespace {

constexpr std::size_t pointsPerBlock = 512;

} // namespace

SkinMap::SkinMap(const Aggregate& aggregate, std::vector<Vec3> displacements, std::size_t mostBytes)
    : m_aggregate(aggregate)
    , m_neighborhoods(std::make_unique<NeighborhoodCache>(aggregate, mostBytes))
    , m_displacements(std::move(displacements))
{
    if (aggregate.size() == 0)
        throw std::invalid_argument("SkinMap: the aggregate has no objects");
    if (m_displacements.size() != aggregate.size())
        throw std::invalid_argument("SkinMap: as many displacements as objects are needed");
    m_featureSize = aggregate.lattice.spacing;
    if (aggregate.former)
        m_featureSize = std::min(aggregate.former->featureSize(), m_featureSize / aggregate.former->largestStretch());
}

SkinMap::~SkinMap() = default;

void SkinMap::evaluate(std::span<const Vec3> opened, std::span<Vec3> places) const
{
    std::vector<Vec3> carried;
    if (m_aggregate.former)
        carried = placesWhenFilled(m_aggregate, opened);
    const std::span<const Vec3> points = m_aggregate.former ? carried : opened;
    const OwnedPoints owned = m_neighborhoods->finder().ownersOf(points);
    forEachBlock(points.size(), pointsPerBlock, [&](std::size_t begin, std::size_t end) {
        std::shared_ptr<const Neighborhood> around;
        for (std::size_t i = begin; i < end; ++i) {
            if (i == begin || owned.isFirstOfOwner(i))
                around = m_neighborhoods->around(owned.ownerAt(i));
            const std::uint32_t point = owned.order[i];
            places[point] = place(points[point], *around);
        }
    });
}

Vec3 SkinMap::place(const Vec3& point, const Neighborhood& around) const
{
    const std::vector<double> weights = pointWeights(around, m_aggregate.lattice.coordinates(point));
    const std::vector<ObjectIndex>& objects = around.objects;
    const Vec3 common = m_displacements[objects.front()];
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = 0; k < objects.size(); ++k)
        sum += weights[k] * (m_displacements[objects[k]] - common);
    return point + (common + sum);
}

} // namespace knead
