#include "core/geometry/mass_properties.h"
#include "io/importer.h"
#include "support/skip.h"

#include <QtTest>

#include <algorithm>

using namespace knead;

// What healing makes of the files in the corpus that hold surfaces instead of solids, or a solid that is called invalid.

namespace {

struct Expectation {
    const char* file;
    int solids;
    int openShells;
    double volume; ///< [mm^3]
};

const Expectation table[]{
    {"o02_mayo_cube_iges.iges", 1, 0, 1000},
    {"o06_occ_top_casting.brep", 1, 0, 113235},
    {"o08_occ_shell1.brep", 0, 1, 0}, // one border: it ends at an edge, as a sheet does
    {"o09_occ_hammer_iges.iges", 1, 0, 2.05929e11},
    {"o10_occ_bearing_iges.iges", 0, 1, 0},     // the flat face below, z = 0, is not in the file
    {"o14_pyocc_sunglasses_lens.igs", 0, 1, 0}, // one side of a lens
    {"o16_pygem_pipe_surfaces.step", 1, 0, 1e10 * 3.14159265358979},
    {"o17_pygem_pipe_hollow_iges.iges", 1, 0, 0.36e10 * 3.14159265358979},
    {"o20_igesio_rounded_cube.igs", 1, 0, 125000 - 50 * 225 * (1 - 3.14159265358979 / 4)},
    {"o22_bladex_propeller_iges.iges", 1, 0, 2.4498e6},
    {"o30_gmsh_capot.brep", 0, 1, 0},
    {"o32_gmsh_presse_asm.step", 16, 14, 9.42683e6}, // walls of holes, open at both ends
};

} // namespace

class HealedCorpusTest : public QObject {
    Q_OBJECT

private slots:
    void surfacesBecomeSolidsWhereTheyBoundAVolume_data();
    void surfacesBecomeSolidsWhereTheyBoundAVolume();
};

void HealedCorpusTest::surfacesBecomeSolidsWhereTheyBoundAVolume_data()
{
    QTest::addColumn<int>("row");
    for (int row = 0; row < static_cast<int>(std::size(table)); ++row)
        QTest::newRow(table[row].file) << row;
}

void HealedCorpusTest::surfacesBecomeSolidsWhereTheyBoundAVolume()
{
    const QString folder = qEnvironmentVariable("KNEAD_CORPUS");
    if (folder.isEmpty())
        KNEAD_SKIP_WITHOUT("corpus", "The environment variable KNEAD_CORPUS names no corpus folder.");
    QFETCH(int, row);
    const Expectation& expected = table[row];
    const Model model = importFile(folder.toStdString() + "/open/" + expected.file);
    QVERIFY(model.missing.empty());
    int solids = 0;
    int openShells = 0;
    double volume = 0;
    for (const Part& part : model.parts) {
        solids += part.solids;
        openShells += part.solids > 0 ? 0 : part.shells;
        volume += 1e9 * part.volume;
        QVERIFY2(part.valid, part.path.c_str());
        QCOMPARE(part.canBeFilled(), part.solids > 0);
        QCOMPARE(part.openEdges.empty(), part.solids > 0);
        if (part.solids > 0)
            QVERIFY(std::abs(massProperties(part.mesh).volume / part.volume - 1) < 1e-3);
        else
            QVERIFY(std::any_of(part.warnings.begin(), part.warnings.end(), [](const knead::Message& warning) {
                return warning.english().find("open edges") != std::string::npos;
            }));
    }
    QCOMPARE(solids, expected.solids);
    QCOMPARE(openShells, expected.openShells);
    QVERIFY2(std::abs(volume - expected.volume) <= 1e-3 * expected.volume, qPrintable(QString::number(volume)));
}

QTEST_GUILESS_MAIN(HealedCorpusTest)
#include "healed_corpus_test.moc"
