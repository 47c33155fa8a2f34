#include "core/vicinity/partition_tree.h"
#include "core/vicinity/uniform_grid.h"
#include "core/vicinity/vicinity.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <random>

using namespace knead;

namespace {

using Spheres = std::vector<VicinitySphere>;

Spheres randomSpheres(std::size_t count, const Vec3& extent, double radius, std::uint32_t groups = 3)
{
    std::mt19937 random(11);
    std::uniform_real_distribution<double> value(-1, 1);
    Spheres spheres;
    for (std::size_t i = 0; i < count; ++i)
        spheres.push_back({extent.cwiseProduct(Vec3(value(random), value(random), value(random))),
                           radius * (0.6 + 0.4 * value(random)), static_cast<std::uint32_t>(i) % groups});
    return spheres;
}

Spheres withHugeOne(Spheres spheres)
{
    spheres.push_back({Vec3::Zero(), 5, 77});
    return spheres;
}

Spheres manySizes()
{
    Spheres spheres = randomSpheres(1000, {1, 1, 1}, 0.03);
    for (std::size_t i = 0; i < spheres.size(); ++i)
        spheres[i].radius *= std::pow(10.0, static_cast<double>(i % 7) / 7);
    return spheres;
}

std::vector<VicinityPair> pairsBy(VicinityMethod method, const Spheres& spheres, double margin)
{
    const auto vicinity = makeVicinity(method);
    vicinity->build(spheres, margin);
    return vicinity->pairs();
}

} // namespace

class VicinityTest : public QObject {
    Q_OBJECT

private slots:
    void backEndsAgree_data()
    {
        QTest::addColumn<Spheres>("spheres");
        QTest::newRow("packed") << randomSpheres(1500, {1, 1, 1}, 0.1);
        QTest::newRow("sparse") << randomSpheres(500, {1000, 1000, 1000}, 40);
        QTest::newRow("in a plane") << randomSpheres(800, {1, 1, 0}, 0.05);
        QTest::newRow("on a line") << randomSpheres(800, {1, 0, 0}, 0.002);
        QTest::newRow("coincident") << randomSpheres(120, {0, 0, 0}, 1);
        QTest::newRow("points") << randomSpheres(100, {1, 1, 1}, 0);
        QTest::newRow("one huge") << withHugeOne(randomSpheres(600, {1, 1, 1}, 0.02));
        QTest::newRow("ten to one") << manySizes();
        QTest::newRow("far away") << Spheres{
            {Vec3(1e15, 0, 0), 1, 0}, {Vec3(1e15, 1, 0), 1, 1}, {Vec3(-1e150, 0, 0), 1, 2}};
        QTest::newRow("one group") << randomSpheres(100, {1, 1, 1}, 0.5, 1);
        QTest::newRow("single") << randomSpheres(1, {1, 1, 1}, 1);
        QTest::newRow("none") << Spheres{};
    }
    void backEndsAgree()
    {
        QFETCH(Spheres, spheres);
        for (const double margin : {0.0, 0.03}) {
            const auto expected = pairsBy(VicinityMethod::bruteForce, spheres, margin);
            for (const VicinityMethod method : vicinityMethods)
                QVERIFY2(pairsBy(method, spheres, margin) == expected, nameOf(method).data());
        }
    }

    void backEndsAgreeOnAHundredThousandSpheres()
    {
        // Scattered clusters: what the trees are good at; the test of all pairs would take too long here.
        Spheres spheres;
        for (int cluster = 0; cluster < 100; ++cluster)
            for (const VicinitySphere& sphere : randomSpheres(1000, {1, 1, 1}, 0.1))
                spheres.push_back({sphere.center + Vec3(4 * (cluster % 10), 4 * (cluster / 10), 0.1 * cluster),
                                   sphere.radius, sphere.group});
        const auto expected = pairsBy(VicinityMethod::uniformGrid, spheres, 0);
        QVERIFY(!expected.empty());
        QVERIFY(pairsBy(VicinityMethod::halfPartition, spheres, 0) == expected);
        QVERIFY(pairsBy(VicinityMethod::medianPartition, spheres, 0) == expected);
    }

    void subsetsOfTheParallelSchemeChangeNothing()
    {
        const Spheres spheres = randomSpheres(1200, {1, 1, 1}, 0.1);
        const auto expected = pairsBy(VicinityMethod::bruteForce, spheres, 0.01);
        for (const std::size_t subsets : {1U, 2U, 3U, 8U, 2000U})
            for (const auto plane : {PartitionTree::Plane::half, PartitionTree::Plane::median}) {
                PartitionTree tree(plane, subsets);
                tree.build(spheres, 0.01);
                QVERIFY(tree.pairs() == expected);
            }
    }

    void rebuiltStructuresForgetTheOldSpheres()
    {
        const Spheres spheres = randomSpheres(300, {1, 1, 1}, 0.1);
        for (const VicinityMethod method : vicinityMethods) {
            const auto vicinity = makeVicinity(method);
            vicinity->build(randomSpheres(900, {0.5, 0.5, 0.5}, 0.2), 0);
            vicinity->pairs();
            vicinity->build(spheres, 0);
            QVERIFY2(vicinity->pairs() == pairsBy(VicinityMethod::bruteForce, spheres, 0), nameOf(method).data());
        }
    }

    void statisticsCountWhatWasDone()
    {
        const Spheres spheres = randomSpheres(2000, {1, 1, 1}, 0.05);
        const auto statisticsOf = [&](VicinityMethod method) {
            const auto vicinity = makeVicinity(method);
            vicinity->build(spheres, 0);
            vicinity->pairs();
            return vicinity->statistics();
        };
        QCOMPARE(statisticsOf(VicinityMethod::bruteForce).sphereTests, std::uint64_t{2000 * 1999 / 2});
        QVERIFY(statisticsOf(VicinityMethod::uniformGrid).sphereTests < 40'000);
        // A complete tree of 2000 spheres has depth 11 or less: spanning spheres only make it shallower.
        const VicinityStatistics median = statisticsOf(VicinityMethod::medianPartition);
        QVERIFY(median.depth >= 5 && median.depth <= 11);
        QVERIFY(median.spanningObjects > 0 && median.spanningObjects < 2000);
        QVERIFY(median.sphereTests < 2000 * 1999 / 4);
    }

    void boxHoldsWhatLiesInIt()
    {
        const Spheres spheres = manySizes();
        UniformGrid grid;
        grid.build(spheres, 0.01);
        const double huge = std::numeric_limits<double>::max();
        for (const Box& box : {Box(Vec3(-0.3, 0, 0.2), Vec3(0.4, 0.9, 0.5)), Box(Vec3(5, 5, 5), Vec3(6, 6, 6)),
                               Box(Vec3(-huge, -huge, -huge), Vec3(huge, huge, -0.8))}) {
            std::vector<std::uint32_t> expected;
            for (std::uint32_t i = 0; i < spheres.size(); ++i)
                if (box.contains(spheres[i].center))
                    expected.push_back(i);
            QCOMPARE(grid.inBox(box), expected);
        }
    }
};

QTEST_GUILESS_MAIN(VicinityTest)
#include "vicinity_test.moc"
