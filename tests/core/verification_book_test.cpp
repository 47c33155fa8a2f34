#include "core/geometry/mass_properties.h"
#include "verify/mapped_block.h"
#include "verify/record.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

using namespace knead;
using namespace knead::book;

/// The quick cases of the book of verification, at their default spacing; ./dev verify makes the whole book.
class VerificationBookTest : public QObject {
    Q_OBJECT

    /// CalculiX is not there when tests run.
    static bool isAsked(const Quantity& quantity)
    {
        return quantity.expected == Expected::holds && quantity.origin != Origin::calculix;
    }

private slots:
    void quickCasesHold_data()
    {
        QTest::addColumn<int>("number");
        const std::vector<Case> cases = allCases();
        for (std::size_t i = 0; i < cases.size(); ++i) {
            if (cases[i].quick && std::any_of(cases[i].quantities.begin(), cases[i].quantities.end(), isAsked))
                QTest::newRow(cases[i].id.c_str()) << static_cast<int>(i);
        }
    }
    void quickCasesHold()
    {
        QFETCH(int, number);
        const Record made = record(allCases()[static_cast<std::size_t>(number)], {.calculix = false, .finer = false});
        QVERIFY2(made.runs.front().trouble.empty(), made.runs.front().trouble.c_str());
        for (std::size_t q = 0; q < made.what.quantities.size(); ++q)
            if (isAsked(made.what.quantities[q]))
                QVERIFY2(holds(made, q), ("\n" + tableHead() + "\n" + tableOf(made)).c_str());
        QVERIFY2(made.runs.front().imbalance < 0.01, qPrintable(QString::number(made.runs.front().imbalance)));
    }

    /// What ./dev verify ends with 1 for.
    void whatDoesNotHoldIsUnexpected()
    {
        const auto recordOf = [](double value, Expected expected = Expected::holds, double reference = 2) {
            Record made;
            made.what.quantities = {{"force", "N", reference, 0.1, Origin::closedForm, expected}};
            made.cells = {4};
            made.runs = {{.values = {value}}};
            return made;
        };
        constexpr double none = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(isAsExpected(recordOf(2.1)));
        QVERIFY(!isAsExpected(recordOf(2.3)));
        QVERIFY(!isAsExpected(recordOf(none)));
        QVERIFY(isAsExpected(recordOf(2.3, Expected::notYet)));
        QVERIFY(isAsExpected(recordOf(2.3, Expected::holds, none))); // it waits for CalculiX
        Record finer = recordOf(2.1);
        finer.runs.push_back({.values = {2.3}});
        QVERIFY(!isAsExpected(finer));
        Record lossy = recordOf(2.1, Expected::notYet);
        lossy.runs[0].imbalance = 0.011;
        QVERIFY(!isAsExpected(lossy));
        Record stopped = recordOf(2.1, Expected::notYet);
        stopped.runs[0].trouble = "It flew apart.";
        QVERIFY(!isAsExpected(stopped));
        Record withoutReference = recordOf(2.1);
        withoutReference.calculix.trouble = "CalculiX did not converge.";
        QVERIFY(!isAsExpected(withoutReference));
    }

    void casesAreToldApart()
    {
        std::set<std::string> ids;
        for (const Case& one : allCases()) {
            QVERIFY2(ids.insert(one.id).second, one.id.c_str());
            QVERIFY2(!one.title.empty() && !one.source.empty() && !one.across.empty(), one.id.c_str());
            for (const Quantity& quantity : one.quantities)
                QVERIFY2(quantity.tolerance > 0, one.id.c_str());
        }
    }

    void fortyCasesTenOfThemWithPublishedNumbers()
    {
        const std::vector<Case> cases = allCases();
        const auto published = std::count_if(cases.begin(), cases.end(), [](const Case& one) {
            return std::any_of(one.quantities.begin(), one.quantities.end(),
                               [](const Quantity& q) { return q.origin == Origin::measured; });
        });
        QVERIFY(cases.size() >= 40);
        QVERIFY2(published >= 10, qPrintable(QString::number(published)));
    }

    void blocksHaveTheVolumeOfTheirForms_data()
    {
        QTest::addColumn<double>("volume"); // of the block over that of the form
        constexpr double pi = std::numbers::pi;
        const auto add = [](const char* name, const MappedBlock& block, double expected) {
            QTest::newRow(name) << massProperties(surfaceOf(block)).volume / expected;
        };
        add("bar", bar({3, 2, 1}, 2), 6);
        add("round bar", roundBar(1, 3, 24), 3 * pi);
        add("pipe", pipe(1, 1.2, 3, 4), 3 * pi * 0.44);
        add("square pipe", squarePipe(2, 0.2, 3, 2), 3 * (4 - 1.6 * 1.6));
        add("plate with hole", plateWithHole(4, 2, 0.5, 0.3, 96), 0.3 * (8 - pi * 0.25));
        add("ring sector", ringSector(1, 2, 0.5, 0.2, 2.2, 12), 0.5 * 3 * 2.0 / 2);
    }
    void blocksHaveTheVolumeOfTheirForms()
    {
        QFETCH(double, volume);
        QVERIFY2(std::abs(volume - 1) < 0.015, qPrintable(QString::number(volume)));
    }

    void orderIsThatOfTheErrors()
    {
        Record made;
        made.what.quantities = {{"value", "", 10, 0.5}};
        for (const double cells : {4.0, 6.0, 8.0}) {
            made.cells.push_back(cells);
            made.runs.push_back({.values = {10 * (1 + 5 / (cells * cells))}});
        }
        QVERIFY(std::abs(orderOf(made, 0) - 2) < 1e-9);
        QVERIFY(holds(made, 0));
        made.runs.back().values[0] = 10 * 0.9; // of the other sign: no order can be told
        QVERIFY(std::isnan(orderOf(made, 0)));
        made.runs.back().values[0] = 10 * 0.4;
        QVERIFY(!holds(made, 0));
        made.runs.back().values[0] = std::nan("");
        QVERIFY(!holds(made, 0));
    }
};

QTEST_GUILESS_MAIN(VerificationBookTest)
#include "verification_book_test.moc"
