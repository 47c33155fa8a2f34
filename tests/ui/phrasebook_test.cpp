#include "ui/language/phrasebook.h"

#include <QtTest>

using namespace knead;

namespace {

/// German of a few phrases.
QString german(const Phrase& phrase, int count)
{
    static const QHash<QByteArray, QString> words{{"Open", "Öffnen"},
                                                  {"Opening %1", "%1 wird geöffnet"},
                                                  {"%1 of %2 parts", "Von %2 Teilen %1"},
                                                  {"Back", "Zurück"},
                                                  {"Block", "Klotz"},
                                                  {"Add %1", "%1 hinzufügen"}};
    if (phrase.source == "%n files")
        return count == 1 ? "eine Datei" : "%n Dateien";
    if (phrase.context == "Tool" && phrase.source == "Back")
        return "Rücken";
    return words.value(phrase.source, QString::fromUtf8(phrase.source));
}

} // namespace

class PhrasebookTest : public QObject {
    Q_OBJECT
private slots:
    void init()
    {
        m_book = {};
        for (const char* source :
             {"Open", "Opening %1", "%1 of %2 parts", "%n files", "Back", "Block", "Add %1", "%1 \"%2\""})
            m_book.add(source, {"Window", source, {}});
        m_book.add("Back", {"Tool", "Back", {}});
    }

    void whatWasSaidIsSaidAgain() { QCOMPARE(said("Open"), QString("Öffnen")); }

    void namesAndNumbersStayInTheirPlaces()
    {
        QCOMPARE(said("Opening bracket.step"), QString("bracket.step wird geöffnet"));
        QCOMPARE(said("3 of 12 parts"), QString("Von 12 Teilen 3"));
        QCOMPARE(said("7 files"), QString("7 Dateien"));
        QCOMPARE(said("1 files"), QString("eine Datei"));
    }

    void phrasesInsideOfOthersAreSaidAgainToo() { QCOMPARE(said("Add Block"), QString("Klotz hinzufügen")); }

    void whoShowsATextDecidesWhatItMeans()
    {
        QCOMPARE(said("Back", {"Window"}), QString("Zurück"));
        QCOMPARE(said("Back", {"Tool", "Window"}), QString("Rücken"));
        QCOMPARE(said("Back", {"Other"}), QString("Zurück"));
    }

    void whatWasNeverSaidStays()
    {
        QCOMPARE(said("bracket"), QString("bracket"));
        QCOMPARE(said("12.5 mm"), QString("12.5 mm"));
        QCOMPARE(said(""), QString(""));
        QCOMPARE(said("my \"part\""), QString("my \"part\"")); // a shape without letters of its own fits nothing
    }

private:
    Phrasebook m_book;

    QString said(const QString& shown, const QByteArrayList& contexts = {"Window"})
    {
        return m_book.translated(shown, contexts, german);
    }
};

QTEST_APPLESS_MAIN(PhrasebookTest)
#include "phrasebook_test.moc"
