#include "ui/commands/fuzzy_match.h"

#include <QtTest>

using namespace knead;

class FuzzyMatchTest : public QObject {
    Q_OBJECT
private slots:
    void lettersInTheirOrderFit()
    {
        QVERIFY(fuzzyMatch("exp", "Export"));
        QVERIFY(fuzzyMatch("ert", "Export"));
        QVERIFY(!fuzzyMatch("tre", "Export"));
        QVERIFY(!fuzzyMatch("exportt", "Export"));
        QVERIFY(fuzzyMatch("", "Export"));
        QVERIFY(!fuzzyMatch("e", ""));
    }

    void caseAccentsAndSpacesDoNotMatter()
    {
        QVERIFY(fuzzyMatch("EXPORT", "export"));
        QVERIFY(fuzzyMatch("offnen", "Öffnen..."));
        QVERIFY(fuzzyMatch("öffnen", "Offnen"));
        QVERIFY(fuzzyMatch("reset layout", "Resetlayout"));
        QVERIFY(fuzzyMatch("a propos", "À propos de Knead"));
    }

    void theBestAlignmentIsFound()
    {
        // Not the first "s", but the beginning of the word.
        QCOMPARE(fuzzyMatch("sa", "As saved")->hits, (QList<qsizetype>{3, 4}));
        QCOMPARE(fuzzyMatch("rl", "Reset layout")->hits, (QList<qsizetype>{0, 6}));
        QCOMPARE(fuzzyMatch("eset", "Reset")->hits, (QList<qsizetype>{1, 2, 3, 4}));
    }

    void whatIsMeantComesFirst_data()
    {
        QTest::addColumn<QString>("typed");
        QTest::addColumn<QString>("meant");
        QTest::addColumn<QString>("other");
        QTest::newRow("beginning") << "step"
                                   << "Step"
                                   << "Export as STEP";
        QTest::newRow("initials") << "ff"
                                  << "Fix faces"
                                  << "Find off";
        QTest::newRow("side by side") << "grid"
                                      << "Grid"
                                      << "Go right in a day";
        QTest::newRow("word") << "set"
                              << "Set sail"
                              << "Reset";
        QTest::newRow("shorter") << "open"
                                 << "Open"
                                 << "Open with all choices of parts and units";
    }

    void whatIsMeantComesFirst()
    {
        QFETCH(QString, typed);
        QFETCH(QString, meant);
        QFETCH(QString, other);
        QVERIFY(fuzzyMatch(typed, meant));
        const auto rest = fuzzyMatch(typed, other);
        QVERIFY(!rest || fuzzyMatch(typed, meant)->score > rest->score);
    }

    void hitsAreTheLettersThatWereTyped()
    {
        const QString text = "Record pictures of what was simulated";
        for (const QString& typed : {QString("rps"), QString("pictures"), QString("owas"), QString("rrrr")}) {
            const auto match = fuzzyMatch(typed, text);
            if (!match)
                continue;
            QCOMPARE(match->hits.size(), typed.size());
            for (qsizetype i = 0; i < typed.size(); ++i) {
                QCOMPARE(text[match->hits[i]].toLower(), typed[i]);
                QVERIFY(i == 0 || match->hits[i] > match->hits[i - 1]);
            }
        }
    }

    void wordsFitByTheirBeginning()
    {
        QVERIFY(wordMatch("view", "rotate view"));
        QVERIFY(wordMatch("Rotate V", "rotate view"));
        QVERIFY(wordMatch("ecran", "capture d'écran"));
        QVERIFY(!wordMatch("ate", "rotate view"));
        QVERIFY(!wordMatch("rv", "rotate view"));
        QVERIFY(!wordMatch("", "rotate view"));
        QVERIFY(wordMatch("view", "view here")->score > wordMatch("view", "see a view")->score); // it begins with it
        QCOMPARE(wordMatch("view", "rotate view")->hits, (QList<qsizetype>{7, 8, 9, 10}));
    }
};

QTEST_APPLESS_MAIN(FuzzyMatchTest)
#include "fuzzy_match_test.moc"
