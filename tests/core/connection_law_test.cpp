#include "core/mechanics/connection_law.h"

#include <QTest>

#include <cmath>
#include <limits>

using namespace knead;

namespace {

Material clay()
{
    Material m;
    m.youngsModulus = 5e5;
    m.poissonRatio = 0.45;
    m.yieldStress = 1e4;
    m.hardening = 2e4;
    m.tensileStrength = 1e5;
    m.relaxationTime = 0.05;
    return m;
}

} // namespace

class ConnectionLawTest : public QObject {
    Q_OBJECT

private slots:
    void twoObjectsOfOneMaterialReproduceIt()
    {
        const Material m = clay();
        const ConnectionLaw law = lawBetween(m, m, 2e-3);
        QCOMPARE(law.stiffness, m.shearModulus());
        QVERIFY(std::abs(law.yieldStrain - 2.0 / 3 * 1.45 * 0.02) < 1e-12);
        QVERIFY(std::abs(law.hardening - 2.0 / 3 * 1.45 * 0.04) < 1e-12);
        QVERIFY(std::abs(law.breakingStrain - 0.2) < 1e-12);
        QCOMPARE(law.flowTime, 0.05);
        QVERIFY(std::abs(law.ductility - (0.2 - 0.02) / 0.04) < 1e-9); // where it has hardened up to its strength
        QCOMPARE(law.suddenStrain, 3 * law.breakingStrain);
    }

    void ductileMaterialBreaksByFlowAndBrittleMaterialByStrength()
    {
        Material m = clay();
        m.elongationAtBreak = 0.22;
        QVERIFY(std::abs(lawBetween(m, m, 2e-3).ductility - std::log(1.22)) < 1e-12);
        m.tensileStrength = 0.9 * m.yieldStress; // breaks before it yields
        const ConnectionLaw brittle = lawBetween(m, m, 2e-3);
        QVERIFY(std::isinf(brittle.ductility));
        QCOMPARE(brittle.suddenStrain, brittle.breakingStrain);
        QVERIFY(brittle.suddenStrainAtCrack < brittle.suddenStrain);
    }

    void theSofterAndTheWeakerDecide()
    {
        Material stiff = clay();
        stiff.youngsModulus = 1e12;
        stiff.yieldStress = 0;
        stiff.tensileStrength = 0;
        const Material soft = clay();
        const ConnectionLaw law = lawBetween(soft, stiff, 2e-3);
        QVERIFY(std::abs(law.stiffness / (2 * soft.shearModulus()) - 1) < 1e-5); // springs in series
        // The forces at which the soft one yields and breaks, in a connection twice as stiff.
        const ConnectionLaw own = lawBetween(soft, soft, 2e-3);
        QVERIFY(std::abs(law.yieldStrain / (own.yieldStrain / 2) - 1) < 1e-5);
        QVERIFY(std::abs(law.breakingStrain / (own.breakingStrain / 2) - 1) < 1e-5);
        QCOMPARE(law.flowTime, soft.relaxationTime);
        const ConnectionLaw swapped = lawBetween(stiff, soft, 2e-3);
        QCOMPARE(swapped.stiffness, law.stiffness);
        QCOMPARE(swapped.breakingStrain, law.breakingStrain);
    }

    void dampingIsTheHarmonicMean()
    {
        Material calm = clay();
        calm.dampingRatio = 0.3;
        Material lively = clay();
        lively.dampingRatio = 0.1;
        const double b1 = lawBetween(calm, calm, 1e-3).dampingTime;
        const double b2 = lawBetween(lively, lively, 1e-3).dampingTime;
        const double both = lawBetween(calm, lively, 1e-3).dampingTime; // of equal stiffness
        QVERIFY(std::abs(both / (2 * b1 * b2 / (b1 + b2)) - 1) < 1e-12);
    }

    void aMapGivesEachPairItsLaw()
    {
        Material hard = clay();
        hard.youngsModulus = 1e9;
        MaterialMap map(clay(), 4);
        map.set({2, 3}, hard);
        const ConnectionLaws laws(map, 2e-3);
        QCOMPARE(laws.between(0, 1).stiffness, clay().shearModulus());
        QCOMPARE(laws.between(2, 3).stiffness, hard.shearModulus());
        double stiffness[3];
        laws.fill(&ConnectionLaw::stiffness, 0, 1, 3, stiffness);
        QCOMPARE(stiffness[0], clay().shearModulus());
        QCOMPARE(stiffness[1], lawBetween(clay(), hard, 2e-3).stiffness);
        QCOMPARE(stiffness[2], hard.shearModulus());
        map.set({2, 3}, clay());
        QVERIFY(map.isUniform()); // what is no longer used is forgotten
    }
};

QTEST_GUILESS_MAIN(ConnectionLawTest)
#include "connection_law_test.moc"
