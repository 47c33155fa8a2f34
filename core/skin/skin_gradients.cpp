#include "core/skin/skin_gradients.h"

#include "core/skin/neighborhood.h"
#include "core/skin/point_weights.h"
#include "core/task/parallel_progress.h"

#include <array>
#include <stdexcept>
#include <utility>

namespace knead {

namespace {

constexpr std::size_t pointsPerBlock = 512;

/// What consecutive points of OwnedPoints::order get; carriers are objects still.
struct PointList {
    std::vector<std::uint32_t> count;
    std::vector<float> trust;
    std::vector<SkinGradients::Influence> influences;

    void add(const Lattice& lattice, const Neighborhood& around, const Vec3& coordinates)
    {
        const ShapeSlopes shape = pointSlopes(around, coordinates);
        const std::size_t before = influences.size();
        for (std::size_t i = 0; i < shape.values.size(); ++i)
            if (shape.values[i] != 0 || !shape.slopes[i].isZero(0))
                influences.push_back({around.objects[i], static_cast<float>(shape.values[i]),
                                      (lattice.axes * shape.slopes[i] / lattice.spacing).cast<float>()});
        count.push_back(static_cast<std::uint32_t>(influences.size() - before));
        trust.push_back(static_cast<float>(shape.trust));
    }
};

/// Numbers the objects that influence any point, and puts these numbers in their place.
std::vector<ObjectIndex> numberCarriers(std::vector<SkinGradients::Influence>& influences, std::size_t objects)
{
    std::vector<std::uint32_t> place(objects, 0);
    for (const SkinGradients::Influence& influence : influences)
        place[influence.carrier] = 1;
    std::vector<ObjectIndex> carriers;
    for (std::size_t object = 0; object < objects; ++object)
        if (place[object] != 0) {
            place[object] = static_cast<std::uint32_t>(carriers.size());
            carriers.push_back(static_cast<ObjectIndex>(object));
        }
    for (SkinGradients::Influence& influence : influences)
        influence.carrier = place[influence.carrier];
    return carriers;
}

} // namespace

SkinGradients::SkinGradients(const Aggregate& aggregate, std::span<const Vec3> points,
                             std::span<const ObjectIndex> numbers, TaskControl& control)
    : m_first(points.size(), 0)
    , m_count(points.size(), 0)
    , m_trust(points.size(), 0)
{
    if (aggregate.size() == 0)
        throw std::invalid_argument("SkinGradients: the aggregate has no objects");
    const Lattice& lattice = aggregate.lattice;
    const NeighborhoodFinder finder(aggregate);
    OwnedPoints owned = finder.ownersOf(points);
    std::vector<PointList> lists((points.size() + pointsPerBlock - 1) / pointsPerBlock);
    forEachBlock(
        points.size(), pointsPerBlock, control, "attaching the surface", [&](std::size_t begin, std::size_t end) {
            Neighborhood around;
            for (std::size_t i = begin; i < end; ++i) {
                if (i == begin || owned.isFirstOfOwner(i))
                    around = finder.gather(owned.ownerAt(i));
                lists[begin / pointsPerBlock].add(lattice, around, lattice.coordinates(points[owned.order[i]]));
            }
        });
    m_order = std::move(owned.order);
    std::size_t all = 0;
    for (const PointList& list : lists)
        all += list.influences.size();
    m_influences.reserve(all);
    std::size_t first = 0;
    for (std::size_t i = 0; i < m_order.size(); ++i) {
        const PointList& list = lists[i / pointsPerBlock];
        m_first[m_order[i]] = static_cast<std::uint32_t>(first);
        m_count[m_order[i]] = list.count[i % pointsPerBlock];
        m_trust[m_order[i]] = list.trust[i % pointsPerBlock];
        first += list.count[i % pointsPerBlock];
    }
    for (PointList& list : lists) {
        m_influences.insert(m_influences.end(), list.influences.begin(), list.influences.end());
        list.influences = {};
    }
    m_carriers = numberCarriers(m_influences, aggregate.size());
    if (!numbers.empty())
        for (ObjectIndex& carrier : m_carriers)
            carrier = numbers[carrier];
}

Mat3 SkinGradients::sumOfProducts(std::size_t point, std::span<const Vec3> displacements) const
{
    // Relative to one of the objects, rounding does not scale with the distance travelled: single precision leaves some 3e-7.
    const std::span<const Influence> around = influences(point);
    const Vec3 common = displacements[around.front().carrier];
    std::array<Eigen::Array4f, 3> sums;
    sums.fill(Eigen::Array4f::Zero());
    for (const auto& [carrier, value, slope] : around) {
        const Vec3 way = displacements[carrier] - common;
        const Eigen::Array4f moved(static_cast<float>(way.x()), static_cast<float>(way.y()),
                                   static_cast<float>(way.z()), 0);
        for (std::size_t axis = 0; axis < 3; ++axis)
            sums[axis] += moved * slope[static_cast<Eigen::Index>(axis)];
    }
    Mat3 sum;
    for (std::size_t axis = 0; axis < 3; ++axis)
        sum.col(static_cast<Eigen::Index>(axis)) = sums[axis].head<3>().matrix().cast<double>();
    return sum;
}

} // namespace knead
