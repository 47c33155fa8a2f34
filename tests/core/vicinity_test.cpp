#include "core/vicinity/partition_tree.h"
#include "core/vicinity/uniform_grid.h"
#include "core/vicinity/vicinity.h"
#include "support/thread_limit.h"

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

Spheres moved(Spheres spheres, const Vec3& by)
{
    for (VicinitySphere& sphere : spheres)
        sphere.center += by;
    return spheres;
}

/// A body of nodes^3 spheres, each in a group of its own, turned against the axes.
Spheres turnedLattice(int nodes, double spacing, double radius)
{
    const Quaternion turn(Eigen::AngleAxisd(0.4, Vec3(0.3, 1, 0.5).normalized()));
    Spheres spheres;
    for (int x = 0; x < nodes; ++x)
        for (int y = 0; y < nodes; ++y)
            for (int z = 0; z < nodes; ++z)
                spheres.push_back(
                    {turn * (spacing * Vec3(x, y, z)), radius, static_cast<std::uint32_t>(spheres.size())});
    return spheres;
}

/// Bodies side by side, aligned with the axes, whose neighboring spheres touch exactly.
Spheres packedLattice(int nodes, double radius)
{
    Spheres spheres;
    for (int x = 0; x < nodes; ++x)
        for (int y = 0; y < nodes; ++y)
            for (int z = 0; z < nodes; ++z)
                spheres.push_back({2 * radius * Vec3(x, y, z), radius, static_cast<std::uint32_t>(x / 4)});
    return spheres;
}

/// Points that close in on the origin until doubles end: halving space parts only the first of them.
Spheres closingIn()
{
    Spheres spheres;
    for (std::uint32_t i = 0; i < 900; ++i)
        spheres.push_back({std::ldexp(1.0, -static_cast<int>(i)) * Vec3(1, -1, 1), 0, i});
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
    return vicinity->findPairs(spheres, margin).sorted(spheres.size());
}

/// In the order they come in.
std::vector<VicinityPair> pairsAsFound(const PairBlocks& found)
{
    std::vector<VicinityPair> pairs;
    for (const PairBlock& block : found.blocks())
        pairs.insert(pairs.end(), block.pairs().begin(), block.pairs().end());
    return pairs;
}

/// Who is close to one sphere, by testing it against all others.
std::vector<std::uint32_t> partnersOf(std::uint32_t sphere, const Spheres& spheres, double margin)
{
    std::vector<std::uint32_t> partners;
    for (std::uint32_t other = 0; other < spheres.size(); ++other)
        if (other != sphere && closerThan(spheres[sphere], spheres[other], margin))
            partners.push_back(other);
    return partners;
}

/// Who is paired with one sphere.
std::vector<std::uint32_t> partnersOf(std::uint32_t sphere, const std::vector<VicinityPair>& pairs)
{
    std::vector<std::uint32_t> partners;
    for (const VicinityPair& pair : pairs)
        if (pair.first == sphere || pair.second == sphere)
            partners.push_back(pair.first == sphere ? pair.second : pair.first);
    return partners;
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
        QTest::newRow("packed lattice") << packedLattice(12, 0.05);
        QTest::newRow("turned lattice") << turnedLattice(11, 0.1, 0.07);
        QTest::newRow("coincident") << randomSpheres(400, {0, 0, 0}, 1);
        QTest::newRow("coincident at an odd place") << moved(Spheres(300, {Vec3::Zero(), 0.1, 0}), {0.1, 0.7, -1e3});
        QTest::newRow("points") << randomSpheres(100, {1, 1, 1}, 0);
        QTest::newRow("points in a plane") << randomSpheres(2000, {0, 1, 1}, 0);
        QTest::newRow("coincident points") << randomSpheres(400, {0, 0, 0}, 0);
        QTest::newRow("points closing in") << closingIn();
        QTest::newRow("one huge") << withHugeOne(randomSpheres(600, {1, 1, 1}, 0.02));
        QTest::newRow("ten to one") << manySizes();
        QTest::newRow("a million away") << moved(randomSpheres(1500, {1, 1, 1}, 0.1), {1e6, -1e6, 1e6});
        QTest::newRow("lattice a million away") << moved(packedLattice(10, 0.05), {1e6, 1e6, 1e6});
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

    void contactsThatRoundingDecidesAreNotLost()
    {
        // Spheres in a row, apart by a hair less than contact: by rounding some fall two cells of a grid apart.
        std::mt19937 random(7);
        std::uniform_real_distribution<double> value(0, 1);
        std::size_t contacts = 0;
        for (int trial = 0; trial < 3000; ++trial) {
            const double radius = 0.5 + value(random);
            const double margin = trial % 2 == 0 ? value(random) : 0;
            const double spacing = std::nextafter(2 * radius + margin, 0.0);
            const double first = value(random) - 0.5;
            Spheres spheres;
            for (std::uint32_t i = 0; i < 12; ++i)
                spheres.push_back({Vec3(first + i * spacing, 0, 0), radius, i});
            const auto expected = pairsBy(VicinityMethod::bruteForce, spheres, margin);
            contacts += expected.size();
            for (const VicinityMethod method : vicinityMethods)
                QVERIFY2(pairsBy(method, spheres, margin) == expected, nameOf(method).data());
        }
        QVERIFY(contacts > 1000);
    }

    void contactsAtAPlaneAreNotLost()
    {
        // The middle of space lies between two spheres that are closer than the margin by less than a sum's rounding.
        const double margin = 0.043539447926357555;
        const Spheres spheres{{Vec3(-0.092873853202719486, 0, 0), 0.071104129239540695, 0},
                              {Vec3(1.9831350467285891, 0, 0), 1.9613653227654102, 1},
                              {Vec3(-50, 0, 0), 1, 2},
                              {Vec3(50, 0, 0), 1, 3}};
        const std::vector<VicinityPair> expected{{0, 1}};
        for (const VicinityMethod method : vicinityMethods)
            QVERIFY2(pairsBy(method, spheres, margin) == expected, nameOf(method).data());
    }

    void backEndsAgreeOnTwentyThousandSpheres()
    {
        Spheres spheres = randomSpheres(20'000, {1, 1, 1}, 0.03, 20'000);
        for (std::size_t i = 0; i < spheres.size(); i += 100)
            spheres[i].radius *= 5;
        const auto expected = pairsBy(VicinityMethod::bruteForce, spheres, 0.005);
        QVERIFY(expected.size() > spheres.size() / 10);
        for (const VicinityMethod method : vicinityMethods)
            QVERIFY2(pairsBy(method, spheres, 0.005) == expected, nameOf(method).data());
    }

    void backEndsAgreeOnAHundredThousandSpheres_data()
    {
        QTest::addColumn<Spheres>("spheres");
        Spheres scattered;
        for (int row = 0; row < 10; ++row)
            for (int column = 0; column < 10; ++column)
                for (const VicinitySphere& sphere :
                     moved(randomSpheres(1000, {1, 1, 1}, 0.1), {4.0 * column, 4.0 * row, 0.1 * (column + 10 * row)}))
                    scattered.push_back(sphere);
        QTest::newRow("scattered clusters") << scattered;
        QTest::newRow("one body") << turnedLattice(47, 0.1, 0.07);
        QTest::newRow("a cloud") << randomSpheres(100'000, {2, 2, 2}, 0.03);
    }
    void backEndsAgreeOnAHundredThousandSpheres()
    {
        QFETCH(Spheres, spheres);
        const auto expected = pairsBy(VicinityMethod::uniformGrid, spheres, 0);
        QVERIFY(expected.size() > spheres.size() / 10);
        QVERIFY(pairsBy(VicinityMethod::halfPartition, spheres, 0) == expected);
        QVERIFY(pairsBy(VicinityMethod::medianPartition, spheres, 0) == expected);
        // All pairs would take too long to test one by one; those of a few spheres do not.
        std::mt19937 random(3);
        for (int sample = 0; sample < 200; ++sample) {
            const auto sphere = static_cast<std::uint32_t>(random() % spheres.size());
            QCOMPARE(partnersOf(sphere, expected), partnersOf(sphere, spheres, 0));
        }
    }

    void halvingStopsWhereDoublesEnd()
    {
        for (const Spheres& spheres : {closingIn(), randomSpheres(400, {0, 0, 0}, 0)}) {
            PartitionTree tree(PartitionTree::Plane::half);
            tree.findPairs(spheres, 0);
            QVERIFY(tree.statistics().depth <= 200);
        }
    }

    void subsetsOfTheParallelSchemeChangeNothing()
    {
        const Spheres spheres = randomSpheres(1200, {1, 1, 1}, 0.1);
        const auto expected = pairsBy(VicinityMethod::bruteForce, spheres, 0.01);
        for (const std::size_t subsets : {1U, 2U, 3U, 8U, 2000U})
            for (const auto plane : {PartitionTree::Plane::half, PartitionTree::Plane::median}) {
                PartitionTree tree(plane, subsets);
                QVERIFY(tree.findPairs(spheres, 0.01).sorted(spheres.size()) == expected);
            }
    }

    void threadsOfTheParallelSchemeChangeNothing()
    {
        const Spheres spheres = randomSpheres(20'000, {1, 1, 1}, 0.03);
        const auto expected = pairsBy(VicinityMethod::uniformGrid, spheres, 0.01);
        for (const auto plane : {PartitionTree::Plane::half, PartitionTree::Plane::median}) {
            std::vector<VicinityStatistics> statistics;
            for (const int threads : {1, 2, 4}) {
                PartitionTree tree(plane, 8);
                const auto pairs =
                    onThreads(threads, [&] { return tree.findPairs(spheres, 0.01).sorted(spheres.size()); });
                QVERIFY(pairs == expected);
                statistics.push_back(tree.statistics());
                QCOMPARE(statistics.back().sphereTests, statistics.front().sphereTests);
                QCOMPARE(statistics.back().spanningObjects, statistics.front().spanningObjects);
                QCOMPARE(statistics.back().depth, statistics.front().depth);
            }
        }
    }

    void rebuiltStructuresForgetTheOldSpheres()
    {
        const Spheres spheres = randomSpheres(300, {1, 1, 1}, 0.1);
        for (const VicinityMethod method : vicinityMethods) {
            const auto vicinity = makeVicinity(method);
            vicinity->findPairs(randomSpheres(900, {0.5, 0.5, 0.5}, 0.2), 0);
            QVERIFY2(vicinity->findPairs(spheres, 0).sorted(spheres.size()) ==
                         pairsBy(VicinityMethod::bruteForce, spheres, 0),
                     nameOf(method).data());
        }
    }

    void statisticsCountWhatWasDone()
    {
        const Spheres spheres = randomSpheres(2000, {1, 1, 1}, 0.05);
        const auto statisticsOf = [&](VicinityMethod method) {
            const auto vicinity = makeVicinity(method);
            vicinity->findPairs(spheres, 0);
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

    void instructionSetsAndThreadsChangeNothing()
    {
        std::vector<Spheres> scenes{randomSpheres(20'000, {1, 1, 1}, 0.04), turnedLattice(20, 0.1, 0.07), manySizes(),
                                    packedLattice(20, 0.05)};
        for (std::size_t i = 0; i < scenes[1].size(); ++i) { // one body in two halves, with some loose spheres
            scenes[1][i].group = i < 4000 ? 0 : 1;
            scenes[1][i].node = {static_cast<std::int32_t>(i / 400), static_cast<std::int32_t>(i / 20 % 20),
                                 static_cast<std::int32_t>(i % 20)};
            scenes[1][i].loose = i % 97 == 0;
        }
        for (const Spheres& spheres : scenes) {
            const auto expected = pairsBy(VicinityMethod::bruteForce, spheres, 0.005);
            QVERIFY(!expected.empty());
            std::vector<VicinityPair> asFound;
            for (const kernels::Kernels& kernels : kernels::available())
                for (const int threads : {1, 2, 4}) {
                    UniformGrid grid(kernels);
                    const auto order = onThreads(threads, [&] { return pairsAsFound(grid.findPairs(spheres, 0.005)); });
                    QVERIFY2(grid.findPairs(spheres, 0.005).sorted(spheres.size()) == expected, kernels.name);
                    if (asFound.empty())
                        asFound = order;
                    QVERIFY2(order == asFound, kernels.name);
                }
        }
    }
};

QTEST_GUILESS_MAIN(VicinityTest)
#include "vicinity_test.moc"
