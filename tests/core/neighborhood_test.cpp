#include "core/aggregate/fill.h"
#include "core/skin/neighborhood_cache.h"
#include "core/task/parallel.h"
#include "support/shapes.h"

#include <QtTest>

#include <algorithm>
#include <cstdlib>
#include <set>

using namespace knead;

namespace {

/// A step goes to one of 18 neighbors: along two axes at most. So these are the nodes that three steps in a full lattice lead to.
bool isWithinThreeSteps(const Lattice::Node& from, const Lattice::Node& to)
{
    std::int32_t sum = 0;
    std::int32_t largest = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::int32_t distance = std::abs(to[axis] - from[axis]);
        sum += distance;
        largest = std::max(largest, distance);
    }
    return largest <= 3 && sum <= 6;
}

Lattice::Node cornerOf(const Lattice::Node& cell, std::int32_t corner)
{
    return {cell[0] + (corner >> 2), cell[1] + (corner >> 1 & 1), cell[2] + (corner & 1)};
}

/// Per object.
std::vector<double> sharesOf(const Neighborhood& around, const Vec3& coordinates)
{
    const std::vector<double> ofSets = around.sharesOfSets(coordinates);
    std::vector<double> shares;
    for (const std::uint16_t set : around.walksOf)
        shares.push_back(ofSets[set]);
    return shares;
}

bool same(const Neighborhood& a, const Neighborhood& b)
{
    return a.owner == b.owner && a.cells == b.cells && a.objects == b.objects && a.walks == b.walks &&
           a.walksOf == b.walksOf && a.outward.order == b.outward.order && a.outward.steps == b.outward.steps &&
           a.outward.within == b.outward.within;
}

} // namespace

class NeighborhoodTest : public QObject {
    Q_OBJECT

    Aggregate m_block = fill(shapes::box(Vec3(14, 14, 14)), {.spacing = 1});

    /// A kept cell as far from the surface as any.
    Lattice::Node middle() const
    {
        const Vec3 center = m_block.lattice.coordinates(Vec3::Zero());
        return {static_cast<std::int32_t>(std::floor(center.x())), static_cast<std::int32_t>(std::floor(center.y())),
                static_cast<std::int32_t>(std::floor(center.z()))};
    }

    static Vec3 inCell(const Lattice::Node& cell, const Vec3& place) { return Vec3(cell[0], cell[1], cell[2]) + place; }

private slots:
    void aCellReachesThreeStepsFromItsCorners()
    {
        const NeighborhoodFinder finder(m_block);
        const SkinOwner owner = finder.owner(inCell(middle(), Vec3(0.3, 0.4, 0.6)));
        QCOMPARE(owner.kind, SkinOwner::Kind::cell);
        QCOMPARE(owner.node, middle());
        std::vector<ObjectIndex> wanted;
        for (ObjectIndex object = 0; object < m_block.size(); ++object)
            for (std::int32_t corner = 0; corner < 8; ++corner)
                if (isWithinThreeSteps(cornerOf(owner.node, corner), m_block.lattice.nodes[object])) {
                    wanted.push_back(object);
                    break;
                }
        QCOMPARE(finder.gather(owner).objects, wanted);
    }

    void objectsAreListedFromTheMiddleOutward()
    {
        const NeighborhoodFinder finder(m_block);
        const Lattice::Node corner = m_block.lattice.nodes.front();
        const Lattice::Node below{corner[0] - 1, corner[1], corner[2]};
        for (const SkinOwner& owner : {SkinOwner{middle(), SkinOwner::Kind::cell},
                                       {below, SkinOwner::Kind::around},
                                       {corner, SkinOwner::Kind::object}}) {
            const Neighborhood around = finder.gather(owner);
            const std::vector<std::uint16_t>& order = around.outward.order;
            QVERIFY(!order.empty());
            QCOMPARE(order.size(), around.objects.size());
            QCOMPARE(around.outward.steps[0].size() % 8, std::size_t{0});
            std::vector<Vec3> places;
            double last = 0;
            for (std::size_t i = 0; i < order.size(); ++i) {
                const Lattice::Node& node = m_block.lattice.nodes[around.objects[order[i]]];
                places.emplace_back(node[0], node[1], node[2]);
                const Vec3 step = places.back() - around.middle();
                for (std::size_t axis = 0; axis < 3; ++axis)
                    QCOMPARE(around.outward.steps[axis][i], static_cast<float>(step[static_cast<Eigen::Index>(axis)]));
                QVERIFY(step.norm() >= last - 1e-12);
                last = step.norm();
            }
            QCOMPARE(std::set(order.begin(), order.end()).size(), order.size());
            for (const Vec3& inside : {Vec3(0, 0, 0), Vec3(0.3, -0.2, 0.4), Vec3(-0.5, 0.5, 0.1)})
                for (double radius = 0; radius < 12; radius += 0.3) {
                    const std::size_t most = around.mostWithin(radius, inside.norm());
                    QVERIFY(most <= order.size());
                    for (std::size_t i = most; i < order.size(); ++i)
                        QVERIFY((places[i] - around.middle() - inside).norm() >= radius);
                    // It is of use: what is listed is not much farther away.
                    for (std::size_t i = 0; i < most; ++i)
                        QVERIFY((places[i] - around.middle()).norm() < radius + inside.norm() + 0.25);
                }
        }
    }

    /// At a corner, what was reached from it; between corners, the mean of them.
    void sharesAreThoseOfTheCorners()
    {
        const NeighborhoodFinder finder(m_block);
        const Neighborhood around = finder.gather({middle(), SkinOwner::Kind::cell});
        std::vector<double> mean(around.objects.size(), 0);
        for (std::int32_t corner = 0; corner < 8; ++corner) {
            const Lattice::Node node = cornerOf(middle(), corner);
            const std::vector<double> shares = sharesOf(around, inCell(node, Vec3::Zero()));
            for (std::size_t i = 0; i < shares.size(); ++i) {
                const bool isReached = isWithinThreeSteps(node, m_block.lattice.nodes[around.objects[i]]);
                QCOMPARE(shares[i], isReached ? 1.0 : 0.0);
                mean[i] += shares[i] / 8;
            }
        }
        QVERIFY(std::ranges::any_of(mean, [](double share) { return share > 0 && share < 1; }));
        const std::vector<double> shares = sharesOf(around, inCell(middle(), Vec3(0.5, 0.5, 0.5)));
        for (std::size_t i = 0; i < shares.size(); ++i)
            QVERIFY(std::abs(shares[i] - mean[i]) < 1e-15);
    }

    void besideTheBodyItsNearestCellsAreAsked()
    {
        const NeighborhoodFinder finder(m_block);
        const auto upper = std::ranges::max(m_block.lattice.nodes, {}, [](const auto& node) { return node[0]; });
        const Lattice::Node outside{upper[0], middle()[1], middle()[2]};
        const Vec3 point = inCell(outside, Vec3(0.2, 0.5, 0.5));
        const SkinOwner owner = finder.owner(point);
        QCOMPARE(owner.kind, SkinOwner::Kind::around);
        QCOMPARE(owner.node, outside);
        const Neighborhood around = finder.gather(owner);
        QCOMPARE(around.cells.size(), std::size_t{9}); // of the last layer
        // Only the cell right below is near: the point is asked of as if it were on the face between.
        const Neighborhood below = finder.gather({{upper[0] - 1, outside[1], outside[2]}, SkinOwner::Kind::cell});
        const std::vector<double> wanted = sharesOf(below, inCell(outside, Vec3(0, 0.5, 0.5)));
        const std::vector<double> shares = sharesOf(around, point);
        for (std::size_t i = 0; i < shares.size(); ++i) {
            const auto found = std::ranges::find(below.objects, around.objects[i]);
            const auto place = static_cast<std::size_t>(found - below.objects.begin());
            QVERIFY(std::abs(shares[i] - (found == below.objects.end() ? 0 : wanted[place])) < 1e-15);
        }
    }

    void farFromTheBodyThereIsTheNearestObject()
    {
        const NeighborhoodFinder finder(m_block);
        const SkinOwner owner = finder.owner(m_block.lattice.coordinates(Vec3(20, 21, 22)));
        QCOMPARE(owner.kind, SkinOwner::Kind::object);
        QCOMPARE(owner.node, m_block.lattice.nodes.back());
        const Neighborhood around = finder.gather(owner);
        QVERIFY(around.cells.empty());
        for (const double share : sharesOf(around, m_block.lattice.coordinates(Vec3(20, 21, 22))))
            QCOMPARE(share, 1.0);
    }

    void whatWasGatheredIsKept()
    {
        const NeighborhoodFinder finder(m_block);
        NeighborhoodCache cache(m_block);
        const SkinOwner owner{middle(), SkinOwner::Kind::cell};
        const auto first = cache.around(owner);
        QVERIFY(same(*first, finder.gather(owner)));
        QCOMPARE(cache.around(owner), first); // itself
        const std::size_t bytes = cache.bytes();
        QVERIFY(bytes > first->objects.size() * sizeof(ObjectIndex));
        SkinOwner other = owner;
        other.node[1] += 1;
        QVERIFY(same(*cache.around(other), finder.gather(other)));
        QVERIFY(cache.bytes() > bytes);
    }

    void notMoreIsKeptThanWasAllowed()
    {
        const NeighborhoodFinder finder(m_block);
        constexpr std::size_t most = 20'000;
        NeighborhoodCache cache(m_block, most);
        std::vector<SkinOwner> owners;
        for (const Lattice::Node& node : m_block.lattice.nodes)
            owners.push_back({node, SkinOwner::Kind::object});
        std::vector<char> isRight(owners.size(), 0);
        forEachBlock(owners.size(), 16, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                isRight[i] = same(*cache.around(owners[i]), finder.gather(owners[i])) ? 1 : 0;
        });
        QCOMPARE(std::ranges::count(isRight, 1), static_cast<std::ptrdiff_t>(owners.size()));
        QVERIFY(cache.bytes() > 0);
        QVERIFY(cache.bytes() <= most);
    }
};

QTEST_APPLESS_MAIN(NeighborhoodTest)
#include "neighborhood_test.moc"
