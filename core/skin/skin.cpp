#include "core/skin/skin.h"

#include "core/skin/former_shape.h"
#include "core/skin/neighborhood.h"
#include "core/skin/point_weights.h"
#include "core/task/parallel_progress.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace knead {

namespace {

constexpr std::size_t pointsPerBlock = 512;

/// Influences of consecutive points of OwnedPoints::order.
struct InfluenceList {
    std::vector<std::uint32_t> count; // per point
    std::vector<Skin::Influence> influences;

    void add(const Neighborhood& around, const Vec3& coordinates)
    {
        const std::vector<double> functions = pointWeights(around, coordinates);
        const std::size_t before = influences.size();
        for (std::size_t i = 0; i < functions.size(); ++i)
            if (functions[i] != 0)
                influences.push_back({around.objects[i], static_cast<float>(functions[i])});
        count.push_back(static_cast<std::uint32_t>(influences.size() - before));
    }
};

} // namespace

Skin::Skin(const Aggregate& aggregate, std::span<const Vec3> points, TaskControl& control)
    : m_points(placesWhenFilled(aggregate, points))
{
    attach(aggregate, control);
}

Skin Skin::ofPlacesWhenFilled(const Aggregate& aggregate, std::vector<Vec3> places, TaskControl& control)
{
    Skin skin;
    skin.m_points = std::move(places);
    skin.attach(aggregate, control);
    return skin;
}

Skin Skin::joined(std::span<const Skin> parts, std::span<const std::vector<ObjectIndex>> numbers)
{
    Skin all;
    all.m_first.push_back(0);
    for (std::size_t p = 0; p < parts.size(); ++p) {
        const Skin& part = parts[p];
        const auto offset = all.m_first.back();
        all.m_points.insert(all.m_points.end(), part.m_points.begin(), part.m_points.end());
        for (std::size_t point = 0; point < part.size(); ++point)
            all.m_first.push_back(offset + part.m_first[point + 1]);
        for (const Influence& influence : part.m_influences)
            all.m_influences.push_back({numbers[p][influence.object], influence.weight});
    }
    return all;
}

void Skin::attach(const Aggregate& aggregate, TaskControl& control)
{
    if (aggregate.size() == 0)
        throw std::invalid_argument("Skin: the aggregate has no objects");
    const Lattice& lattice = aggregate.lattice;
    const NeighborhoodFinder finder(aggregate);
    const OwnedPoints owned = finder.ownersOf(m_points);
    std::vector<InfluenceList> lists((size() + pointsPerBlock - 1) / pointsPerBlock);
    forEachBlock(size(), pointsPerBlock, control, "attaching the surface", [&](std::size_t begin, std::size_t end) {
        Neighborhood around;
        for (std::size_t i = begin; i < end; ++i) {
            if (i == begin || owned.isFirstOfOwner(i))
                around = finder.gather(owned.ownerAt(i));
            lists[begin / pointsPerBlock].add(around, lattice.coordinates(m_points[owned.order[i]]));
        }
    });
    m_first.assign(size() + 1, 0);
    for (std::size_t i = 0; i < size(); ++i)
        m_first[owned.order[i] + 1] = lists[i / pointsPerBlock].count[i % pointsPerBlock];
    std::partial_sum(m_first.begin(), m_first.end(), m_first.begin());
    m_influences.resize(m_first.back());
    std::vector<Influence>::const_iterator next;
    for (std::size_t i = 0; i < size(); ++i) {
        const InfluenceList& list = lists[i / pointsPerBlock];
        if (i % pointsPerBlock == 0)
            next = list.influences.begin();
        std::copy_n(next, list.count[i % pointsPerBlock], m_influences.begin() + m_first[owned.order[i]]);
        next += list.count[i % pointsPerBlock];
    }
}

void Skin::evaluate(std::span<const Vec3> displacement, std::span<Vec3> places) const
{
    assert(places.size() == size());
    forEachBlock(size(), pointsPerBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t point = begin; point < end; ++point) {
            // Relative to one of the objects, the rounding of the weights does not scale with the distance travelled.
            const std::span<const Influence> around = influences(point);
            const Vec3 common = displacement[around.front().object];
            Vec3 sum = Vec3::Zero();
            for (const Influence& influence : around)
                sum += static_cast<double>(influence.weight) * (displacement[influence.object] - common);
            places[point] = m_points[point] + (common + sum);
        }
    });
}

} // namespace knead
