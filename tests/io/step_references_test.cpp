#include "io/importer.h"
#include "support/step_machine.h"

#include <QTemporaryDir>
#include <QtTest>

#include <fstream>

#include <sys/stat.h>

using namespace knead;

namespace {

std::string refusalOf(const std::string& path)
{
    try {
        importFile(path);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return {};
}

} // namespace

class StepReferencesTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void filesBesideAnAssemblyAreReadWithIt();
    void missingFilesAreNamed();
    void filesElsewhereAndPipesAreRefused();
    void damagedFilesAreNamed();
    void filesOfCurvesOrTrianglesSaySo_data();
    void filesOfCurvesOrTrianglesSaySo();

private:
    std::string path(const char* name) const { return m_folder->filePath(name).toStdString(); }

    std::unique_ptr<QTemporaryDir> m_folder;
};

void StepReferencesTest::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    QVERIFY(writeMachine(m_folder->path()));
}

void StepReferencesTest::filesBesideAnAssemblyAreReadWithIt()
{
    const Model model = importFile(path("machine.stp"));
    QCOMPARE(model.parts.size(), 3U);
    QVERIFY(model.missing.empty());
    double volume = 0;
    for (const Part& part : model.parts)
        volume += part.volume;
    QVERIFY(std::abs(volume * 1e9 - 6000 - 2 * 3.14159265 * 1000) < 1);
    QCOMPARE(model.parts[0].path, std::string("machine/plate"));
}

void StepReferencesTest::missingFilesAreNamed()
{
    QVERIFY(QFile::remove(m_folder->filePath("part_plate.stp")));
    const Model model = importFile(path("machine.stp"));
    QCOMPARE(model.parts.size(), 2U);
    QCOMPARE(model.missing.size(), 1U);
    QVERIFY(model.missing.front().english().find("the file part_plate.stp, which is not there") != std::string::npos);

    QVERIFY(QFile::remove(m_folder->filePath("part_pin.stp")));
    const std::string refusal = refusalOf(path("machine.stp"));
    QVERIFY2(refusal.find("2 files that are not there: part_pin.stp, part_plate.stp") != std::string::npos,
             refusal.c_str());
}

void StepReferencesTest::filesElsewhereAndPipesAreRefused()
{
    const QString pin = m_folder->filePath("part_pin.stp");
    const QTemporaryDir elsewhere;
    QVERIFY(QFile::rename(pin, elsewhere.filePath("pin.stp")) && QFile::link(elsewhere.filePath("pin.stp"), pin));
    const std::string words = "the assembly refers to part_pin.stp, which is no ordinary file in its folder";
    QVERIFY(refusalOf(path("machine.stp")).find(words) != std::string::npos);
    QVERIFY(QFile::remove(pin) && mkfifo(qPrintable(pin), 0600) == 0);
    QVERIFY(refusalOf(path("machine.stp")).find(words) != std::string::npos); // and is not waited for
}

void StepReferencesTest::damagedFilesAreNamed()
{
    QFile file(m_folder->filePath("part_pin.stp"));
    QVERIFY(file.resize(file.size() / 2));
    const std::string refusal = refusalOf(path("machine.stp"));
    QVERIFY2(refusal.starts_with("part_pin.stp: ") && refusal.find("cut off") != std::string::npos, refusal.c_str());
}

void StepReferencesTest::filesOfCurvesOrTrianglesSaySo_data()
{
    QTest::addColumn<QByteArray>("entities");
    QTest::addColumn<QByteArray>("words");
    QTest::newRow("curves") << QByteArray("#1=CARTESIAN_POINT('',(0.,0.,0.));\n#2=GEOMETRIC_CURVE_SET('',(#1));\n")
                            << QByteArray("curves and points only");
    QTest::newRow("triangles") << QByteArray("#1=COORDINATES_LIST('',3,((0.,0.,0.),(1.,0.,0.),(0.,1.,0.)));\n"
                                             "#2=TRIANGULATED_FACE('',#1,3,((0.,0.,1.)),$,(),((1,2,3)));\n")
                               << QByteArray("triangles only");
}

void StepReferencesTest::filesOfCurvesOrTrianglesSaySo()
{
    QFETCH(QByteArray, entities);
    QFETCH(QByteArray, words);
    std::ofstream(path("other.stp")) << "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\n"
                                        "FILE_NAME('','',(''),(''),'','','');\nFILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\n"
                                        "ENDSEC;\nDATA;\n"
                                     << entities.toStdString() << "ENDSEC;\nEND-ISO-10303-21;\n";
    const std::string refusal = refusalOf(path("other.stp"));
    QVERIFY2(refusal.find(words.toStdString()) != std::string::npos, refusal.c_str());
}

QTEST_GUILESS_MAIN(StepReferencesTest)
#include "step_references_test.moc"
