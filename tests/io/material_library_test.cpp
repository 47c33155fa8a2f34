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
    "youngs_modulus_pa": 2e4, "poisson_ratio": 0.4, "damping_ratio": 0.2, "shape_damping_per_s": 5)";

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
        const auto presets = readMaterials(KNEAD_RESOURCES "/materials/materials.json");
        const auto steel = std::find_if(presets.begin(), presets.end(), [](const auto& p) { return p.id == "steel"; });
        QVERIFY(steel != presets.end());
        QVERIFY(std::abs(steel->material.soundSpeed() - 5170) < 50);
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
    }

    void missingNumberIsNamed()
    {
        QCOMPARE(messageFor(oneMaterial(complete)),
                 std::string("materials.json: materials[0] must have the key \"friction\"."));
    }

    void numberOutOfRangeIsNamed()
    {
        QCOMPARE(messageFor(oneMaterial(complete + R"(, "friction": 3)")),
                 std::string("materials.json: materials[0].friction must be a number between 0 and 2, got 3."));
    }

    void idUsedTwiceIsRefused()
    {
        const std::string mud = complete + R"(, "friction": 0.7)";
        QCOMPARE(messageFor(oneMaterial(mud + "}, {" + mud)),
                 std::string("materials.json: materials[1].id is used twice: \"mud\"."));
    }

    void missingFileIsNamed()
    {
        QVERIFY_EXCEPTION_THROWN(readMaterials("/nowhere/materials.json"), std::runtime_error);
    }
};

QTEST_GUILESS_MAIN(MaterialLibraryTest)
#include "material_library_test.moc"
