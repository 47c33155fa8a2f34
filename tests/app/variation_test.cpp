#include "app/sweep/variation.h"

#include <QtTest>

#include <cmath>
#include <stdexcept>

using namespace knead;

/// What varies in a sweep, as it is typed.
class VariationTest : public QObject {
    Q_OBJECT

private slots:
    void rangesAreEvenlySpaced();
    void listsKeepTheirValues();
    void gridsAndPairsOfValues();
    void wrongVariationsAreRefused_data();
    void wrongVariationsAreRefused();
};

namespace {

std::vector<double> numbersOf(const Variation& variation)
{
    std::vector<double> numbers;
    for (const std::string& value : variation.values)
        numbers.push_back(std::stod(value));
    return numbers;
}

std::string refusalOf(const std::string& variation)
{
    try {
        parseVariation(variation);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "accepted";
}

} // namespace

void VariationTest::rangesAreEvenlySpaced()
{
    const std::vector<double> linear = numbersOf(parseVariation("a.b=-1:2:lin:7"));
    QCOMPARE(linear.size(), std::size_t(7));
    for (std::size_t i = 0; i < linear.size(); ++i)
        QVERIFY(std::abs(linear[i] - (-1 + 0.5 * static_cast<double>(i))) < 1e-12);
    const std::vector<double> ratios = numbersOf(parseVariation("a.b=1e5:1e7:log:21"));
    for (std::size_t i = 0; i < ratios.size(); ++i)
        QVERIFY(std::abs(ratios[i] / (1e5 * std::pow(10, 0.1 * static_cast<double>(i))) - 1) < 1e-11);
    // As a person would write them, and the ends as they are.
    QCOMPARE(parseVariation("a=0.1:0.3:lin:3").values, (std::vector<std::string>{"0.1", "0.2", "0.3"}));
    QCOMPARE(parseVariation("a=1e7:1e5:log:3").values, (std::vector<std::string>{"10000000", "1000000", "100000"}));
    QCOMPARE(parseVariation("a=0.1234567890123456:1e-9:lin:2").values,
             (std::vector<std::string>{"0.1234567890123456", "1e-09"}));
}

void VariationTest::listsKeepTheirValues()
{
    using Values = std::vector<std::string>;
    QCOMPARE(parseVariation("a=5").values, (Values{"5"}));
    QCOMPARE(parseVariation("material=steel,clay").values, (Values{"steel", "clay"}));
    QCOMPARE(parseVariation("a=[1,2],[3,4]").values, (Values{"[1,2]", "[3,4]"}));
    QCOMPARE(parseVariation(R"(a={"b": [1,2], "c": "x,}"},"u,v",null)").values,
             (Values{R"({"b": [1,2], "c": "x,}"})", R"("u,v")", "null"}));
    QCOMPARE(parseVariation("part.file=a:b.step,c=d.step").values, (Values{"a:b.step", "c=d.step"}));
}

void VariationTest::gridsAndPairsOfValues()
{
    const std::vector<Variation> two{{"a", {"1", "2"}}, {"b", {"x", "y", "z"}}};
    QCOMPARE(combine(two, Combination::grid),
             (SweepPoints{{"1", "x"}, {"1", "y"}, {"1", "z"}, {"2", "x"}, {"2", "y"}, {"2", "z"}}));
    QVERIFY_EXCEPTION_THROWN(combine(two, Combination::together), std::runtime_error);
    const std::vector<Variation> pairs{{"a", {"1", "2"}}, {"b", {"x", "y"}}};
    QCOMPARE(combine(pairs, Combination::together), (SweepPoints{{"1", "x"}, {"2", "y"}}));
    QVERIFY_EXCEPTION_THROWN(combine({pairs[0], pairs[0]}, Combination::grid), std::runtime_error);
    const Variation many = parseVariation("a=0:1:lin:1000");
    QVERIFY_EXCEPTION_THROWN(combine({many, {"b", many.values}}, Combination::grid), std::runtime_error);
}

void VariationTest::wrongVariationsAreRefused_data()
{
    QTest::addColumn<QString>("words");
    for (const char* text : {"a", "a=", "=1"})
        QTest::newRow(text) << "this varies nothing";
    for (const char* text : {"a=1:2", "a=1:2:lin", "a=1:2:lin:3:4", "a=1:2:square:4", "a=x:2:lin:4", "a=1:2:lin:n"})
        QTest::newRow(text) << "this is no range";
    for (const char* text : {"a=1:2:lin:1", "a=1:2:lin:2.5", "a=1:2:lin:1e9"})
        QTest::newRow(text) << "a range takes 2 to 100000 values";
    QTest::newRow("a=0:2:log:3") << "equal ratios need a beginning and an end above 0";
    QTest::newRow("a=1,,2") << "there is nothing between two commas";
    QTest::newRow("a=[1,2") << "the value of a: line 1";
}

void VariationTest::wrongVariationsAreRefused()
{
    QFETCH(QString, words);
    const std::string refusal = refusalOf(QTest::currentDataTag());
    QVERIFY2(refusal.find(words.toStdString()) != std::string::npos, refusal.c_str());
}

QTEST_GUILESS_MAIN(VariationTest)
#include "variation_test.moc"
