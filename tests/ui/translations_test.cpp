#include "ui/language/language.h"
#include "ui/units.h"

#include <QDir>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <QtTest>

using namespace knead;

namespace {

struct Entry {
    QString context, source, state;
    QStringList said;
};

QString fileOf(const QString& code)
{
    return QString(KNEAD_RESOURCES "/translations/knead_%1.ts").arg(code);
}

std::vector<Entry> messagesIn(const QString& path)
{
    QFile file(path);
    if (!file.open(QFile::ReadOnly))
        return {};
    std::vector<Entry> messages;
    QString context;
    QXmlStreamReader reader(&file);
    while (!reader.atEnd()) {
        if (reader.readNext() != QXmlStreamReader::StartElement)
            continue;
        const QString name = reader.name().toString();
        if (name == "name") {
            context = reader.readElementText();
        } else if (name == "source") {
            messages.push_back({context, reader.readElementText(), {}, {}});
        } else if (name == "translation") {
            Entry& message = messages.back();
            message.state = reader.attributes().value("type").toString();
            const QString text = reader.readElementText(QXmlStreamReader::IncludeChildElements);
            message.said = text.trimmed().split('\n', Qt::SkipEmptyParts);
            if (!message.source.contains("%n"))
                message.said = {text};
        }
    }
    return messages;
}

std::vector<Entry> messagesOf(const QString& code)
{
    return messagesIn(fileOf(code));
}

QStringList placesOf(const QString& text)
{
    static const QRegularExpression place("%(?:\\d|n)");
    QStringList places;
    for (auto found = place.globalMatch(text); found.hasNext();)
        places << found.next().captured();
    places.sort();
    places.removeDuplicates();
    return places;
}

} // namespace

/// The files that translators write, and numbers in every language.
class TranslationsTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase_data()
    {
        QTest::addColumn<QString>("code");
        for (const Language& language : languages())
            QTest::newRow(language.code) << QString(language.code);
    }

    void nothingIsUnfinished()
    {
        QFETCH_GLOBAL(QString, code);
        const std::vector<Entry> messages = messagesOf(code);
        QVERIFY(!messages.empty());
        for (const Entry& message : messages) {
            QVERIFY2(message.state.isEmpty(),
                     qPrintable(message.context + ": " + message.source + ": " + message.state));
            for (const QString& said : message.said)
                QVERIFY2(!said.trimmed().isEmpty(), qPrintable(message.context + ": " + message.source));
        }
        QVERIFY(code == "en" || messages.size() > 600);
    }

    /// As `./dev translate` would find them.
    void everyTextOfTheWindowIsThere()
    {
        QFETCH_GLOBAL(QString, code);
        if (code == "en")
            QSKIP("The others are what the code says.");
        const QTemporaryDir folder;
        const QString copy = folder.filePath("knead.ts");
        QVERIFY(QFile::copy(fileOf(code), copy));
        QProcess update;
        update.setWorkingDirectory(KNEAD_RESOURCES "/..");
        update.start("/usr/lib/qt6/bin/lupdate",
                     {"-silent", "-no-obsolete", "-locations", "none", "-source-language", "en", "-target-language",
                      code, "-tr-function-alias", "QT_TRANSLATE_NOOP+=Message", "core", "io", "ui", "app", "-ts",
                      copy});
        QVERIFY(update.waitForFinished(60'000) && update.exitCode() == 0);
        const std::vector<Entry> messages = messagesIn(copy);
        for (const Entry& message : messages)
            QVERIFY2(message.state.isEmpty(), qPrintable(message.context + ": " + message.source));
        QCOMPARE(messages.size(), messagesOf(code).size()); // and nothing is there that is said no more
    }

    void placesForNumbersAndNamesAreKept()
    {
        QFETCH_GLOBAL(QString, code);
        for (const Entry& message : messagesOf(code))
            for (const QString& said : message.said) {
                QStringList wanted = placesOf(message.source);
                QStringList there = placesOf(said);
                wanted.removeAll("%n"); // one file needs no number
                there.removeAll("%n");
                QVERIFY2(wanted == there, qPrintable(message.source + " / " + said));
            }
    }

    void bordersAndTagsAreKept()
    {
        QFETCH_GLOBAL(QString, code);
        static const QRegularExpression tag("<[^>]*>");
        for (const Entry& message : messagesOf(code))
            for (const QString& said : message.said) {
                QCOMPARE(said.count(tag), message.source.count(tag));
                if (!message.source.contains("%n"))
                    QVERIFY2(message.source.startsWith(' ') == said.startsWith(' '), qPrintable(message.source));
                QVERIFY2(message.source.endsWith("...") == said.endsWith("..."),
                         qPrintable(message.source + " / " + said));
            }
    }

    void keysOfAMenuAreDifferent()
    {
        QFETCH_GLOBAL(QString, code);
        static const QRegularExpression key("&(.)");
        QStringList bar;
        for (const Entry& message : messagesOf(code))
            if ((message.context == "WindowMenus" || message.context == "MeasuringFeature") &&
                message.source.startsWith('&'))
                bar << key.match(message.said.front()).captured(1).toLower();
        QVERIFY(code == "en" || bar.size() >= 6);
        QCOMPARE(bar.removeDuplicates(), 0);
        QVERIFY(!bar.contains(QString()));
    }

    void bothDecimalSeparatorsAreTakenInEveryLanguage()
    {
        QFETCH_GLOBAL(QString, code);
        speak(code);
        QCOMPARE(spokenLanguage(), code);
        QLocale::setDefault(QLocale(code));
        QCOMPARE(parseQuantity("12.5 mm", Quantity::Length), std::optional(0.0125));
        QCOMPARE(parseQuantity("12,5 mm", Quantity::Length), std::optional(0.0125));
        QCOMPARE(parseQuantity("1,2e3", Quantity::Number), std::optional(1200.0));
        QCOMPARE(formatQuantity(0.0125, Quantity::Length), code == "en" ? QString("12.5 mm") : QString("12,5 mm"));
        QLocale::setDefault(QLocale::c());
        speak("en");
    }

    void theSystemsLanguageIsTakenWhenItIsOurs()
    {
        QFETCH_GLOBAL(QString, code);
        QCOMPARE(languageFor(code), code);
        QVERIFY(languageFor("tlh").size() == 2);
    }
};

QTEST_GUILESS_MAIN(TranslationsTest)
#include "translations_test.moc"
