#include "core/aggregate/firmness.h"
#include "core/aggregate/material.h"

#include <QtTest>

#include <cmath>
#include <limits>
#include <set>

using namespace knead;

class MaterialTest : public QObject {
    Q_OBJECT

private slots:
    void defaultMaterialHasNoProblems() { QVERIFY(materialProblems(Material{}).empty()); }

    void soundSpeedOfSteelIsThatOfABar()
    {
        Material steel;
        steel.youngsModulus = 2.1e11;
        steel.density = 7850;
        QVERIFY(std::abs(steel.soundSpeed() - 5172) < 1);
    }

    void firmerMaterialYieldsAndTearsAtTheSameStrains()
    {
        Material clay{.youngsModulus = 5e5};
        clay.yieldStress = 1e4;
        clay.tensileStrength = 1e5;
        clay.toughness = 50;
        clay.adhesion = 1000;
        clay.healingTime = 0.3;
        const Material dry = firmer(clay, 2);
        QCOMPARE(dry.yieldStress / dry.youngsModulus, clay.yieldStress / clay.youngsModulus);
        QCOMPARE(dry.tensileStrength, 2e5);
        QCOMPARE(dry.toughness, 100.0);
        QCOMPARE(dry.adhesion, clay.adhesion);
        QCOMPARE(dry.healingTime, clay.healingTime);
        QCOMPARE(firmer(dry, 0.5), clay);
        QVERIFY(materialProblems(firmer(clay, 1e9)).empty());
        QVERIFY(materialProblems(firmer(clay, 1e-9)).empty());
    }

    void elasticConstantsAgreeWithEachOther()
    {
        Material material;
        material.youngsModulus = 3e6;
        material.poissonRatio = 0.3;
        const double mu = material.shearModulus();
        const double lambda = material.lameLambda();
        // E = mu (3 lambda + 2 mu) / (lambda + mu) and nu = lambda / (2 (lambda + mu))
        QCOMPARE(mu * (3 * lambda + 2 * mu) / (lambda + mu), 3e6);
        QCOMPARE(lambda / (2 * (lambda + mu)), 0.3);
    }

    void fieldsCoverEveryNumberOnce()
    {
        std::set<std::string> keys;
        Material material;
        double mark = 1;
        for (const MaterialField& field : materialFields()) {
            QVERIFY(field.minimum < field.maximum);
            keys.insert(field.key);
            material.*field.value = ++mark;
        }
        QCOMPARE(keys.size(), sizeof(Material) / sizeof(double));
        const std::set<double> values{
            material.density,           material.youngsModulus,   material.poissonRatio,
            material.dampingRatio,      material.shapeDamping,    material.friction,
            material.adhesion,          material.tensileStrength, material.yieldStress,
            material.hardening,         material.relaxationTime,  material.elongationAtBreak,
            material.healingTime,       material.rubberlike,      material.secondInvariantShare,
            material.lockingElongation, material.toughness};
        QCOMPARE(values.size(), keys.size());
    }

    void limitsThemselvesAreAllowed()
    {
        for (const MaterialField& field : materialFields()) {
            Material material;
            material.*field.value = field.minimum;
            QVERIFY2(materialProblems(material).empty(), field.key);
            material.*field.value = field.maximum;
            QVERIFY2(materialProblems(material).empty(), field.key);
        }
    }

    void numbersOutOfRangeAreNamedWithTheirLimits()
    {
        Material material;
        material.youngsModulus = 1e20;
        QCOMPARE(materialProblems(material).size(), std::size_t(1));
        QCOMPARE(materialProblems(material)[0].english(),
                 std::string("Young's modulus is 1e+20 Pa; it must lie between 100 and 1e+12 Pa."));
        material.poissonRatio = -0.1;
        QCOMPARE(materialProblems(material).size(), std::size_t(2));
        QCOMPARE(materialProblems(material)[1].english(),
                 std::string("Poisson's ratio is -0.1; it must lie between 0 and 0.49."));
    }

    void numbersThatAreNotFiniteAreProblems()
    {
        for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
            for (const MaterialField& field : materialFields()) {
                Material material;
                material.*field.value = bad;
                QCOMPARE(materialProblems(material).size(), std::size_t(1));
            }
        }
    }
};

QTEST_GUILESS_MAIN(MaterialTest)
#include "material_test.moc"
