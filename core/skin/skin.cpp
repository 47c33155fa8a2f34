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

/// Influences of consecutive points of some order.
struct InfluenceList {
    std::vector<std::uint32_t> count; // per point
    std::vector<Skin::Influence> influences;
};

void addPoint(InfluenceList& list, const Lattice& lattice, const Neighborhood& around, const Vec3& coordinates)
{
    const std::vector<double> functions = pointWeights(lattice, around, coordinates);
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < functions.size(); ++i) {
        if (functions[i] == 0)
            continue;
        list.influences.push_back({around.objects[i], static_cast<float>(functions[i])});
        ++count;
    }
    list.count.push_back(count);
}

/// Finds the influences of all points, those with the same owner together: they share its neighborhood.
class SkinBuilder {
public:
    SkinBuilder(const Aggregate& aggregate, std::span<const Vec3> points)
        : m_lattice(aggregate.lattice)
        , m_points(points)
        , m_finder(aggregate)
        , m_owners(points.size())
        , m_order(points.size())
        , m_lists((points.size() + pointsPerBlock - 1) / pointsPerBlock)
    {
    }

    void build(TaskControl& control)
    {
        forEachBlock(m_points.size(), pointsPerBlock, [&](std::size_t begin, std::size_t end) {
            for (std::size_t point = begin; point < end; ++point)
                m_owners[point] = m_finder.owner(m_lattice.coordinates(m_points[point]));
        });
        std::iota(m_order.begin(), m_order.end(), 0U);
        std::sort(m_order.begin(), m_order.end(), [&](std::uint32_t p, std::uint32_t q) {
            return m_owners[p] != m_owners[q] ? m_owners[p] < m_owners[q] : p < q;
        });
        forEachBlock(m_points.size(), pointsPerBlock, control, "attaching the surface",
                     [&](std::size_t begin, std::size_t end) { m_lists[begin / pointsPerBlock] = attach(begin, end); });
    }

    /// Calls visit(point, influences) for every point.
    template <typename Visit>
    void forEachPoint(Visit&& visit) const
    {
        for (std::size_t list = 0; list < m_lists.size(); ++list) {
            std::size_t first = 0;
            for (std::size_t i = 0; i < m_lists[list].count.size(); ++i) {
                const std::size_t count = m_lists[list].count[i];
                visit(m_order[list * pointsPerBlock + i],
                      std::span<const Skin::Influence>(m_lists[list].influences.data() + first, count));
                first += count;
            }
        }
    }

private:
    InfluenceList attach(std::size_t begin, std::size_t end) const
    {
        InfluenceList list;
        Neighborhood around;
        for (std::size_t i = begin; i < end; ++i) {
            const SkinOwner& owner = m_owners[m_order[i]];
            if (i == begin || owner != m_owners[m_order[i - 1]])
                around = m_finder.gather(owner);
            addPoint(list, m_lattice, around, m_lattice.coordinates(m_points[m_order[i]]));
        }
        return list;
    }

    const Lattice& m_lattice;
    std::span<const Vec3> m_points;
    NeighborhoodFinder m_finder;
    std::vector<SkinOwner> m_owners;
    std::vector<std::uint32_t> m_order; // points, by owner
    std::vector<InfluenceList> m_lists; // per block of that order
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
    m_first.assign(m_points.size() + 1, 0);
    SkinBuilder builder(aggregate, m_points);
    builder.build(control);
    builder.forEachPoint([&](std::size_t point, std::span<const Influence> influences) {
        m_first[point + 1] = static_cast<std::uint32_t>(influences.size());
    });
    std::partial_sum(m_first.begin(), m_first.end(), m_first.begin());
    m_influences.resize(m_first.back());
    builder.forEachPoint([&](std::size_t point, std::span<const Influence> influences) {
        std::copy(influences.begin(), influences.end(), m_influences.begin() + m_first[point]);
    });
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
