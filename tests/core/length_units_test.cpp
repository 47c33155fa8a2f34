#include "core/geometry/mass_properties.h"
#include "core/model/length_units.h"
#include "support/shapes.h"

#include <QtTest>

using namespace knead;

class LengthUnitsTest : public QObject {
    Q_OBJECT

private slots:
    void everySpellingIsKnown_data();
    void everySpellingIsKnown();
    void nonsenseIsNoUnit();
    void everyLengthIsScaled();
    void takingInAnotherUnitSettlesTheDoubt();
    void unknownUnitsAreRefused();
};

namespace {

Model cube()
{
    Part part;
    part.mesh = shapes::box(Vec3(0.01, 0.01, 0.01));
    part.box = massProperties(part.mesh).box;
    part.volume = 1e-6;
    part.area = 6e-4;
    part.maxTolerance = 1e-7;
    part.openEdges = {{Vec3(0, 0, 0), Vec3(0.01, 0, 0)}};
    Model model;
    model.parts = {part, Part()};
    return model;
}

} // namespace

void LengthUnitsTest::everySpellingIsKnown_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<double>("metres");
    const auto row = [](const char* text, double metres) { QTest::newRow(text) << QString(text) << metres; };
    row("mm", 1e-3);
    row("MM", 1e-3);
    row("MILLIMETRE", 1e-3);
    row("millimeters", 1e-3);
    row("centimetre", 1e-2);
    row("M", 1);
    row("meter", 1);
    row("in", 0.0254);
    row("INCH", 0.0254);
    row("inches", 0.0254);
    row("foot", 0.3048);
    row("ft", 0.3048);
    row("um", 1e-6);
    row("\xC2\xB5m", 1e-6);
    row("micrometer", 1e-6);
    row("thou", 2.54e-5);
    row("mi", 1609.344);
}

void LengthUnitsTest::everySpellingIsKnown()
{
    QFETCH(QString, text);
    QFETCH(double, metres);
    const LengthUnit* unit = findLengthUnit(text.toStdString());
    QVERIFY(unit != nullptr);
    QCOMPARE(unit->metres, metres);
}

void LengthUnitsTest::nonsenseIsNoUnit()
{
    for (const char* text : {"", "attogram", "millimetr", "s", "metrestick"})
        QVERIFY2(findLengthUnit(text) == nullptr, text);
}

void LengthUnitsTest::everyLengthIsScaled()
{
    Model model = cube();
    scaleModel(model, 2);
    const Part& part = model.parts.front();
    QVERIFY((part.box.sizes() - Vec3(0.02, 0.02, 0.02)).norm() < 1e-15);
    QVERIFY(std::abs(part.volume / 8e-6 - 1) < 1e-12);
    QVERIFY(std::abs(part.area / 24e-4 - 1) < 1e-12);
    QVERIFY(std::abs(part.maxTolerance / 2e-7 - 1) < 1e-12);
    QVERIFY(std::abs(massProperties(part.mesh).volume / 8e-6 - 1) < 1e-12);
    QCOMPARE(part.openEdges[0][1].x(), 0.02);
    QVERIFY(model.parts.back().box.isEmpty());
}

void LengthUnitsTest::takingInAnotherUnitSettlesTheDoubt()
{
    Model model = cube();
    const std::string ofEarlierVersion = "cube.stl: the file states no length unit; millimetres were taken.";
    QCOMPARE(noUnitStated("cube.stl").english(), ofEarlierVersion);
    model.warnings = {noUnitStated("cube.stl"), Message::verbatim(ofEarlierVersion), Message::verbatim("another one.")};
    model.unitRemark = UnitRemark{Message::verbatim("is tiny."), "m"};
    const Model taken = takenIn(model, "in");
    QCOMPARE(taken.unit, std::string("inch"));
    QVERIFY(!taken.unitRemark);
    QCOMPARE(taken.warnings, std::vector{Message::verbatim("another one.")});
    QVERIFY(std::abs(taken.parts[0].box.sizes().x() / 0.254 - 1) < 1e-12);
    QVERIFY(std::abs(takenIn(taken, "mm").parts[0].box.sizes().x() / 0.01 - 1) < 1e-12);
}

void LengthUnitsTest::unknownUnitsAreRefused()
{
    QVERIFY_EXCEPTION_THROWN(takenIn(cube(), "attogram"), std::runtime_error);
    Model model = cube();
    model.unit = "attogram";
    QVERIFY_EXCEPTION_THROWN(takenIn(model, "mm"), std::runtime_error);
}

QTEST_GUILESS_MAIN(LengthUnitsTest)
#include "length_units_test.moc"
