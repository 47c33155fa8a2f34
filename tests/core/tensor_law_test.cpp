// The law of material that yields: its forces are those of an energy, it flows at the stress that was typed in every direction,
// and its plastic state keeps its volume and its account.
#include "core/aggregate/fill.h"
#include "support/placed_block.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

using namespace knead;

namespace {

constexpr double spacing = Block::spacing;

Material steel()
{
    Material material;
    material.density = 7850;
    material.youngsModulus = 210e9;
    material.poissonRatio = 0.3;
    material.dampingRatio = 0;
    material.yieldStress = 250e6;
    return material;
}

Material clay()
{
    Material material;
    material.density = 1700;
    material.youngsModulus = 5e5;
    material.poissonRatio = 0.45;
    material.dampingRatio = 0;
    material.yieldStress = 1e4;
    return material;
}

Mat3 pulledAlong(const Vec3& axis, double logarithmic)
{
    const Vec3 n = axis.normalized();
    return std::exp(logarithmic) * n * n.transpose() +
           std::exp(-0.5 * logarithmic) * (Mat3::Identity() - n * n.transpose());
}

double vonMises(const Mat3& stress)
{
    return std::sqrt(1.5) * (stress - stress.trace() / 3 * Mat3::Identity()).norm();
}

} // namespace

class TensorLawTest : public QObject {
    Q_OBJECT

private slots:
    void flowStressIsThatTypedInEveryDirection_data()
    {
        QTest::addColumn<double>("u");
        QTest::addColumn<double>("v");
        QTest::addColumn<double>("w");
        QTest::addColumn<double>("strain");
        for (const double strain : {0.3, -0.3}) {
            QTest::addRow("[100] %+.1f", strain) << 1.0 << 0.0 << 0.0 << strain;
            QTest::addRow("[110] %+.1f", strain) << 1.0 << 1.0 << 0.0 << strain;
            QTest::addRow("[111] %+.1f", strain) << 1.0 << 1.0 << 1.0 << strain;
            QTest::addRow("[123] %+.1f", strain) << 1.0 << 2.0 << 3.0 << strain;
        }
    }
    void flowStressIsThatTypedInEveryDirection()
    {
        QFETCH(double, u);
        QFETCH(double, v);
        QFETCH(double, w);
        QFETCH(double, strain);
        for (const double hardening : {0.0, 1e9}) {
            Material material = steel();
            material.hardening = hardening;
            Block block(material, {4, 4, 4});
            constexpr int steps = 60;
            for (int n = 1; n <= steps; ++n) {
                const Mat3 f = pulledAlong({u, v, w}, strain * n / steps);
                block.flow(f);
                const double plastic = block.connections->changes().plastic.equivalentStrain[0];
                if (plastic == 0)
                    continue;
                const double expected = material.yieldStress + hardening * plastic;
                const double found = vonMises(block.stress(f));
                QVERIFY2(std::abs(found / expected - 1) < 0.01,
                         qPrintable(QString("%1 of the typed stress at a strain of %2")
                                        .arg(found / expected)
                                        .arg(strain * n / steps)));
            }
            QVERIFY(std::abs(block.connections->changes().plastic.equivalentStrain[0] - std::abs(strain)) < 0.01);
        }
    }

    void flowDoesNotDependOnTheTimeItTakes()
    {
        const auto stressAfter = [](int steps) {
            Block block(clay(), {3, 3, 3});
            Mat3 f;
            for (int n = 1; n <= steps; ++n)
                block.flow(f = pulledAlong({1, 0.3, 0}, -0.2 * n / steps), 20.0 / n);
            return vonMises(block.stress(f));
        };
        QVERIFY(std::abs(stressAfter(10) / stressAfter(400) - 1) < 0.01);
    }

    void relaxationLetsStressBeyondYieldDecay()
    {
        Material slow = clay();
        slow.relaxationTime = 0.5;
        Block block(slow, {3, 3, 3});
        const Mat3 f = pulledAlong({1, 0, 0}, 0.04);
        block.flow(f, 0);
        const double beyond = vonMises(block.stress(f)) - slow.yieldStress;
        for (int n = 0; n < 200; ++n)
            block.flow(f, 0.5 / 200);
        const double left = vonMises(block.stress(f)) - slow.yieldStress;
        QVERIFY(std::abs(left / beyond - std::exp(-1)) < 0.01);
    }

    /// sigma_y + 3 mu tau times the rate of strain (Perzyna), whether a step is a hundredth of tau or sixteen times as long.
    void steadyFlowBearsTheSameInStepsOfAnyLength()
    {
        constexpr double rate = 2; // [1/s]
        Material slow = clay();
        slow.relaxationTime = 0.002;
        const double wanted = slow.yieldStress + 3 * slow.shearModulus() * slow.relaxationTime * rate;
        QVERIFY(wanted > 1.2 * slow.yieldStress);
        for (const double step : {2e-5, 2e-4, 0.002, 1.0 / 60, 1.0 / 30}) {
            Block block(slow, {3, 3, 3});
            Mat3 f = Mat3::Identity();
            const int count = std::max(3, static_cast<int>(std::ceil(0.04 / step)));
            for (int n = 1; n <= count; ++n) {
                f = pulledAlong({1, 0, 0}, rate * step * n);
                block.flow(f, step);
            }
            QVERIFY2(std::abs(vonMises(block.stress(f)) / wanted - 1) < 0.02, qPrintable(QString::number(step)));
        }
    }

    /// Places at random about a sheared shape, after a flow: what is left is elastic.
    void forcesAreTheGradientOfTheEnergy()
    {
        for (const Material& material : {steel(), clay()}) {
            Block block(material, {3, 2, 3});
            const double big = material.yieldStress / material.youngsModulus * 10;
            Mat3 f = pulledAlong({1, 0.2, 0.1}, big);
            f(0, 1) += big;
            block.flow(f);
            std::mt19937 random(3);
            std::uniform_real_distribution<double> part(-1, 1);
            for (ObjectIndex i = 0; i < block.body.aggregate->size(); ++i)
                block.state.position.add(i, 0.02 * spacing * Vec3(part(random), part(random), part(random)));
            block.connections->computeForces(block.state);
            const VectorArray force = block.state.force;
            double largest = 0;
            for (std::size_t i = 0; i < force.size(); ++i)
                largest = std::max(largest, force.at(i).norm());
            const double h = 1e-5 * spacing;
            for (ObjectIndex i = 0; i < block.body.aggregate->size(); i += 5)
                for (int c = 0; c < 3; ++c) {
                    VectorArray moved = block.state.position;
                    moved.add(i, h * Vec3::Unit(c));
                    const double ahead = block.connections->energy(moved);
                    moved.add(i, -2 * h * Vec3::Unit(c));
                    const double behind = block.connections->energy(moved);
                    QVERIFY(std::abs(force.at(i)[c] + (ahead - behind) / (2 * h)) < 1e-5 * largest);
                }
        }
    }

    void flowTakesOutTheEnergyThatItSays()
    {
        Block block(clay(), {3, 3, 3});
        std::mt19937 random(5);
        std::uniform_real_distribution<double> part(-1, 1);
        block.flow(pulledAlong({1, 0.5, 0.2}, 0.3));
        for (ObjectIndex i = 0; i < block.body.aggregate->size(); ++i)
            block.state.position.add(i, 0.1 * spacing * Vec3(part(random), part(random), part(random)));
        const double before = block.connections->energy(block.state);
        block.connections->computeForces(block.state, 0, 1);
        const double gone = block.connections->acceptFlow();
        const double after = block.connections->energy(block.state);
        QVERIFY(gone > 0.1 * before);
        QVERIFY(std::abs(gone - (before - after)) < 1e-9 * before);
    }

    void aTrialThatIsNotTakenLeavesNothing()
    {
        Block block(clay(), {3, 3, 3});
        block.flow(pulledAlong({1, 0, 0}, 0.1));
        const auto kept = block.connections->changes().plastic;
        for (ObjectIndex i = 0; i < block.body.aggregate->size(); ++i)
            block.state.position.set(i, pulledAlong({1, 0, 0}, 0.2) * block.rest(i));
        block.connections->computeForces(block.state, 0, 1);
        block.connections->rejectFlow();
        const auto& now = block.connections->changes().plastic;
        QVERIFY(now.nominalLength == kept.nominalLength && now.metric == kept.metric);
        QVERIFY(now.equivalentStrain == kept.equivalentStrain && now.damage == kept.damage);
    }

    /// What does not flow is not written. A body goes on from trial to trial, another one begins anew from its state each time.
    void whatFlowedBeforeLeavesNoTrace()
    {
        Block block(clay(), {18, 16, 16}); // several blocks of the loops
        std::mt19937 random(3);
        std::uniform_real_distribution<double> part(0, 1);
        const auto sameBits = [](const LaneVector<double>& a, const LaneVector<double>& b) { return a == b; };
        std::size_t flowed = 0;
        for (int n = 0; n < 24; ++n) {
            // Pulled within a ball only, now and then nowhere.
            const Vec3 middle = spacing * Vec3(12 * part(random) - 6, 12 * part(random) - 6, 12 * part(random) - 6);
            const double size = n % 4 == 3 ? 0 : 0.02 + 0.1 * part(random);
            for (ObjectIndex i = 0; i < block.state.size(); ++i) {
                const Vec3 from = (block.rest(i) - middle) / (6 * spacing);
                if (from.norm() < 1)
                    block.state.position.add(i, size * spacing * std::pow(1 - from.norm(), 2) * Vec3(n % 2, 1, n % 3));
            }
            if (n % 6 == 5)
                block.connections->renormalize(block.state, {}, 0.3);
            StructuralConnections fresh(block.body.aggregate, block.materials);
            fresh.restore(block.connections->changes());
            ObjectState other = block.state;
            if (n % 5 == 4) { // a trial that is not taken
                const VectorArray kept = block.state.position;
                block.shake(0.05, static_cast<unsigned>(n));
                block.connections->computeForces(block.state, 0, 1);
                block.connections->rejectFlow();
                block.state.position = kept;
            }
            block.connections->computeForces(block.state, 0, 1);
            fresh.computeForces(other, 0, 1);
            QVERIFY(block.state.force.hasSameBits(other.force));
            const std::uint64_t version = block.connections->lengthVersion();
            QCOMPARE(block.connections->acceptFlow(), fresh.acceptFlow());
            flowed += block.connections->lengthVersion() > version ? 1 : 0;
            const auto& one = block.connections->changes().plastic;
            const auto& two = fresh.changes().plastic;
            QVERIFY(std::ranges::equal(one.nominalLength, two.nominalLength, sameBits));
            QVERIFY(std::ranges::equal(one.metric, two.metric, sameBits));
            QVERIFY(one.equivalentStrain == two.equivalentStrain && one.damage == two.damage);
        }
        QVERIFY2(flowed > 8 && flowed < 22, qPrintable(QString::number(flowed)));
    }

    void theMetricKeepsItsVolume()
    {
        Block block(clay(), {3, 3, 3});
        Mat3 f = Mat3::Identity();
        for (int n = 0; n < 200; ++n) {
            const double angle = 0.3 * n;
            block.flow(f = pulledAlong({std::cos(angle), std::sin(angle), 0.3}, 0.05) * f);
        }
        const auto& metric = block.connections->changes().plastic.metric;
        for (std::size_t i = 0; i < metric[0].size(); ++i) {
            Mat3 c;
            c << metric[0][i], metric[3][i], metric[4][i], metric[3][i], metric[1][i], metric[5][i], metric[4][i],
                metric[5][i], metric[2][i];
            QVERIFY(std::abs(c.determinant() - 1) < 1e-9 * c.norm() * c.norm() * c.norm());
        }
    }

    void aTurnedBodyFeelsWhatItFelt()
    {
        const Mat3 turn = Eigen::AngleAxisd(1.1, Vec3(1, 2, -1).normalized()).toRotationMatrix();
        Block here(clay(), {3, 3, 2});
        Block there(clay(), {3, 3, 2});
        for (int n = 1; n <= 10; ++n) {
            const Mat3 f = pulledAlong({1, 0, 0}, 0.02 * n);
            here.flow(f);
            there.flow(turn * f);
        }
        for (ObjectIndex i = 0; i < here.body.aggregate->size(); ++i)
            QVERIFY((turn * here.state.force.at(i) - there.state.force.at(i)).norm() < 1e-9);
    }

    void damageCountsTensionFullyShearByHalfAndCompressionNot()
    {
        const auto damageOf = [](const std::function<Mat3(double)>& path) {
            Block block(clay(), {3, 3, 3});
            for (int n = 1; n <= 100; ++n)
                block.flow(path(n / 100.0));
            return block.connections->changes().plastic.damage[0] /
                   block.connections->changes().plastic.equivalentStrain[0];
        };
        // Without pressure besides that of the load: lateral strains that leave the sides free.
        const auto uniaxial = [](double sign) {
            return [sign](double t) -> Mat3 {
                const Material material = clay();
                const double bulk = material.lameLambda() + 2.0 / 3 * material.shearModulus();
                return std::exp(sign * material.yieldStress / (9 * bulk)) * pulledAlong({1, 0, 0}, sign * 0.5 * t);
            };
        };
        QVERIFY(damageOf(uniaxial(1)) > 0.97);
        QVERIFY(damageOf(uniaxial(-1)) < 0.03);
        const double shear = damageOf([](double t) -> Mat3 {
            Mat3 f = Mat3::Identity();
            f(0, 1) = 0.5 * t;
            return f;
        });
        QVERIFY(std::abs(shear - 0.5) < 0.02);
    }
};

QTEST_GUILESS_MAIN(TensorLawTest)
#include "tensor_law_test.moc"
