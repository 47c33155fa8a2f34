#include "ui/units.h"

#include <QtTest>

using namespace knead;

class UnitsTest : public QObject {
    Q_OBJECT
private slots:
    void unitsKeepNumbersShort_data()
    {
        QTest::addColumn<double>("value");
        QTest::addColumn<int>("quantity");
        QTest::addColumn<QString>("text");
        const auto row = [](double value, Quantity quantity, const char* text) {
            QTest::newRow(text) << value << static_cast<int>(quantity) << QString::fromUtf8(text);
        };
        row(1.2e6, Quantity::Pressure, "1.2 MPa");
        row(1e6, Quantity::Pressure, "1 MPa");
        row(999, Quantity::Pressure, "999 Pa");
        row(2.1e11, Quantity::Pressure, "210 GPa");
        row(0.0025, Quantity::Length, "2.5 mm");
        row(1100, Quantity::Density, "1100 kg/m³");
        row(0, Quantity::Force, "0 N");
        row(-12.5, Quantity::Force, "-12.5 N");
        row(0.0123, Quantity::Force, "12.3 mN");
        row(4500, Quantity::Force, "4.5 kN");
        row(0.0667, Quantity::Speed, "66.7 mm/s");
        row(0.25, Quantity::Number, "0.25");
        row(2, Quantity::Rate, "2 1/s");
        row(0.05, Quantity::Time, "50 ms");
        row(70.6e-6, Quantity::Time, "70.6 µs");
        row(0, Quantity::Time, "0 s");
        row(1.5707963267948966, Quantity::Angle, "90°");
        row(2.5e-6, Quantity::Area, "2.5 mm²");
        row(0.0268, Quantity::Mass, "26.8 g");
        row(2.5, Quantity::Mass, "2.5 kg");
        row(0, Quantity::Mass, "0 g");
        row(-9.81, Quantity::Acceleration, "-9.81 m/s²");
        row(5173, Quantity::Speed, "5173 m/s");
        row(90, Quantity::Time, "90 s");
    }

    void lengthsSpeedsAndVolumesComeInTheChosenUnit()
    {
        setLengthUnit("in");
        QCOMPARE(formatQuantity(0.0254, Quantity::Length), QString("1 in"));
        QCOMPARE(formatQuantity(0, Quantity::Length), QString("0 in"));
        QCOMPARE(formatQuantity(0.0127, Quantity::Speed), QString("0.5 in/s"));
        QCOMPARE(formatQuantity(1.6387064e-05, Quantity::Volume), QString("1 in³"));
        QCOMPARE(formatQuantity(2e6, Quantity::Pressure), QString("2 MPa"));
        QCOMPARE(parseQuantity("2", Quantity::Length, 0.01), std::optional(0.0508)); // as it is shown
        QCOMPARE(parseQuantity("2 mm", Quantity::Length), std::optional(0.002));
        setLengthUnit("furlong"); // nobody has it
        QCOMPARE(lengthUnit(), QString("in"));
        setLengthUnit("mm");
        QCOMPARE(formatQuantity(0.0254, Quantity::Length), QString("25.4 mm"));
    }

    void numbersAreWrittenAsInTheLanguage()
    {
        setNumberLanguage("de");
        QCOMPARE(formatQuantity(0.0025, Quantity::Length), QString("2,5 mm"));
        QCOMPARE(formatReading(-2.944e-6, Quantity::Length), QString("-2,94 µm"));
        QCOMPARE(formatCount(7793), QString("7.793"));
        QCOMPARE(formatCount(793), QString("793"));
        QCOMPARE(formatCount(12'345'678), QString("12.345.678"));
        QCOMPARE(localNumber(0.25, 'f', 2), QString("0,25"));
        QCOMPARE(parseQuantity(formatQuantity(0.0025, Quantity::Length), Quantity::Length), std::optional(0.0025));
        setNumberLanguage("fr");
        QCOMPARE(formatCount(7793), QString::fromUtf8("7\u202f793"));
        QCOMPARE(formatQuantity(0.0025, Quantity::Length), QString("2,5 mm"));
        setNumberLanguage("xx"); // nobody speaks it
        QCOMPARE(formatQuantity(0.0025, Quantity::Length), QString("2,5 mm"));
        setNumberLanguage("en");
        QCOMPARE(formatQuantity(0.0025, Quantity::Length), QString("2.5 mm"));
        QCOMPARE(formatCount(7793), QString("7,793"));
    }

    void readingsOfTinyLengthsAreInMicrometres()
    {
        QCOMPARE(formatReading(3.1416e-5, Quantity::Length), QString("0.0314 mm"));
        QCOMPARE(formatReading(-2.944e-6, Quantity::Length), QString("-2.94 µm"));
        QCOMPARE(formatReading(8.763e-8, Quantity::Length), QString("0.0876 µm"));
        QCOMPARE(formatReading(0, Quantity::Length), QString("0 mm"));
        setLengthUnit("in");
        QCOMPARE(formatReading(2.54e-6, Quantity::Length), QString("0.0001 in"));
        setLengthUnit("mm");
    }

    void theUnitsThatMayBeTypedAreNamedOnce()
    {
        QCOMPARE(unitsFor(Quantity::Length), (QStringList{"mm", "m", "cm", "µm", "in"}));
        QCOMPARE(unitsFor(Quantity::Pressure), (QStringList{"Pa", "kPa", "MPa", "GPa"}));
        QVERIFY(unitsFor(Quantity::Number).isEmpty());
        for (const Quantity quantity : {Quantity::Length, Quantity::Density, Quantity::Force, Quantity::Time})
            for (const QString& unit : unitsFor(quantity))
                QVERIFY(parseQuantity("1 " + unit, quantity));
    }

    void unitsKeepNumbersShort()
    {
        QFETCH(double, value);
        QFETCH(int, quantity);
        QTEST(formatQuantity(value, static_cast<Quantity>(quantity)), "text");
    }

    void textIsReadTheWayPeopleWriteIt_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<int>("quantity");
        QTest::addColumn<double>("shown");
        QTest::addColumn<double>("value");
        const auto row = [](const char* text, Quantity quantity, double shown, double value) {
            QTest::newRow(text) << QString::fromUtf8(text) << static_cast<int>(quantity) << shown << value;
        };
        row("1.2 MPa", Quantity::Pressure, 1, 1.2e6);
        row("1,2 MPa", Quantity::Pressure, 1, 1.2e6);
        row("1.2MPa", Quantity::Pressure, 1, 1.2e6);
        row("1.2e6 Pa", Quantity::Pressure, 1, 1.2e6);
        row("1,2E+6Pa", Quantity::Pressure, 1, 1.2e6);
        row("  3 mpa ", Quantity::Pressure, 1, 3e6);
        row("5 N/mm²", Quantity::Pressure, 1, 5e6);
        row("2", Quantity::Pressure, 1.5e6, 2e6); // the field shows megapascals
        row("2", Quantity::Pressure, 1.5e3, 2e3);
        row("2 000 000 Pa", Quantity::Pressure, 1, 2e6);
        row("12", Quantity::Length, 0.001, 0.012);
        row("1.2 cm", Quantity::Length, 0.001, 0.012);
        row("1 in", Quantity::Length, 0.001, 0.0254);
        row("2 min", Quantity::Time, 1, 120);
        row("250 us", Quantity::Time, 1, 250e-6);
        row("3", Quantity::Time, 0.05, 0.003); // the field shows milliseconds
        row(".5", Quantity::Number, 0, 0.5);
        row("-,5", Quantity::Number, 0, -0.5);
        row("3 1/s", Quantity::Rate, 0, 3);
        row("1.1 g/cm³", Quantity::Density, 1000, 1100);
    }

    void textIsReadTheWayPeopleWriteIt()
    {
        QFETCH(QString, text);
        QFETCH(int, quantity);
        QFETCH(double, shown);
        QFETCH(double, value);
        const std::optional<double> read = parseQuantity(text, static_cast<Quantity>(quantity), shown);
        QVERIFY(read.has_value());
        QVERIFY2(qAbs(*read - value) <= 1e-12 * qAbs(value), qPrintable(QString::number(*read)));
    }

    void whatIsNoQuantityIsNotGuessed_data()
    {
        QTest::addColumn<QString>("text");
        for (const char* text : {"", "abc", "1.2.3", "1,000.5", "5 kg", "MPa", "1e", "1 mm", "nan", "inf", "1e999 Pa"})
            QTest::newRow(text) << QString::fromLatin1(text);
    }

    void whatIsNoQuantityIsNotGuessed()
    {
        QFETCH(QString, text);
        QVERIFY(!parseQuantity(text, Quantity::Pressure, 1e6).has_value());
    }

    void letterCaseThatCouldMeanTwoUnitsIsNotGuessed()
    {
        QVERIFY(!parseQuantity("1 mn", Quantity::Force, 1).has_value());
        QVERIFY(parseQuantity("1 MN", Quantity::Force, 1) == 1e6);
        QVERIFY(parseQuantity("1 mN", Quantity::Force, 1) == 1e-3);
    }

    void everyShownTextIsReadBack()
    {
        for (const Quantity quantity : {Quantity::Number, Quantity::Length, Quantity::Pressure, Quantity::Density,
                                        Quantity::Rate, Quantity::Speed, Quantity::Force, Quantity::Volume})
            for (double value = 1.2345e-9; value < 1e12; value *= 7.3) {
                const std::optional<double> read = parseQuantity(formatQuantity(value, quantity), quantity, value);
                QVERIFY2(read.has_value(), qPrintable(formatQuantity(value, quantity)));
                QVERIFY(qAbs(*read - value) < 1e-4 * value);
            }
    }
};

QTEST_GUILESS_MAIN(UnitsTest)
#include "units_test.moc"
