#include "core/vicinity/uniform_grid.h"

#include <QTest>

#include <algorithm>
#include <random>

using namespace knead;

namespace {

using Spheres = std::vector<VicinitySphere>;

Spheres randomSpheres(std::size_t count, const Vec3& extent, double radius)
{
    std::mt19937 random(11);
    std::uniform_real_distribution<double> value(-1, 1);
    Spheres spheres;
    for (std::size_t i = 0; i < count; ++i)
        spheres.push_back({extent.cwiseProduct(Vec3(value(random), value(random), value(random))),
                           radius * (0.6 + 0.4 * value(random)), static_cast<std::uint32_t>(i % 3)});
    return spheres;
}

std::vector<UniformGrid::Pair> bruteForce(const Spheres& spheres, double margin)
{
    std::vector<UniformGrid::Pair> pairs;
    for (std::uint32_t i = 0; i < spheres.size(); ++i)
        for (std::uint32_t j = i + 1; j < spheres.size(); ++j)
            if (spheres[i].group != spheres[j].group &&
                (spheres[i].center - spheres[j].center).norm() < spheres[i].radius + spheres[j].radius + margin)
                pairs.push_back({i, j});
    return pairs;
}

} // namespace

class UniformGridTest : public QObject {
    Q_OBJECT

private slots:
    void pairsEqualBruteForce_data()
    {
        QTest::addColumn<Spheres>("spheres");
        QTest::newRow("packed") << randomSpheres(1500, {1, 1, 1}, 0.1);
        QTest::newRow("sparse") << randomSpheres(500, {1000, 1000, 1000}, 40);
        QTest::newRow("in a plane") << randomSpheres(800, {1, 1, 0}, 0.05);
        QTest::newRow("coincident") << randomSpheres(120, {0, 0, 0}, 1);
        QTest::newRow("points") << randomSpheres(100, {1, 1, 1}, 0);
        Spheres withHuge = randomSpheres(600, {1, 1, 1}, 0.02);
        withHuge.push_back({Vec3::Zero(), 5, 7});
        QTest::newRow("one huge") << withHuge;
        QTest::newRow("far away") << Spheres{{Vec3(1e15, 0, 0), 1, 0}, {Vec3(1e15, 1, 0), 1, 1}, {Vec3(-1e300, 0, 0), 1, 2}};
        QTest::newRow("none") << Spheres{};
    }
    void pairsEqualBruteForce()
    {
        QFETCH(Spheres, spheres);
        for (const double margin : {0.0, 0.03}) {
            UniformGrid grid;
            grid.build(spheres, margin);
            QVERIFY(grid.pairs() == bruteForce(spheres, margin));
        }
    }

    void boxHoldsWhatLiesInIt()
    {
        const Spheres spheres = randomSpheres(2000, {1, 1, 1}, 0.05);
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

QTEST_GUILESS_MAIN(UniformGridTest)
#include "uniform_grid_test.moc"
