#include "support/window_on_test.h"
#include "ui/help/handbook.h"
#include "ui/help/handbook_window.h"
#include "ui/interaction/hands.h"
#include "ui/project/project_keeper.h"

#include <QDockWidget>
#include <QFileInfo>
#include <QKeySequenceEdit>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QProcess>
#include <QRegularExpression>
#include <QTextBrowser>
#include <QTreeWidget>

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

    /// Every panel: the page that opens speaks of it.
    void opensAtThePageOfEveryPanel()
    {
        const QHash<QString, QString> spokenOf{
            {"modelDock", "tree"},           {"historyDock", "History panel"}, {"simulationDock", "Simulation dock"},
            {"propertiesDock", "panel"},     {"displayDock", "Display"},       {"handsDock", "panel Hands"},
            {"timelineDock", "Timeline"},    {"logDock", "The Log"},           {"importDock", "Import report"},
            {"exportDock", "Export report"}, {"deformDock", "Stays in place"}, {"performanceDock", "fast"},
            {"measureDock", "Measure"},      {"probeDock", "Probes"},          {"forcesDock", "Forces over time"},
            {"traceDock", "Python trace"}};
        openExample("bar.step", 10);
        int docks = 0;
        for (auto* dock : m_window->findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
            const QByteArray name = dock->objectName().toUtf8();
            QVERIFY2(spokenOf.contains(dock->objectName()), name);
            dock->show();
            dock->raise();
            QWidget* at = dock->widget();
            at->setFocusPolicy(Qt::StrongFocus);
            for (QWidget* one : at->findChildren<QWidget*>()) // what a person comes to first
                if (one->isVisible() && one->isEnabled() && (one->focusPolicy() & Qt::TabFocus) != 0) {
                    at = one;
                    break;
                }
            at->setFocus();
            QVERIFY2(dock->isAncestorOf(QApplication::focusWidget()), name);
            verifyPage(*QApplication::focusWidget(), spokenOf[dock->objectName()]);
            ++docks;
        }
        QCOMPARE(docks, static_cast<int>(spokenOf.size()));
    }

    /// That of the properties goes by what is selected.
    void opensAtThePageOfWhatIsSelected()
    {
        openExample("bar.step", 10);
        auto* dock = find<QDockWidget>("propertiesDock");
        dock->widget()->setFocusPolicy(Qt::StrongFocus);
        document().addTool(ToolKind::box);
        QTRY_COMPARE(document().selection().kind, Selection::Kind::Tool);
        dock->widget()->setFocus();
        QCOMPARE(pageAfterF1(*dock->widget()), QString("hands"));
        document().select({Selection::Kind::Body, 0});
        dock->widget()->setFocus();
        QCOMPARE(pageAfterF1(*dock->widget()), QString("measuring"));
    }

    /// In the view: at what the mouse does.
    void opensAtThePageOfTheMode()
    {
        openExample("bar.step", 10);
        ViewportWidget& view = m_window->viewport();
        view.setFocus();
        QCOMPARE(pageAfterF1(view), QString("keys"));
        for (const QAction* mode : m_window->hands().modes()) {
            action(qPrintable(mode->objectName()))->setChecked(true);
            QVERIFY2(pageAfterF1(view) == "hands", qPrintable(mode->objectName()));
            action(qPrintable(mode->objectName()))->setChecked(false);
        }
        action("measureDistance")->setChecked(true);
        QCOMPARE(pageAfterF1(view), QString("measuring"));
        action("measureDistance")->setChecked(false);
    }

    void opensOnTheFirstPage()
    {
        auto* open = find<QWidget>("homeOpen");
        open->setFocus();
        verifyPage(*open, "Opening files");
    }

    /// Every dialog, those included that keep the window waiting: the book does not wait with it.
    void opensAtThePageOfEveryDialog_data()
    {
        QTest::addColumn<QString>("asked"); // an action, or how else it comes
        QTest::addColumn<QString>("name");  // of the dialog
        QTest::addColumn<QString>("spoken");
        const auto row = [](const char* asked, const char* name, const char* spoken) {
            QTest::newRow(name) << QString(asked) << QString(name) << QString(spoken);
        };
        row("open", "openDialog", "Opening files");
        row("choices", "importDialog", "choose parts");
        row("addPart", "addPartDialog", "Add part");
        row("export", "exportDialog", "STEP (AP242");
        row("exportRecipe", "recipeDialog", "A recipe is a JSON file");
        row("applyToPart", "otherPartDialog", "The next revision");
        row("saveAs", "saveDialog", "saves a project");
        row("another", "saveQuestion", "What is not saved");
        row("savePicture", "pictureDialog", "Save picture");
        row("recordVideo", "recordDialog", "Record video");
        row("compareWithOriginal", "comparisonDialog", "Compare with original");
        row("preferences", "preferencesDialog", "Preferences");
        row("partColor", "partColorDialog", "colors");
        row("controls", "controlsBox", "Mouse and keys");
        row("about", "aboutBox", "How it is built");
    }

    void opensAtThePageOfEveryDialog()
    {
        QFETCH(QString, asked);
        QFETCH(QString, name);
        QFETCH(QString, spoken);
        openExample("bar.step", 10);
        document().select({Selection::Kind::Body, 0});
        if (asked == "recordVideo") { // of what was simulated
            document().play();
            QTRY_VERIFY(snapshot().time > 0.1);
            document().pause();
            QTRY_VERIFY(document().isSettled());
        }
        if (asked == "another") {
            document().addTool(ToolKind::ball);
            QTRY_VERIFY(m_window->projects().isModified());
            m_window->features().imports->openInstead({example("plate.step")});
        } else if (asked == "choices") {
            m_window->features().imports->openWithChoices({example("plate.step")});
        } else {
            QTRY_VERIFY(action(qPrintable(asked))->isEnabled());
            action(qPrintable(asked))->trigger();
        }
        QVERIFY(comesTrue([&] { return shownDialog(name) != nullptr; }));
        QPointer<QDialog> dialog = shownDialog(name);
        activate(*dialog);
        QWidget* at = dialog->focusWidget() != nullptr ? dialog->focusWidget() : dialog.data();
        verifyPage(*at, spoken, dialog);
        dialog->reject();
        QTRY_VERIFY(dialog == nullptr || !dialog->isVisible());
    }

    /// A key that is to be given to a command is no question.
    void aKeyThatIsTypedForACommandOpensNothing()
    {
        action("shortcuts")->trigger();
        QTRY_VERIFY(find<QKeySequenceEdit>("shortcutKey") != nullptr);
        activate(*find<QDialog>("preferencesDialog")); // else the key is one of the window
        auto* list = find<QTreeWidget>("shortcutList");
        list->setCurrentItem(list->topLevelItem(0)->child(0)); // of the first menu
        QVERIFY(find<QKeySequenceEdit>("shortcutKey")->isEnabled());
        QTest::keyClick(find<QKeySequenceEdit>("shortcutKey"), Qt::Key_F1);
        QVERIFY(find<HandbookWindow>("handbook") == nullptr);
        find<QDialog>("preferencesDialog")->reject();
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
        static const QRegularExpression link(R"((?<!!)\[[^\]]+\]\(([^)\s]+)\))");
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

    void itsPicturesAreThereAndAsWideAsTheText()
    {
        static const QRegularExpression picture(R"(!\[([^\]]*)\]\(([^)\s]+)\))");
        action("handbook")->trigger();
        auto* book = find<HandbookWindow>("handbook");
        auto* text = find<QTextBrowser>("handbookText");
        int pictures = 0;
        for (const handbook::Page& page : handbook::pages())
            for (const QRegularExpressionMatch& match : picture.globalMatch(page.text)) {
                QVERIFY2(match.captured(1).size() > 20, qPrintable(page.name + ": says not what is to be seen"));
                book->open(page.name);
                for (const int width : {940, 700}) {
                    book->resize(width, 680);
                    QTRY_COMPARE(book->width(), width);
                    const auto shown =
                        text->document()->resource(QTextDocument::ImageResource, match.captured(2)).value<QPixmap>();
                    QVERIFY2(!shown.isNull(), qPrintable(match.captured(2)));
                    QVERIFY(shown.deviceIndependentSize().width() <= text->viewport()->width());
                    QVERIFY(shown.deviceIndependentSize().width() > 0.8 * text->viewport()->width());
                }
                ++pictures;
            }
        QVERIFY(pictures >= 10);
        book->open("deforming");
        this->picture("handbook-pictures");
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
    /// There may be no window manager that does it.
    static void activate(QDialog& dialog)
    {
        QVERIFY(comesTrue([&] {
            if (QApplication::activeWindow() != &dialog)
                dialog.activateWindow();
            return QApplication::activeWindow() == &dialog;
        }));
    }

    QDialog* shownDialog(const QString& name)
    {
        for (QDialog* dialog : m_window->findChildren<QDialog*>(name))
            if (dialog->isVisible())
                return dialog;
        return nullptr;
    }

    QString pageAfterF1(QWidget& at)
    {
        QTest::keyClick(&at, Qt::Key_F1);
        auto* book = find<HandbookWindow>("handbook");
        if (book == nullptr || !book->isVisible())
            return {};
        const QString page = book->page();
        book->close();
        m_window->activateWindow();
        return page;
    }

    /// F1 there leads to a page that has the words. @param dialog that it lies over, if that keeps the window waiting
    void verifyPage(QWidget& at, const QString& spoken, QDialog* dialog = nullptr)
    {
        QTest::keyClick(&at, Qt::Key_F1);
        auto* book = find<HandbookWindow>("handbook");
        QVERIFY(book != nullptr && book->isVisible());
        const handbook::Page* page = handbook::pageNamed(book->page());
        QVERIFY(page != nullptr);
        const QString words = QString(page->words).replace(QRegularExpression("\\s+"), " ");
        QVERIFY2(words.contains(spoken), qPrintable(page->name + " has not: " + spoken));
        if (dialog != nullptr && dialog->isModal())
            QCOMPARE(book->parentWidget(), static_cast<QWidget*>(dialog)); // else nothing could be clicked in it
        book->close();
        m_window->activateWindow();
    }

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
