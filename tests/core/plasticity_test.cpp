// Flow of clay: it keeps its volume and its new shape, hardens, and its energy adds up.
#include "support/material_scenes.h"

#include <QTest>

using namespace knead;

namespace {

constexpr double spacing = 2e-3;
constexpr int cells = 6;
constexpr double height = cells * spacing;

struct Pressed {
    double peakForce = 0;
    double volumePressed = 0; ///< by the volume before
    double volumeAfter = 0;
    double springback = 0; ///< by the way pressed
    double width = 0;      ///< at half height, by the width before
    double imbalance = 0;  ///< largest on the way, by the most work that the tool had done
    EnergyLedger energy;
    Health health;
};

/// Between the lower and the upper face.
double meanHeight(const Aggregate& aggregate, const std::vector<Vec3>& places)
{
    double sum = 0;
    int count = 0;
    for (ObjectIndex i = 0; i < aggregate.size(); ++i)
        if (const double z = aggregate.lattice.position(i).z(); std::abs(std::abs(z) - height / 2) < 1e-6) {
            sum += z > 0 ? places[i].z() : -places[i].z();
            ++count;
        }
    return 2 * sum / count;
}

double middleWidth(const Aggregate& aggregate, const std::vector<Vec3>& places)
{
    double low = 0;
    double high = 0;
    for (ObjectIndex i = 0; i < aggregate.size(); ++i)
        if (std::abs(aggregate.lattice.position(i).z()) < 1e-6 && std::abs(aggregate.lattice.position(i).y()) < 1e-6) {
            low = std::min(low, places[i].x());
            high = std::max(high, places[i].x());
        }
    return high - low;
}

Pressed press(const Material& material, double share, double friction = 1)
{
    const Body block = scenes::box({cells, cells, cells}, spacing, material);
    const Aggregate& aggregate = *block.aggregate;
    scenes::Press how{.share = share, .friction = friction};
    Simulation simulation(scenes::pressedBlock(block, height, how));
    Pressed result;
    double work = 0;
    double imbalance = 0;
    const double before = scenes::blockVolume(aggregate, simulation.snapshot()->bodies[0].positions);
    const auto runUntil = [&](double time) {
        while (simulation.time() < time && simulation.health().ok) {
            for (int i = 0; i < 100; ++i)
                simulation.step();
            const auto shot = simulation.snapshot();
            work = std::max(work, shot->energy.toolWork);
            imbalance = std::max(imbalance, std::abs(shot->energy.imbalance));
        }
    };
    runUntil(how.pressTime + how.waitTime);
    result.volumePressed = scenes::blockVolume(aggregate, simulation.snapshot()->bodies[0].positions) / before;
    runUntil(how.pressTime + how.waitTime + how.releaseTime + 0.2);
    const auto end = simulation.snapshot();
    result.volumeAfter = scenes::blockVolume(aggregate, end->bodies[0].positions) / before;
    result.springback = (meanHeight(aggregate, end->bodies[0].positions) / height - (1 - share)) / share;
    result.width = middleWidth(aggregate, end->bodies[0].positions) / height;
    result.peakForce = end->tools[0].peakForce;
    result.energy = end->energy;
    result.health = simulation.health();
    result.imbalance = imbalance / work;
    qInfo("pressed %.0f %%: peak %.2f N, volume pressed %.4f after %.4f, springback %.3f, width %.3f, imbalance %.4f",
          100 * share, result.peakForce, result.volumePressed, result.volumeAfter, result.springback, result.width,
          result.imbalance);
    return result;
}

/// The bundled clay by 30 %, which several compare with.
const Pressed& pressedClay()
{
    static const Pressed result = press(scenes::clay(), 0.3);
    return result;
}

} // namespace

class PlasticityTest : public QObject {
    Q_OBJECT

private slots:
    void clayKeepsItsVolumeAndItsNewShape_data()
    {
        QTest::addColumn<double>("share");
        QTest::addColumn<double>("friction");
        QTest::addColumn<double>("volumeError");
        QTest::newRow("30 %") << 0.3 << 1.0 << 0.01;
        QTest::newRow("50 %") << 0.5 << 1.0 << 0.02;
        QTest::newRow("50 %, without friction") << 0.5 << 0.0 << 0.005;
    }
    void clayKeepsItsVolumeAndItsNewShape() // V13
    {
        QFETCH(double, share);
        QFETCH(double, friction);
        QFETCH(double, volumeError);
        const Pressed result = share == 0.3 ? pressedClay() : press(scenes::clay(), share, friction);
        QVERIFY2(result.health.ok, result.health.message.english().c_str());
        QVERIFY(std::abs(result.volumePressed - 1) < volumeError);
        QVERIFY(std::abs(result.volumeAfter - 1) < volumeError);
        QVERIFY(result.springback < 0.10);
        const double heightAfter = 1 - share * (1 - result.springback);
        QVERIFY(result.width > 0.97 / std::sqrt(heightAfter)); // what it lost in height it gained in width
        QVERIFY(result.imbalance < 0.005);
        QVERIFY(result.energy.plastic > 0.5 * result.energy.toolWork);
    }

    void rubberSpringsBack()
    {
        Material rubber = scenes::clay();
        rubber.yieldStress = 0;
        rubber.shapeDamping = 50;
        const Pressed result = press(rubber, 0.3);
        QVERIFY(result.springback > 0.97);
        QCOMPARE(result.energy.plastic, 0.0);
        QVERIFY(result.imbalance < 0.005);
    }

    void hardeningTakesMoreForceAndSpringsBackFurther()
    {
        Material hard = scenes::clay();
        hard.hardening = 0.1 * hard.youngsModulus;
        const Pressed& soft = pressedClay();
        const Pressed hardened = press(hard, 0.3);
        QVERIFY(hardened.peakForce > 1.2 * soft.peakForce);
        QVERIFY(hardened.springback > 1.5 * soft.springback);
    }

    void slowMaterialResistsFastPressing()
    {
        Material slow = scenes::clay();
        slow.relaxationTime = 0.05;
        QVERIFY(press(slow, 0.3).peakForce > 1.3 * pressedClay().peakForce);
    }

    void belowYieldNothingFlows()
    {
        Material strong = scenes::clay();
        strong.yieldStress = 1e9;
        QCOMPARE(press(strong, 0.1).energy.plastic, 0.0);
    }
};

QTEST_GUILESS_MAIN(PlasticityTest)
#include "plasticity_test.moc"
