#include "support/window_on_test.h"
#include "ui/help/handbook.h"
#include "ui/help/handbook_window.h"

#include <QFileInfo>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QProcess>
#include <QRegularExpression>
#include <QTextBrowser>

using namespace knead;

class WindowHandbookTest : public QObject, private WindowOnTest {
    Q_OBJECT
private slots:
    void initTestCase()
    {
        if (!hasDisplay())
            KNEAD_SKIP_WITHOUT("display", "The view needs a display: run this test under xvfb-run.");
        prepare();
    }

    void init() { show(m_services); }
    void cleanup() { m_window.reset(); }

    void opensAtThePageOfThePanel()
    {
        if (QWidget* at = QApplication::focusWidget())
            at->clearFocus();
        QTest::keyClick(m_window.get(), Qt::Key_F1);
        auto* book = find<HandbookWindow>("handbook");
        QVERIFY(book != nullptr && book->isVisible());
        QCOMPARE(book->page(), QString("keys"));
        picture("handbook-keys");
        book->close();
        auto* tree = find<QWidget>("modelTree");
        QVERIFY(tree != nullptr);
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get(), patience));
        tree->setFocus();
        QTRY_COMPARE(QApplication::focusWidget(), tree);
        action("handbook")->trigger();
        QCOMPARE(book->page(), QString("selecting"));
        QTest::keyClick(book, Qt::Key_Escape);
        QVERIFY(!book->isVisible());
    }

    void findsPagesByWords()
    {
        m_window->features().preferences->setTheme(Theme::Dark);
        action("handbook")->trigger();
        auto* list = find<QListWidget>("handbookPages");
        const int all = list->count();
        QCOMPARE(static_cast<std::size_t>(all), handbook::pages().size());
        auto* search = find<QLineEdit>("handbookSearch");
        QTest::keyClicks(search, "neo-Hooke");
        QVERIFY(list->count() >= 1 && list->count() < all);
        const auto* text = find<QTextBrowser>("handbookText");
        QCOMPARE(text->textCursor().selectedText(), QString("neo-Hooke"));
        picture("handbook-search");
        search->setText("zzz never said");
        QCOMPARE(list->count(), 0);
        QVERIFY(!text->toPlainText().isEmpty()); // says so
        search->clear();
        QCOMPARE(list->count(), all);
    }

    void everyPageIsThereAndItsLinksLeadSomewhere()
    {
        static const QRegularExpression link(R"(\]\(([^)\s]+)\))");
        action("handbook")->trigger();
        auto* book = find<HandbookWindow>("handbook");
        int links = 0;
        for (const handbook::Page& page : handbook::pages()) {
            QVERIFY2(page.text.size() > 200, qPrintable(page.name));
            for (const QRegularExpressionMatch& match : link.globalMatch(page.text)) {
                const QString to = match.captured(1);
                if (to.contains("://"))
                    continue;
                emit find<QTextBrowser>("handbookText")->anchorClicked(QUrl(to));
                const QString name = to.endsWith("examples/README.md") ? "recipes" : QFileInfo(to).completeBaseName();
                QVERIFY2(book->page() == name, qPrintable(page.name + ": " + to));
                ++links;
            }
        }
        QVERIFY(links >= 1);
    }

    /// "*File > Export as recipe*", and keys.
    void actionsAndKeysThatItNamesExist()
    {
        static const QRegularExpression way(R"(\*([A-Z][a-z]+) > ([^*\n]+)\*)");
        static const QRegularExpression key(
            R"(\b((?:Ctrl|Shift|Alt)\+(?:(?:Ctrl|Shift|Alt)\+)*(?:[A-Z0-9]|F\d\d?|Tab))\b)");
        QHash<QString, QStringList> entries;
        QStringList keys;
        for (const QAction* menu : m_window->menuBar()->actions())
            entries[plain(menu->text())] = textsOf(*menu->menu());
        for (const QAction* one : m_window->findChildren<QAction*>())
            for (const QKeySequence& sequence : one->shortcuts())
                keys << sequence.toString(QKeySequence::PortableText);
        int ways = 0;
        int named = 0;
        for (const handbook::Page& page : handbook::pages()) {
            for (const QRegularExpressionMatch& match : way.globalMatch(page.text)) {
                QVERIFY2(entries.value(match.captured(1)).contains(match.captured(2)),
                         qPrintable(page.name + ": " + match.captured()));
                ++ways;
            }
            if (page.name == "command-line") // keys of a terminal
                continue;
            for (const QRegularExpressionMatch& match : key.globalMatch(page.text)) {
                QVERIFY2(keys.contains(match.captured(1)), qPrintable(page.name + ": " + match.captured()));
                ++named;
            }
        }
        QVERIFY(ways >= 5 && named >= 15);
    }

    /// "`io/project`"
    void placesInTheCodeThatItNamesExist()
    {
        static const QRegularExpression place("`((?:core|io|ui|app|tests|resources)/[\\w/.-]+)`");
        int named = 0;
        for (const handbook::Page& page : handbook::pages())
            for (const QRegularExpressionMatch& match : place.globalMatch(page.text)) {
                QVERIFY2(QFileInfo::exists(KNEAD_RESOURCES "/../" + match.captured(1)),
                         qPrintable(page.name + ": " + match.captured()));
                ++named;
            }
        QVERIFY(named > 10);
    }

    /// "knead info bracket.step"
    void commandsThatItNamesExist()
    {
        static const QRegularExpression command("^knead ([a-z]+)\\b", QRegularExpression::MultilineOption);
        QSet<QString> names;
        for (const handbook::Page& page : handbook::pages())
            for (const QRegularExpressionMatch& match : command.globalMatch(page.text))
                names.insert(match.captured(1));
        QVERIFY(names.size() >= 5);
        for (const QString& name : names)
            QCOMPARE(QProcess::execute(KNEAD_PROGRAM, {name, "--help"}), 0);
    }

private:
    static QString plain(QString text) { return text.remove('&').remove("..."); }

    static QStringList textsOf(const QMenu& menu)
    {
        QStringList texts;
        for (const QAction* one : menu.actions()) {
            texts << plain(one->text());
            if (one->menu() != nullptr)
                texts << textsOf(*one->menu());
        }
        return texts;
    }
};

QTEST_MAIN(WindowHandbookTest)
#include "window_handbook_test.moc"
