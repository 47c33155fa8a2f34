#include "io/material_library.h"

#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>

using namespace knead;

namespace {

std::string write(const QTemporaryDir& folder, const std::string& text)
{
    const std::string path = folder.filePath("materials.json").toStdString();
    std::ofstream(path) << text;
    return path;
}

std::string messageFor(const std::string& text)
{
    const QTemporaryDir folder;
    try {
        readMaterials(write(folder, text));
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "accepted";
}

std::string oneMaterial(const std::string& keys)
{
    return R"({"version": 1, "materials": [{)" + keys + "}]}";
}

const std::string complete = R"("id": "mud", "name": "Mud", "source": "a ditch", "density_kg_m3": 1500,
    "youngs_modulus_pa": 2e4, "poisson_ratio": 0.4, "damping_ratio": 0.2, "shape_damping_per_s": 5,
    "yield_stress_pa": 300, "hardening_pa": 40, "relaxation_time_s": 0.1, "tensile_strength_pa": 800,
    "elongation_at_break": 2, "adhesion_pa": 50, "healing_time_s": 6)";

const MaterialPreset& bundled(const std::string& id)
{
    static const auto presets = readMaterials(KNEAD_RESOURCES "/materials/materials.json");
    const auto found = std::find_if(presets.begin(), presets.end(), [&](const auto& p) { return p.id == id; });
    if (found == presets.end())
        throw std::runtime_error(id);
    return *found;
}

} // namespace

class MaterialLibraryTest : public QObject {
    Q_OBJECT

private slots:
    void bundledMaterialsCanAllBeSimulated()
    {
        const auto presets = readMaterials(KNEAD_RESOURCES "/materials/materials.json");
        QVERIFY(presets.size() >= 13);
        for (const MaterialPreset& preset : presets) {
            QVERIFY2(materialProblems(preset.material).empty(), preset.id.c_str());
            QVERIFY2(!preset.source.empty() && !preset.name.empty(), preset.id.c_str());
        }
    }

    void bundledMaterialsGoFromSoftToStiff()
    {
        const auto presets = readMaterials(KNEAD_RESOURCES "/materials/materials.json");
        QVERIFY(std::is_sorted(presets.begin(), presets.end(), [](const auto& a, const auto& b) {
            return a.material.youngsModulus < b.material.youngsModulus;
        }));
    }

    void steelCarriesSoundAtFiveKilometersPerSecond()
    {
        QVERIFY(std::abs(bundled("steel").material.soundSpeed() - 5170) < 50);
    }

    void theJellyOfThePaperOnlyWobbles()
    {
        const Material& jelly = bundled("soft-jelly").material;
        QVERIFY(!jelly.yields() && !jelly.breaks() && !jelly.heals());
        QCOMPARE(jelly.adhesion, 0.0);
    }

    void claysFlowAndHealAndEverythingHardBreaks()
    {
        for (const char* id : {"modeling-clay", "plasticine"}) {
            const Material& clay = bundled(id).material;
            QVERIFY2(clay.yields() && clay.heals() && clay.adhesion > 0, id);
        }
        for (const char* id : {"wax", "abs", "wood-along-grain", "aluminum", "glass", "steel", "rigid-foam"})
            QVERIFY2(bundled(id).material.breaks(), id);
        QVERIFY2(!bundled("glass").material.yields(), "glass is brittle");
    }

    void elasticLimitsAreThoseOfRealMaterials()
    {
        for (const MaterialPreset& preset : readMaterials(KNEAD_RESOURCES "/materials/materials.json")) {
            const Material& m = preset.material;
            const double yieldStrain = m.yieldStress / m.youngsModulus;
            QVERIFY2(!m.yields() || (yieldStrain > 1e-3 && yieldStrain < 0.05), preset.id.c_str());
            QVERIFY2(!m.yields() || m.elongationAtBreak > 0, preset.id.c_str());
            // What is to flow before it breaks must reach its yield stress first.
            QVERIFY2(m.tensileStrength == 0 || m.yieldStress < m.tensileStrength, preset.id.c_str());
            const bool isRubbery = (m.youngsModulus < 1e7 && !m.yields()) || m.isRubberlike();
            QVERIFY2(m.tensileStrength / m.youngsModulus <= (isRubbery ? 10 : 0.25), preset.id.c_str());
            // A connection breaks by its stretch, and what locks must do so before its chains are straight.
            QVERIFY2(m.lockingElongation == 0 || m.tensileStrength / m.youngsModulus < m.lockingElongation,
                     preset.id.c_str());
        }
    }

    void ownMaterialsAreReadAsTheyWereWritten()
    {
        const QTemporaryDir folder;
        const std::string path = folder.filePath("new/materials.json").toStdString();
        QVERIFY(readOwnMaterials(path).empty());
        std::vector<MaterialPreset> presets = readMaterials(KNEAD_RESOURCES "/materials/materials.json");
        presets[0].material.youngsModulus = 1.0 / 3 * 1e6; // all digits count
        presets[0].name = "\"Clay\", \u00e0 la main";
        writeMaterials(path, presets);
        const std::vector<MaterialPreset> read = readOwnMaterials(path);
        QCOMPARE(read.size(), presets.size());
        for (std::size_t i = 0; i < read.size(); ++i) {
            QCOMPARE(read[i].name, presets[i].name);
            QCOMPARE(read[i].material, presets[i].material);
        }
        writeMaterials(path, {});
        QVERIFY(readOwnMaterials(path).empty());
        QVERIFY_EXCEPTION_THROWN(writeMaterials("/proc/none/materials.json", presets), std::runtime_error);
    }

    void numbersAreTakenAsWritten()
    {
        const QTemporaryDir folder;
        const auto presets = readMaterials(write(folder, oneMaterial(complete + R"(, "friction": 0.7)")));
        QCOMPARE(presets.size(), std::size_t(1));
        QCOMPARE(presets[0].id, std::string("mud"));
        QCOMPARE(presets[0].source, std::string("a ditch"));
        QCOMPARE(presets[0].material.density, 1500.0);
        QCOMPARE(presets[0].material.youngsModulus, 2e4);
        QCOMPARE(presets[0].material.poissonRatio, 0.4);
        QCOMPARE(presets[0].material.friction, 0.7);
        QCOMPARE(presets[0].material.yieldStress, 300.0);
        QCOMPARE(presets[0].material.hardening, 40.0);
        QCOMPARE(presets[0].material.relaxationTime, 0.1);
        QCOMPARE(presets[0].material.tensileStrength, 800.0);
        QCOMPARE(presets[0].material.elongationAtBreak, 2.0);
        QCOMPARE(presets[0].material.adhesion, 50.0);
        QCOMPARE(presets[0].material.healingTime, 6.0);
    }

    void missingNumberIsNamed()
    {
        QCOMPARE(messageFor(oneMaterial(complete)),
                 std::string("materials.json, line 1: materials[0] must have the key \"friction\"."));
    }

    void filesOfBeforeRubberAreReadAsBefore()
    {
        const QTemporaryDir folder;
        const auto old = readMaterials(write(folder, oneMaterial(complete + R"(, "friction": 0.7)")));
        QCOMPARE(old[0].material.rubberlike, 0.0);
        const auto rubber = readMaterials(write(folder, oneMaterial(complete + R"(, "friction": 0.7, "rubberlike": 1,
            "second_invariant_share": 0.2, "locking_elongation": 6)")));
        QCOMPARE(rubber[0].material.rubberlike, 1.0);
        QCOMPARE(rubber[0].material.secondInvariantShare, 0.2);
        QCOMPARE(rubber[0].material.lockingElongation, 6.0);
    }

    void numberOutOfRangeIsNamed()
    {
        QCOMPARE(messageFor(oneMaterial(complete + R"(, "friction": 3)")),
                 std::string("materials.json, line 4: materials[0].friction must be a number between 0 and 2, got 3."));
    }

    void idUsedTwiceIsRefused()
    {
        const std::string mud = complete + R"(, "friction": 0.7)";
        QCOMPARE(messageFor(oneMaterial(mud + "}, {" + mud)),
                 std::string("materials.json, line 4: materials[1].id is used twice: \"mud\"."));
    }

    void missingFileIsNamed()
    {
        QVERIFY_EXCEPTION_THROWN(readMaterials("/nowhere/materials.json"), std::runtime_error);
    }
};

QTEST_GUILESS_MAIN(MaterialLibraryTest)
#include "material_library_test.moc"
