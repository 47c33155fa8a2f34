#include "core/model/length_units.h"
#include "io/document/unit_remark.h"
#include "io/formats/mesh_writer.h"
#include "io/importer.h"
#include "support/shapes.h"

#include <QtTest>

using namespace knead;

class UnitRemarkTest : public QObject {
    Q_OBJECT

private slots:
    void sizesAreDoubtedAndCorrected_data();
    void sizesAreDoubtedAndCorrected();
    void sentenceSaysWhatIsMeant();
    void unitThatIsAskedForIsTaken();
    void unknownUnitIsRefused();

private:
    QTemporaryDir m_folder;
};

namespace {

/// A part this long, of a file that states this unit, or none.
Model longPart(double length, const std::string& unit)
{
    Part part;
    part.box = Box(Vec3(0, 0, 0), Vec3(length / 3, length, length / 2));
    Model model;
    model.file = "/home/ann/bearing.iges";
    model.unit = unit;
    model.parts = {part};
    return model;
}

} // namespace

void UnitRemarkTest::sizesAreDoubtedAndCorrected_data()
{
    QTest::addColumn<double>("length");
    QTest::addColumn<QString>("unit");
    QTest::addColumn<QString>("instead");
    const auto row = [](const char* name, double length, const char* unit, const char* instead) {
        QTest::newRow(name) << length << QString(unit) << QString(instead);
    };
    row("bearing of 0.12 mm", 0.122e-3, "mm", "m");
    row("hammer of 39 m", 38.9, "mm", "um");
    row("STL of 0.05 mm", 0.05e-3, "", "m");
    row("STL of 25 m", 25, "", "um");
    row("STL in metres", 1.5e-3, "", "m");
    row("millimetres stated as metres", 120, "m", "mm");
    row("millimetres stated as inches", 30, "inch", "mm");
    row("cube of 10 mm", 10e-3, "mm", "");
    row("cube of 10 mm without a unit", 10e-3, "", "");
    row("machine of 3 m", 3, "mm", "");
    row("machine of 3 m without a unit", 3, "", "");
    row("ball of 1 mm that is stated", 1e-3, "mm", "");
    row("pipe of 10 m", 10, "m", "");
    row("what no unit helps", 1e-16, "mm", "");
    row("point", 0, "mm", "");
    row("silly unit", 1e-4, "attogram", "");
}

void UnitRemarkTest::sizesAreDoubtedAndCorrected()
{
    QFETCH(double, length);
    QFETCH(QString, unit);
    QFETCH(QString, instead);
    const Model model = longPart(length, unit.toStdString());
    const auto remark = unitRemark(model);
    QCOMPARE(QString::fromStdString(remark ? remark->unit : ""), instead);
    if (!remark)
        return;
    Model corrected = takenIn(model, remark->unit);
    const double side = corrected.parts[0].box.sizes().y();
    QVERIFY2(side >= 10e-3 && side <= 5, qPrintable(QString::number(side)));
    QVERIFY(!unitRemark(corrected));
}

void UnitRemarkTest::sentenceSaysWhatIsMeant()
{
    QCOMPARE(unitRemark(longPart(0.122e-3, "mm"))->sentence.english(),
             std::string("bearing.iges: the part is 0.122 mm long; if its lengths are metres, it is 122 mm."));
}

void UnitRemarkTest::unitThatIsAskedForIsTaken()
{
    const std::string file = m_folder.path().toStdString() + "/box.stl";
    writeMeshes(file, {{"box", Color{}, shapes::box(Vec3(0.01, 0.02, 0.03))}});
    const Model asRead = importFile(file);
    QVERIFY(asRead.unit.empty());
    QCOMPARE(asRead.warnings.size(), std::size_t(1));
    const Model inInches = importFile(file, {.unit = "inch"});
    QCOMPARE(inInches.unit, std::string("inch"));
    QVERIFY(inInches.warnings.empty());
    QVERIFY((inInches.parts[0].box.sizes() - 25.4 * asRead.parts[0].box.sizes()).norm() < 1e-9);

    const std::string step = std::string(KNEAD_RESOURCES) + "/examples/bar.step";
    const Model bar = importFile(step, {.unit = "cm"});
    QVERIFY((bar.parts[0].box.sizes() - Vec3(1.6, 0.2, 0.2)).norm() < 1e-8);
    QVERIFY(std::abs(bar.parts[0].volume / 0.064 - 1) < 1e-9);
}

void UnitRemarkTest::unknownUnitIsRefused()
{
    const std::string step = std::string(KNEAD_RESOURCES) + "/examples/bar.step";
    try {
        importFile(step, {.unit = "parsec"});
        QFAIL("a parsec was taken");
    } catch (const std::runtime_error& error) {
        QVERIFY2(std::string(error.what()).starts_with("bar.step: \"parsec\" is no length unit"), error.what());
    }
}

QTEST_GUILESS_MAIN(UnitRemarkTest)
#include "unit_remark_test.moc"
