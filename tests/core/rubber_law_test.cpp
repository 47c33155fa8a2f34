// Rubberlike material: energy and force of a lattice are those of the law typed, at any stretch; forces are the gradient of the
// energy, whatever the places; the bound of the stable step holds; nothing of a body collapses.
#include "core/mechanics/hyperelastic_law.h"
#include "core/mechanics/stress_law.h"
#include "core/simulation/simulation.h"
#include "support/placed_block.h"
#include "support/scenes.h"
#include "support/shapes.h"
#include "support/thread_limit.h"

#include <QTest>

#include <cmath>
#include <memory>

using namespace knead;

namespace {

constexpr double spacing = Block::spacing;

Material rubber(double nu, double secondShare = 0, double locking = 0)
{
    Material material;
    material.density = 1000;
    material.youngsModulus = 1e6;
    material.poissonRatio = nu;
    material.dampingRatio = 0;
    material.rubberlike = 1;
    material.secondInvariantShare = secondShare;
    material.lockingElongation = locking;
    return material;
}

/// The energy density [Pa] in the words of text books, for diagonal F; A(I1) from the series of Arruda and Boyce.
double energyDensity(const Material& m, const Vec3& stretch)
{
    const double mu = m.shearModulus();
    const double bulk = m.lameLambda() + 2 * mu / 3;
    const double J = stretch.prod();
    const Vec3 squared = stretch.array().square() * std::pow(J, -2.0 / 3);
    const double first = squared.sum();
    const double second = squared[0] * squared[1] + squared[1] * squared[2] + squared[2] * squared[0];
    double chains = first - 3;
    if (m.lockingElongation > 0) {
        const double s = 1 + m.lockingElongation;
        const double N = (s * s + 2 / s) / 3;
        const double c[] = {1.0 / 2, 1.0 / 20, 11.0 / 1050, 19.0 / 7000, 519.0 / 673750};
        double initial = 0;
        chains = 0;
        for (int n = 1; n <= 5; ++n) {
            chains += 2 * c[n - 1] * (std::pow(first, n) - std::pow(3, n)) / std::pow(N, n - 1);
            initial += 2 * c[n - 1] * n * std::pow(3.0 / N, n - 1);
        }
        chains /= initial;
    }
    return bulk / 2 * std::log(J) * std::log(J) +
           mu / 2 * ((1 - m.secondInvariantShare) * chains + m.secondInvariantShare * (second - 3));
}

/// Its slope with one stretch: nominal stress [Pa].
double nominalStress(const Material& m, Vec3 stretch, int axis)
{
    const double h = 1e-6;
    stretch[axis] += h;
    const double ahead = energyDensity(m, stretch);
    stretch[axis] -= 2 * h;
    return (ahead - energyDensity(m, stretch)) / (2 * h);
}

/// Stretches of a bar (free = 2) or sheet (free = 1) whose other sides bear nothing.
Vec3 freeSideways(const Material& m, double stretch, int free)
{
    double low = 0.05, high = 3;
    const auto at = [&](double side) { return free == 2 ? Vec3(stretch, side, side) : Vec3(stretch, stretch, side); };
    for (int i = 0; i < 100; ++i) {
        const double middle = (low + high) / 2;
        (nominalStress(m, at(middle), 2) > 0 ? high : low) = middle;
    }
    return at(low);
}

} // namespace

class RubberLawTest : public QObject {
    Q_OBJECT

private slots:
    void latticeHasTheEnergyAndTheForceOfTheLaw_data()
    {
        QTest::addColumn<double>("nu");
        QTest::addColumn<double>("share");
        QTest::addColumn<double>("locking");
        for (const double nu : {0.3, 0.45, 0.49}) {
            QTest::addRow("neo-Hooke %.2f", nu) << nu << 0.0 << 0.0;
            QTest::addRow("Mooney %.2f", nu) << nu << 0.3 << 0.0;
            QTest::addRow("Arruda-Boyce %.2f", nu) << nu << 0.1 << 4.0;
        }
    }
    void latticeHasTheEnergyAndTheForceOfTheLaw()
    {
        QFETCH(double, nu);
        QFETCH(double, share);
        QFETCH(double, locking);
        const Material material = rubber(nu, share, locking);
        Block block(material, {4, 3, 3});
        std::vector<Vec3> stretches{{1, 1, 0.8}, {1, 1, 0.5}, {1, 1, 1.2}, {1, 1, 2}};
        for (const double s : {0.5, 0.8, 1.25, 1.5, 2.0, 3.0})
            stretches.push_back(freeSideways(material, s, 2));
        for (const double s : {0.8, 1.25, 1.5, 2.0, 3.0})
            stretches.push_back(freeSideways(material, s, 1));
        for (const Vec3& stretch : stretches) {
            block.follow(stretch.asDiagonal());
            const double energy = block.connections->energy(block.state) / block.volume;
            QVERIFY2(std::abs(energy / energyDensity(material, stretch) - 1) < 1e-6,
                     qPrintable(QString::number(stretch[0])));
            const double whole = nominalStress(material, stretch, stretch[0] == 1 ? 2 : 0);
            for (int axis = 0; axis < 3; ++axis)
                QVERIFY2(std::abs(block.firstPiolaStress()(axis, axis) - nominalStress(material, stretch, axis)) <
                             1e-5 * std::abs(whole),
                         qPrintable(QString::number(stretch[0])));
        }
    }

    /// tau = mu gamma for all shares where chains do not lock, and gamma^2 mu / 2.
    void simpleShearIsThatOfTheModulus()
    {
        for (const double share : {0.0, 0.4}) {
            const Material material = rubber(0.49, share);
            Block block(material, {3, 3, 3});
            for (const double gamma : {0.01, 0.5, 1.0, 2.0, 3.0}) {
                Mat3 f = Mat3::Identity();
                f(0, 1) = gamma;
                block.follow(f);
                const double mu = material.shearModulus();
                QVERIFY(std::abs(block.firstPiolaStress()(0, 1) / (mu * gamma) - 1) < 1e-6);
                QVERIFY(std::abs(block.connections->energy(block.state) / block.volume / (mu * gamma * gamma / 2) - 1) <
                        1e-6);
            }
        }
    }

    void skinsAndObjectsBearWhatTheLatticeBears()
    {
        Mat3 f;
        f << 1.6, 0.4, -0.1, 0.2, 0.9, 0.3, 0, -0.2, 0.8;
        for (const Material& material : {rubber(0.49), rubber(0.45, 0.3, 3)}) {
            Block block(material, {3, 3, 3});
            block.follow(f);
            const Mat3 cauchy = block.firstPiolaStress() * f.transpose() / f.determinant();
            const Mat3 found = cauchyStress(f, Mat3::Identity(), material);
            QVERIFY((found - cauchy).norm() < 1e-6 * cauchy.norm());
        }
    }

    /// Beside rubber, elastic material is neo-Hooke, in forces and in stress.
    void elasticMaterialBesideRubberBearsWhatTheLatticeBears()
    {
        Material plain = rubber(0.4);
        plain.rubberlike = 0;
        Block block(plain, {4, 3, 3});
        block.materials.set({0}, rubber(0.4));
        block.connections->updateMaterials();
        const Mat3 f = Vec3(1.8, 0.8, 0.7).asDiagonal();
        block.follow(f);
        const Mat3 cauchy = block.firstPiolaStress() * f.transpose() / f.determinant();
        const Mat3 found = cauchyStress(f, Mat3::Identity(), bearingMaterial(plain, block.materials));
        QVERIFY((found - cauchy).norm() < 1e-6 * cauchy.norm());
        QVERIFY((cauchyStress(f, Mat3::Identity(), plain) - cauchy).norm() > 0.1 * cauchy.norm());
    }

    /// Three cells across, under a small force at the end: Timoshenko's deflection.
    void thinWallsBendAsTheyShould()
    {
        for (const int across : {3, 4}) {
            const Material material = rubber(0.49);
            const Eigen::Vector3i cells(8 * across, across, across);
            Scene scene = scenes::cantilever(cells, spacing, material, Vec3::Zero());
            scene.integrator = Integrator::implicitEuler;
            const double side = across * spacing;
            const double length = 8 * side;
            const double bending = material.youngsModulus * std::pow(side, 4) / 12;
            const double force = 3e-3 * bending / (length * length);
            Load load{.name = "end", .body = 0, .faces = {1}};
            const Aggregate& aggregate = *scene.bodies[0].aggregate;
            load.patch = loadPatch(aggregate, shapes::box(spacing * cells.cast<double>()), {1}, std::nullopt);
            load.amount = {.force = Vec3(0, 0, force)};
            scene.loads.push_back(load);
            Simulation simulation(scene);
            QVERIFY(simulation.findBalance(1).converged);
            const std::vector<Vec3> displacements = simulation.snapshot()->bodies[0].displacements();
            double found = 0;
            int count = 0;
            for (ObjectIndex i = 0; i < aggregate.size(); ++i)
                if (aggregate.lattice.position(i).x() > 0.499 * length) {
                    found += displacements[i].z();
                    ++count;
                }
            const double wanted = force * std::pow(length, 3) / (3 * bending) +
                                  force * length / (5.0 / 6 * side * side * material.shearModulus());
            QVERIFY2(std::abs(found / count / wanted - 1) < 0.06, qPrintable(QString::number(found / count / wanted)));
        }
    }

    void smallStrainsAreThoseOfModulusAndPoissonsRatio()
    {
        const Material material = rubber(0.4, 0.3, 2);
        Mat3 strain;
        strain << 1, 0.4, -0.2, 0.4, -0.5, 0.1, -0.2, 0.1, 0.3;
        strain *= 1e-6;
        Block block(material, {3, 3, 3});
        block.follow(Mat3::Identity() + strain);
        const Mat3 hooke =
            material.lameLambda() * strain.trace() * Mat3::Identity() + 2 * material.shearModulus() * strain;
        QVERIFY((block.firstPiolaStress() - hooke).norm() < 1e-5 * hooke.norm());
    }

    /// At places at random about stretched, squashed and inverted shapes.
    void forcesAreTheGradientOfTheEnergy()
    {
        for (const Material& material : {rubber(0.49), rubber(0.45, 0.3, 3)})
            for (const Vec3& stretch : {Vec3(1, 1, 1), Vec3(2.5, 0.6, 0.7), Vec3(1, 1, 0.3), Vec3(1, 1, -0.2)}) {
                Block block(material, {3, 2, 3});
                block.follow(stretch.asDiagonal());
                block.shake(0.05, 3);
                QVERIFY2(block.forceError() < 1e-6, qPrintable(QString::number(stretch[2])));
            }
    }

    /// Beside material that yields, beside elastic one, and where surroundings are flat.
    void bodiesOfSeveralMaterialsHaveForcesOfAnEnergy()
    {
        Material clay;
        clay.youngsModulus = 4e5;
        clay.poissonRatio = 0.45;
        clay.yieldStress = 1e4;
        Material plain;
        plain.youngsModulus = 2e6;
        plain.poissonRatio = 0.3;
        for (const Material& other : {clay, plain}) {
            Block block(rubber(0.49, 0.2, 4), {4, 3, 3});
            std::vector<ObjectIndex> half;
            for (ObjectIndex i = 0; i < block.state.size(); ++i)
                if (block.body.aggregate->lattice.position(i).x() > 0)
                    half.push_back(i);
            block.materials.set(half, other);
            block.connections->updateMaterials();
            block.follow(Vec3(1.1, 0.95, 0.97).asDiagonal());
            block.shake(0.05, 7);
            block.connections->computeForces(block.state, 0, 1);
            block.connections->acceptFlow();
            QVERIFY(block.forceError() < 1e-6);
            block.connections->renormalize(block.state, {}, 0.7);
            block.shake(0.05, 8);
            QVERIFY(block.forceError() < 1e-6);
        }
    }

    void materialAtRestBearsNothingAndIsTurnedFreely()
    {
        Block block(rubber(0.49, 0.2, 4), {3, 3, 2});
        block.follow(Eigen::AngleAxisd(1.1, Vec3(1, 2, -1).normalized()).toRotationMatrix());
        double largest = 0;
        for (std::size_t i = 0; i < block.state.size(); ++i)
            largest = std::max(largest, block.state.force.at(i).norm());
        QVERIFY(largest < 1e-9 * 1e6 * spacing * spacing);
    }

    void renormalizedRubberIsAtRestWhereItIs()
    {
        Block block(rubber(0.49, 0.2, 4), {3, 3, 3});
        const Mat3 f = Vec3(1.5, 0.8, 0.9).asDiagonal();
        block.follow(f);
        block.connections->renormalize(block.state, {}, 1);
        block.connections->computeForces(block.state);
        double largest = 0;
        for (std::size_t i = 0; i < block.state.size(); ++i)
            largest = std::max(largest, block.state.force.at(i).norm());
        QVERIFY(largest < 1e-8 * 1e6 * spacing * spacing);
        block.shake(0.05, 2);
        QVERIFY(block.forceError() < 1e-6);
    }

    /// Inside held surfaces stretched material does not buckle, and no mode is faster than the bound of the stable step says.
    void stretchedLatticeIsStableAndWithinTheBoundOfItsStep()
    {
        const Mat3 turn = Eigen::AngleAxisd(0.8, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
        for (const Material& material : {rubber(0.49), rubber(0.45, 0.3, 3)})
            for (const Vec3& stretch : {Vec3(1, 1, 1), Vec3(2, 0.71, 0.71), Vec3(3, 0.58, 0.58), Vec3(2, 2, 0.25),
                                        Vec3(0.4, 1.58, 1.58), Vec3(1, 1, 0.6), Vec3(1.1, 1.1, 1.1)})
                for (const Mat3& axes : {Mat3(Mat3::Identity()), turn}) {
                    Block block(material, {3, 3, 3});
                    block.follow(axes * stretch.asDiagonal() * axes.transpose());
                    const Eigen::MatrixXd matrix = block.dynamicMatrix();
                    const double fastest =
                        std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly)
                                      .eigenvalues()
                                      .tail<1>()[0]);
                    const double bound =
                        block.connections->largestFrequency(block.state, std::vector<double>(block.state.size()));
                    QVERIFY2(fastest < bound && fastest > 0.5 * bound,
                             qPrintable(QString("%1 of the bound at %2").arg(fastest / bound).arg(stretch[0])));
                    std::vector<Eigen::Index> inside;
                    for (ObjectIndex i = 0; i < block.state.size(); ++i)
                        if (block.body.aggregate->lattice.position(i).cwiseAbs().maxCoeff() < 1.4 * spacing)
                            for (int c = 0; c < 3; ++c)
                                inside.push_back(3 * i + c);
                    const Eigen::MatrixXd held = matrix(inside, inside);
                    QVERIFY(
                        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(held, Eigen::EigenvaluesOnly).eigenvalues()[0] >
                        0);
                }
    }

    /// Beside clay and elastic material, with objects of all three in one vector, in several blocks.
    void bitsDoNotDependOnTheNumberOfThreads()
    {
        const auto forcesWith = [](int threads) {
            return onThreads(threads, [] {
                Block block(rubber(0.49, 0.2, 4), {24, 24, 20});
                Material clay = rubber(0.45);
                clay.yieldStress = 1e4;
                Material plain = rubber(0.3);
                plain.rubberlike = 0;
                std::vector<ObjectIndex> some;
                std::vector<ObjectIndex> others;
                for (ObjectIndex i = 0; i < block.state.size(); ++i) {
                    if (i % 7 == 0)
                        some.push_back(i);
                    else if (i % 5 == 1)
                        others.push_back(i);
                }
                block.materials.set(some, clay);
                block.materials.set(others, plain);
                block.connections->updateMaterials();
                block.follow(Vec3(1.4, 0.85, 0.9).asDiagonal());
                block.shake(0.05, 11);
                block.connections->computeForces(block.state, 0, 1e-3);
                return block.state.force;
            });
        };
        const VectorArray one = forcesWith(1);
        const VectorArray four = forcesWith(4);
        for (std::size_t i = 0; i < one.size(); ++i)
            QVERIFY(one.at(i) == four.at(i));
    }

    void materialThatYieldsIsAsItWas()
    {
        Material clay = rubber(0.45);
        clay.yieldStress = 1e4;
        Material same = clay;
        same.rubberlike = 0;
        for (Material* one : {&clay, &same})
            QVERIFY(!one->isRubberlike());
        Block first(clay, {3, 3, 3});
        Block second(same, {3, 3, 3});
        const Mat3 f = Vec3(1.2, 0.9, 0.95).asDiagonal();
        first.follow(f);
        second.follow(f);
        for (std::size_t i = 0; i < first.state.size(); ++i)
            QVERIFY(first.state.force.at(i) == second.state.force.at(i));
    }
};

QTEST_GUILESS_MAIN(RubberLawTest)
#include "rubber_law_test.moc"
