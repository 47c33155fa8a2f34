#include "core/aggregate/fill.h"
#include "core/mechanics/stress_law.h"
#include "core/mechanics/structural_connections.h"
#include "support/shapes.h"

#include <QtTest>

#include <cmath>

using namespace knead;

namespace {

constexpr double E = 2e6;

Material materialOf(double nu, double yieldStress = 0)
{
    Material material;
    material.youngsModulus = E;
    material.poissonRatio = nu;
    material.yieldStress = yieldStress;
    return material;
}

Mat3 turn()
{
    return Eigen::AngleAxisd(0.8, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
}

Mat3 someStretch(double size)
{
    Mat3 gradient;
    gradient << 1 + size, 0.3 * size, -0.1 * size, 0.2 * size, 1 - 0.4 * size, 0.5 * size, 0, -0.2 * size,
        1 + 0.3 * size;
    return gradient;
}

/// The first Piola-Kirchhoff stress along x [Pa] that the connections of a block bear across its middle when it is deformed by F:
/// what they pull its high half back with, by the section at rest.
Vec3 bornePerSection(const Material& material, const Mat3& gradient)
{
    constexpr double spacing = 2e-3;
    const Vec3 size(0.024, 0.02, 0.02);
    const auto aggregate = std::make_shared<const Aggregate>(fill(shapes::box(size), {.spacing = spacing}));
    const MaterialMap materials(material, aggregate->size());
    StructuralConnections connections(aggregate, materials);
    ObjectState state = objectsAtRest(*aggregate);
    for (std::size_t i = 0; i < aggregate->size(); ++i)
        state.position.set(i, gradient * aggregate->lattice.position(static_cast<ObjectIndex>(i)));
    connections.computeForces(state);
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < aggregate->size(); ++i)
        if (aggregate->lattice.position(static_cast<ObjectIndex>(i)).x() > 0.5 * spacing)
            sum += state.force.at(i);
    return -sum / (size.y() * size.z());
}

Vec3 piolaAlongX(const Mat3& cauchy, const Mat3& gradient)
{
    return gradient.determinant() * cauchy * gradient.inverse().transpose() * Vec3::UnitX();
}

} // namespace

class StressLawTest : public QObject {
    Q_OBJECT

private slots:
    /// At any strain and in any direction, by what flows through a section of a real lattice.
    void elasticStressIsWhatTheLatticeBears()
    {
        for (const double nu : {0.25, 0.45, 0.1})
            for (const double size : {-0.15, 1e-3, 0.1, 0.3}) {
                const Mat3 gradient = turn() * someStretch(size);
                const Vec3 wanted = bornePerSection(materialOf(nu), gradient);
                const Vec3 found = piolaAlongX(cauchyStress(gradient, Mat3::Identity(), materialOf(nu)), gradient);
                qInfo("nu %.2f strain %g: off by %.2g", nu, size, (found - wanted).norm() / wanted.norm());
                QVERIFY((found - wanted).norm() < 1e-6 * wanted.norm());
            }
    }

    void smallStrainIsHookes()
    {
        constexpr double size = 1e-6;
        const Mat3 gradient = someStretch(size);
        const Mat3 strain = 0.5 * (gradient + gradient.transpose()) - Mat3::Identity();
        for (const double nu : {0.0, 0.3, 0.45})
            for (const double yield : {0.0, 1e9}) {
                const Material material = materialOf(nu, yield);
                const Mat3 hooke =
                    material.lameLambda() * strain.trace() * Mat3::Identity() + 2 * material.shearModulus() * strain;
                QVERIFY((cauchyStress(gradient, Mat3::Identity(), material) - hooke).norm() < 1e-5 * hooke.norm());
            }
    }

    /// mu (b - tr b / 3) / J^(5/3) + K ln J / J, by hand for a stretch along x at the side lengths q.
    void stressOfYieldingMaterialIsNeoHookesDeviator()
    {
        const Material material = materialOf(0.4, 1e9);
        const double s = 1.3;
        const double q = 0.9;
        const double J = s * q * q;
        const Mat3 stress = cauchyStress(Vec3(s, q, q).asDiagonal(), Mat3::Identity(), material);
        const double mu = material.shearModulus();
        const double bulk = material.lameLambda() + 2 * mu / 3;
        const double deviator = mu * std::pow(J, -5.0 / 3) * 2 / 3 * (s * s - q * q);
        QVERIFY(std::abs(stress(0, 0) - deviator - bulk * std::log(J) / J) < 1e-9 * E);
        QVERIFY(std::abs(stress(1, 1) + deviator / 2 - bulk * std::log(J) / J) < 1e-9 * E);
        QVERIFY(std::abs(vonMisesStress(stress) - 1.5 * deviator) < 1e-9 * E);
    }

    void turningTurnsTheStress()
    {
        const Mat3 gradient = someStretch(0.2);
        const Mat3 relaxed = someStretch(0.1).transpose() * someStretch(0.1);
        for (const double yield : {0.0, 1e9}) {
            const Mat3 before = cauchyStress(gradient, relaxed, materialOf(0.3, yield));
            const Mat3 after = cauchyStress(turn() * gradient, relaxed, materialOf(0.3, yield));
            QVERIFY((after - turn() * before * turn().transpose()).norm() < 1e-9 * E);
        }
    }

    void whatHasFlowedIntoItsShapeBearsNothing()
    {
        const Mat3 gradient = turn() * someStretch(0.4);
        for (const double yield : {0.0, 1e9})
            QVERIFY(cauchyStress(gradient, gradient.transpose() * gradient, materialOf(0.45, yield)).norm() < 1e-9 * E);
    }

    /// The pressure stays: it has nothing to do with yielding.
    void deviatorIsScaledDownToTheLimit()
    {
        const Material material = materialOf(0.45, 1e4);
        const Mat3 gradient = someStretch(0.1);
        const Mat3 all = cauchyStress(gradient, Mat3::Identity(), material);
        const Mat3 limited = cauchyStress(gradient, Mat3::Identity(), material, 1e4);
        QVERIFY(vonMisesStress(all) > 5e4);
        QVERIFY(std::abs(vonMisesStress(limited) - 1e4) < 1e-6);
        QVERIFY(std::abs(limited.trace() - all.trace()) < 1e-9 * E);
        QVERIFY((limitedStress(limited, 2e4) - limited).norm() == 0);
    }

    void flowStressRisesByHardening()
    {
        Material material = materialOf(0.3, 1e4);
        material.hardening = 5e4;
        QCOMPARE(flowStress(material, 0.2), 2e4);
        QVERIFY(std::isinf(flowStress(materialOf(0.3), 0.2)));
    }

    void squashedMaterialStaysFinite()
    {
        for (const double yield : {0.0, 1e9})
            for (const Vec3& stretch : {Vec3(0, 1, 1), Vec3(-0.5, 1, 1), Vec3(0, 0, 0)})
                QVERIFY(cauchyStress(stretch.asDiagonal(), Mat3::Identity(), materialOf(0.3, yield)).allFinite());
    }
};

QTEST_APPLESS_MAIN(StressLawTest)
#include "stress_law_test.moc"
