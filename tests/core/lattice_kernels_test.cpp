#include "core/mechanics/lattice_kernels.h"

#include <QTest>

#include <array>
#include <cmath>
#include <cstring>
#include <random>
#include <vector>

using namespace knead::kernels;

namespace {

using Column = std::vector<double>;

std::vector<Column> randomColumns(std::size_t columns, std::size_t count, double low, double high, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> value(low, high);
    std::vector<Column> all(columns, Column(count));
    for (Column& column : all)
        for (double& entry : column)
            entry = value(random);
    return all;
}

bool sameBits(const Column& a, const Column& b)
{
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

// An odd count, so that the remainder of every vector width is met too.
constexpr std::size_t count = 1003;

std::vector<Column> connectionForces(const Kernels& kernels)
{
    const auto v = randomColumns(15, count, 0.5, 1.5, 1);
    std::vector<Column> out(6, Column(count, 0.0));
    kernels.connectionForces(count, {{v[0].data(), v[1].data(), v[2].data()}, {v[3].data(), v[4].data(), v[5].data()}},
                             {{v[6].data(), v[7].data(), v[8].data()}, {v[9].data(), v[10].data(), v[11].data()}},
                             v[12].data(), v[13].data(), v[14].data(), {out[0].data(), out[1].data(), out[2].data()},
                             {out[3].data(), out[4].data(), out[5].data()});
    return out;
}

/// Stress of objects whose deformation gradient is diagonal (with K = 1 and a = 1, M is F).
std::vector<Column> diagonalStress(const Kernels& kernels, const Column& stretch)
{
    const Column zero(stretch.size(), 0.0);
    const Column one(stretch.size(), 1.0);
    std::array<const double*, 9> shape;
    shape.fill(zero.data());
    shape[0] = stretch.data();
    shape[4] = shape[8] = one.data();
    std::array<const double*, 6> inverse;
    inverse.fill(zero.data());
    inverse[0] = inverse[1] = inverse[2] = one.data();
    std::vector<Column> out(10, Column(stretch.size()));
    std::array<double*, 9> stress;
    for (std::size_t c = 0; c < 9; ++c)
        stress[c] = out[c].data();
    kernels.volumetricStress(stretch.size(),
                             {shape.data(), inverse.data(), one.data(), zero.data(), 1, stress.data(), out[9].data()});
    return out;
}

} // namespace

class LatticeKernelsTest : public QObject {
    Q_OBJECT

private slots:
    void everyInstructionSetGivesTheSameBits()
    {
        const auto stretch = randomColumns(1, count, 0.05, 20, 2)[0];
        const auto forces = connectionForces(available().front());
        const auto stress = diagonalStress(available().front(), stretch);
        for (const Kernels& kernels : available()) {
            const auto otherForces = connectionForces(kernels);
            const auto otherStress = diagonalStress(kernels, stretch);
            for (std::size_t c = 0; c < forces.size(); ++c)
                QVERIFY2(sameBits(forces[c], otherForces[c]), kernels.name);
            for (std::size_t c = 0; c < stress.size(); ++c)
                QVERIFY2(sameBits(stress[c], otherStress[c]), kernels.name);
        }
    }

    void connectionForceFollowsThePaper()
    {
        const double x0[] = {0}, x1[] = {3}, zero[] = {0}, y1[] = {4}, u1[] = {1}, k[] = {10}, l[] = {4},
                     time[] = {0.5};
        double f[3] = {0, 0, 0};
        double b[3] = {0, 0, 0};
        best().connectionForces(1, {{x0, zero, zero}, {zero, zero, zero}}, {{x1, y1, zero}, {u1, zero, zero}}, k, l,
                                time, {&f[0], &f[1], &f[2]}, {&b[0], &b[1], &b[2]});
        // |d| = 5, stretch 1, v_n = 0.6: spring 10, damper 10 0.5 0.6 = 3, along (0.6, 0.8, 0)
        QVERIFY(std::abs(f[0] - 6) < 1e-12);
        QVERIFY(std::abs(f[1] - 8) < 1e-12);
        QCOMPARE(f[2], 0.0);
        QVERIFY(std::abs(b[0] - 1.8) < 1e-12);
        QVERIFY(std::abs(b[1] - 2.4) < 1e-12);
    }

    void flowStopsAtYieldAndKeepsItsAccount()
    {
        const auto v = randomColumns(12, count, 0.5, 1.5, 3);
        const Column yield(count, 0.05);
        const Column hardening(count, 0.3);
        const Column share(count, 1.0);
        const auto flow = [&](const Kernels& kernels, Column& length, Column& plastic) {
            Column lanes(sumLanes, 0.0);
            kernels.flow(count, {{v[0].data(), v[1].data(), v[2].data()},
                                 {v[3].data(), v[4].data(), v[5].data()},
                                 v[6].data(),
                                 v[7].data(),
                                 v[8].data(),
                                 yield.data(),
                                 hardening.data(),
                                 share.data(),
                                 length.data(),
                                 plastic.data(),
                                 lanes.data()});
            double sum = 0;
            for (const double lane : lanes)
                sum += lane;
            return sum;
        };
        Column length = v[9];
        Column plastic(count, 0.0);
        const double dissipated = flow(available().front(), length, plastic);
        double expected = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const double distance = std::hypot(v[3][i] - v[0][i], v[4][i] - v[1][i], v[5][i] - v[2][i]);
            const double strain = std::log(distance / v[9][i]) - (v[6][i] + v[7][i]) / 6;
            const double beyond = std::max(0.0, std::abs(strain) - 0.05);
            const double nominal = strain > 0 ? v[9][i] * (1 + beyond) : v[9][i] / (1 + beyond);
            QVERIFY(std::abs(length[i] - nominal) < 1e-13);
            QVERIFY(std::abs(plastic[i] - beyond) < 1e-13);
            expected += 0.5 * v[8][i] * (std::pow(distance - v[9][i], 2) - std::pow(distance - nominal, 2));
        }
        QVERIFY(std::abs(dissipated / expected - 1) < 1e-10);
        for (const Kernels& kernels : available()) {
            Column otherLength = v[9];
            Column otherPlastic(count, 0.0);
            QCOMPARE(flow(kernels, otherLength, otherPlastic), dissipated);
            QVERIFY2(sameBits(otherLength, length) && sameBits(otherPlastic, plastic), kernels.name);
        }
    }

    void squashedSurroundingsArePushedBackByTheGradientOfAnEnergy()
    {
        // theta goes on as its tangent below a tenth of the volume: theta(J) = ln 0.1 + J / 0.1 - 1, p = theta / 0.1.
        const Column ratios{0.05, 0.0, -0.5};
        const auto out = diagonalStress(best(), ratios);
        for (std::size_t i = 0; i < ratios.size(); ++i) {
            const double theta = std::log(0.1) + ratios[i] / 0.1 - 1;
            QVERIFY(std::abs(out[9][i] - theta) < 1e-13);
            QVERIFY(std::abs(out[0][i] - theta / 0.1) < 1e-12);
        }
        QVERIFY(std::abs(out[9][1] - flatDilatation) < 1e-12);
    }

    void coincidentObjectsGiveNoForce()
    {
        const double zero[] = {0}, k[] = {10}, l[] = {1};
        double f[3] = {0, 0, 0};
        double b[3] = {0, 0, 0};
        best().connectionForces(1, {{zero, zero, zero}, {zero, zero, zero}}, {{zero, zero, zero}, {zero, zero, zero}},
                                k, l, k, {&f[0], &f[1], &f[2]}, {&b[0], &b[1], &b[2]});
        QCOMPARE(f[0], 0.0);
        QCOMPARE(b[0], 0.0);
    }

    void dilatationIsTheLogarithmOfTheVolumeRatio()
    {
        const Column stretch{0.1, 0.25, 0.5, 0.70710678118654752, 0.99, 1.0, 1.0000001, 1.41421356, 2.0, 7.5, 1e3};
        const auto out = diagonalStress(best(), stretch);
        for (std::size_t i = 0; i < stretch.size(); ++i) {
            const double expected = std::log(stretch[i]);
            QVERIFY2(std::abs(out[9][i] - expected) <= 4e-16 * std::max(1.0, std::abs(expected)),
                     qPrintable(QString::number(stretch[i])));
            // p F^-T: the first entry is theta / stretch, the second theta.
            QVERIFY(std::abs(out[0][i] - expected / stretch[i]) <=
                    1e-14 * std::max(1.0, std::abs(expected / stretch[i])));
            QVERIFY(std::abs(out[4][i] - expected) <= 1e-14 * std::max(1.0, std::abs(expected)));
        }
    }
};

QTEST_GUILESS_MAIN(LatticeKernelsTest)
#include "lattice_kernels_test.moc"
