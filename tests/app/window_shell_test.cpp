#include "support/window_on_test.h"
#include "ui/commands/command_palette.h"
#include "ui/commands/listed_actions.h"
#include "ui/commands/synonyms.h"
#include "ui/language/language.h"
#include "ui/language/said.h"
#include "ui/panels/plot_view.h"
#include "ui/panels/quantity_field.h"
#include "ui/preferences/preferences_dialog.h"
#include "ui/project/project_keeper.h"
#include "ui/run_window.h"

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDockWidget>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QRegularExpression>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QSpinBox>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QToolBar>
#include <QToolButton>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>
#include <QXmlStreamReader>
#include <QtTest>

#include <algorithm>

using namespace knead;

using Words = QList<std::pair<QString, QString>>; ///< what is typed, and the name of the action that is meant

/// What is around the work: commands, keys, preferences, languages, panels, tour, about.
class WindowShellTest : public QObject, WindowOnTest {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        if (!hasDisplay())
            KNEAD_SKIP_WITHOUT("display", "The view needs a display: run this test under xvfb-run.");
        prepare();
    }

    void init()
    {
        QSettings settings;
        settings.clear();
        settings.setValue("language", "en");
        settings.setValue("theme", "light");
        show(m_services);
    }

    void cleanup()
    {
        m_window.reset();
        speak("en");
    }

    // --- commands -------------------------------------------------------------------------------------------------------

    void noKeyIsForTwoActions()
    {
        QHash<QString, QString> holders;
        const auto give = [&](const QKeySequence& key, const QString& holder) {
            const QString text = key.toString(QKeySequence::PortableText);
            QVERIFY2(text.isEmpty() || !holders.contains(text),
                     qPrintable(text + ": " + holders[text] + ", " + holder));
            holders[text] = holder;
        };
        for (const QAction* menu : m_window->menuBar()->actions())
            give(QKeySequence::mnemonic(menu->text()), menu->text());
        for (const ListedAction& one : listedActions(*m_window))
            for (const QKeySequence& key : one.action->shortcuts())
                give(key, one.action->objectName());
        QVERIFY(holders.size() > 60);
    }

    void everyActionIsInAMenuAndThePaletteAndSaysItsKeys()
    {
        press(m_window.get(), Qt::Key_K, Qt::ControlModifier);
        QTRY_VERIFY(palette()->isVisible());
        QSet<QAction*> offered;
        for (const ListedAction& one : palette()->shown())
            offered << one.action;
        QSet<QAction*> inMenus;
        for (const ListedAction& one : listedActions(*m_window))
            if (!one.menu.isEmpty())
                inMenus << one.action;
        int count = 0;
        for (QAction* action : m_window->findChildren<QAction*>()) {
            if (action->text().isEmpty() || action->isSeparator() || action->menu<QMenu*>() != nullptr ||
                qobject_cast<QWidget*>(action->parent()) == nullptr || isOfAField(action))
                continue;
            ++count;
            const QByteArray name = (action->objectName() + ' ' + action->text()).toUtf8();
            QVERIFY2(offered.contains(action), name);
            QVERIFY2(inMenus.contains(action), name);
            QVERIFY2(!action->toolTip().isEmpty(), name);
            for (const QKeySequence& key : action->shortcuts())
                QVERIFY2(action->toolTip().contains(key.toString(QKeySequence::NativeText)), name);
        }
        QVERIFY(count > 60);
    }

    void aCommandIsFoundByAFewLettersAndDone()
    {
        openExample("bar.step");
        press(m_window.get(), Qt::Key_K, Qt::ControlModifier);
        QTRY_VERIFY(palette()->isVisible());
        auto* field = find<QLineEdit>("paletteField");
        QVERIFY(field->hasFocus());
        QTest::keyClicks(field, "gravi");
        QCOMPARE(palette()->shown().front().text, QString("Gravity"));
        QCOMPARE(palette()->shown().front().menu, QString("Simulation"));
        picture("palette");
        press(field, Qt::Key_Return);
        QTRY_VERIFY(!snapshot().gravity.isZero());
        QVERIFY(!palette()->isVisible());
        QTRY_VERIFY(m_window->viewport().hasFocus());
        press(m_window.get(), Qt::Key_K, Qt::ControlModifier); // what was done last comes first
        QTRY_VERIFY(palette()->isVisible());
        QCOMPARE(palette()->shown().front().text, QString("Gravity"));
    }

    /// What people type who do not know what a command is called here: the first that is found. Names come first, those of panels
    /// and examples, too.
    void aCommandIsFoundByWhatElseItIsCalled_data()
    {
        QTest::addColumn<QString>("language");
        QTest::addColumn<Words>("words");
        QTest::newRow("en") << QString("en") << Words{{"orbit", "controls"},        {"rotate view", "controls"},
                                                      {"sculpt", "show_sculptBar"}, {"mold", "sculptThumb"},
                                                      {"knead", "sculptThumb"},     {"undo", "undo"},
                                                      {"revert", "undo"},           {"zoom", "fit"},
                                                      {"glue", "glueSelection"},    {"join", "glueSelection"},
                                                      {"cut", "cutHere"},           {"slice", "cutHere"},
                                                      {"blade", "addKnife"},        {"save as", "saveAs"},
                                                      {"write as", "saveAs"},       {"IGES", "export"},
                                                      {"print", "export"},          {"3D print", "export"},
                                                      {"weight", "measureMass"},    {"ruler", "measureDistance"},
                                                      {"tutorial", "tour"},         {"manual", "handbook"},
                                                      {"hotkeys", "shortcuts"},     {"shortcuts", "shortcuts"},
                                                      {"dark mode", "darkTheme"},   {"language", "preferences"},
                                                      {"settings", "preferences"},  {"screenshot", "savePicture"},
                                                      {"movie", "recordVideo"},     {"video", "recordVideo"},
                                                      {"delete", "remove"},         {"clamp", "fixFaces"}};
        QTest::newRow("de")
            << QString("de")
            << Words{{"umkreisen", "controls"},         {"kneten", "sculptThumb"}, {"Gewicht", "measureMass"},
                     {"Lineal", "measureDistance"},     {"3D-Druck", "export"},    {"Hilfe", "handbook"},
                     {"Bildschirmfoto", "savePicture"}, {"Sprache", "preferences"}};
        QTest::newRow("fr") << QString("fr")
                            << Words{{"petrir", "sculptThumb"},
                                     {"poids", "measureMass"},
                                     {"règle", "measureDistance"},
                                     {"aide", "handbook"},
                                     {"langue", "preferences"}};
        QTest::newRow("nl") << QString("nl")
                            << Words{{"kneden", "sculptThumb"},
                                     {"gewicht", "measureMass"},
                                     {"liniaal", "measureDistance"},
                                     {"hulp", "handbook"},
                                     {"taal", "preferences"}};
    }

    void aCommandIsFoundByWhatElseItIsCalled()
    {
        QFETCH(QString, language);
        QFETCH(Words, words);
        openExample("bar.step", 10); // what can be done comes first
        Preferences spoken = readPreferences();
        spoken.language = language;
        m_window->features().preferences->set(spoken);
        press(m_window.get(), Qt::Key_K, Qt::ControlModifier);
        QTRY_VERIFY(palette()->isVisible());
        auto* field = find<QLineEdit>("paletteField");
        QStringList wrong;
        for (const auto& [typed, meant] : words) {
            field->setText(typed);
            emit field->textEdited(typed); // letters that a test cannot press
            const std::vector<ListedAction> shown = palette()->shown();
            const QString first = shown.empty() ? QString("nothing") : shown.front().action->objectName();
            if (first != meant)
                wrong << QString("%1: %2, not %3").arg(typed, first, meant);
            if (typed == "sculpt")
                picture("palette-synonym");
        }
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join("; ")));
    }

    /// "STEP" is a step of time by its name, and a file, too; "back" is a view, and what is taken back.
    void namesComeBeforeSynonyms()
    {
        openExample("bar.step", 10);
        document().addTool(ToolKind::ball);
        QTRY_VERIFY(action("undo")->isEnabled());
        press(m_window.get(), Qt::Key_K, Qt::ControlModifier);
        QTRY_VERIFY(palette()->isVisible());
        auto* field = find<QLineEdit>("paletteField");
        const auto places = [&](const char* typed, const char* first, const char* then) {
            field->clear();
            QTest::keyClicks(field, typed);
            const std::vector<ListedAction> shown = palette()->shown();
            const auto placeOf = [&shown](const char* name) {
                return std::ranges::find(shown, QString(name),
                                         [](const ListedAction& one) { return one.action->objectName(); }) -
                       shown.begin();
            };
            QCOMPARE(placeOf(first), 0);
            QVERIFY(placeOf(then) < 4);
        };
        places("STEP", "step", "export");
        places("back", "viewBack", "undo");
    }

    void whatHasSynonymsIsThere()
    {
        QSet<QString> names;
        for (const ListedAction& one : listedActions(*m_window))
            names << one.action->objectName();
        for (const QString& action : actionsWithSynonyms()) {
            QVERIFY2(names.contains(action), qPrintable(action));
            QVERIFY2(!synonymsOf(action).isEmpty(), qPrintable(action));
        }
        QVERIFY(actionsWithSynonyms().size() > 50);
    }

    void filesOfLateMayChangeWhileCommandsAreListed()
    {
        openExample("bar.step");
        press(m_window.get(), Qt::Key_K, Qt::ControlModifier);
        QTRY_VERIFY(palette()->isVisible());
        auto* recent = find<QMenu>("recentMenu");
        const auto isRecent = [](const ListedAction& one) { return one.text == "bar.step"; };
        QVERIFY(std::ranges::any_of(palette()->shown(), isRecent));
        recent->clear();
        QTest::keyClicks(find<QLineEdit>("paletteField"), "bar");
        QVERIFY(std::ranges::none_of(palette()->shown(), isRecent));
    }

    void whatCannotBeDoneSaysWhyAndIsNotDone()
    {
        press(m_window.get(), Qt::Key_K, Qt::ControlModifier);
        QTRY_VERIFY(palette()->isVisible());
        auto* field = find<QLineEdit>("paletteField");
        QTest::keyClicks(field, "play");
        const auto* list = find<QListWidget>("paletteList");
        int row = 0;
        while (palette()->shown()[static_cast<std::size_t>(row)].action != action("play"))
            ++row;
        QVERIFY(list->item(row)->data(Qt::UserRole + 2).toString().contains("Open a part first."));
        for (int i = 0; i < row; ++i)
            press(field, Qt::Key_Down);
        press(field, Qt::Key_Return);
        QVERIFY(palette()->isVisible());
        picture("palette-disabled");
        press(field, Qt::Key_Escape);
        QVERIFY(!palette()->isVisible());
    }

    void arrowsGoThroughTheListAndAround()
    {
        press(m_window.get(), Qt::Key_K, Qt::ControlModifier);
        QTRY_VERIFY(palette()->isVisible());
        auto* field = find<QLineEdit>("paletteField");
        auto* list = find<QListWidget>("paletteList");
        QCOMPARE(list->currentRow(), 0);
        press(field, Qt::Key_Up);
        QCOMPARE(list->currentRow(), list->count() - 1);
        press(field, Qt::Key_Down);
        QCOMPARE(list->currentRow(), 0);
        QTest::keyClicks(field, "qqqq");
        QVERIFY(palette()->shown().empty());
        QCOMPARE(list->item(0)->text(), QString("Nothing is called like that: try fewer letters."));
        press(field, Qt::Key_Return); // nothing happens
        QVERIFY(palette()->isVisible());
    }

    // --- keys -----------------------------------------------------------------------------------------------------------

    void aCommandGetsAnotherKeyWhichIsKept()
    {
        choose("renormalize");
        auto* key = dialog()->findChild<QKeySequenceEdit*>("shortcutKey");
        key->setFocus();
        press(key, Qt::Key_J, Qt::ControlModifier);
        QTRY_COMPARE(action("renormalize")->shortcut(), QKeySequence("Ctrl+J"));
        QVERIFY(action("renormalize")->toolTip().endsWith("(Ctrl+J)"));
        QVERIFY(!action("renormalize")->toolTip().contains("(N)"));
        picture("keys");
        m_window.reset();
        show(m_services);
        QCOMPARE(action("renormalize")->shortcut(), QKeySequence("Ctrl+J"));
        choose("renormalize");
        QTest::mouseClick(dialog()->findChild<QPushButton*>("shortcutReset"), Qt::LeftButton);
        QCOMPARE(action("renormalize")->shortcut(), QKeySequence(Qt::Key_N));
        QVERIFY(!QSettings().contains("shortcuts/renormalize"));
    }

    void aKeyThatIsTakenIsNamedAndTakenOnlyWhenOneSaysSo()
    {
        choose("fit");
        auto* key = dialog()->findChild<QKeySequenceEdit*>("shortcutKey");
        auto* conflict = dialog()->findChild<QLabel*>("shortcutConflict");
        key->setFocus();
        press(key, Qt::Key_G);
        QTRY_COMPARE(conflict->text(), QString("G already does \"Gravity\"."));
        QCOMPARE(action("fit")->shortcut(), QKeySequence(Qt::Key_F));
        picture("keys-conflict");
        QTest::mouseClick(dialog()->findChild<QPushButton*>("shortcutTake"), Qt::LeftButton);
        QCOMPARE(action("fit")->shortcut(), QKeySequence(Qt::Key_G));
        QVERIFY(action("gravity")->shortcut().isEmpty());
        QTest::mouseClick(dialog()->findChild<QPushButton*>("preferencesDefaults"), Qt::LeftButton);
        QCOMPARE(action("fit")->shortcut(), QKeySequence(Qt::Key_F));
        QCOMPARE(action("gravity")->shortcut(), QKeySequence(Qt::Key_G));
    }

    void keysThatDriveToolsStayTheirs()
    {
        choose("fit");
        auto* key = dialog()->findChild<QKeySequenceEdit*>("shortcutKey");
        key->setFocus();
        press(key, Qt::Key_PageUp);
        QTRY_VERIFY(dialog()
                        ->findChild<QLabel*>("shortcutConflict")
                        ->text()
                        .contains("drives the selected tool: choose another key."));
        QCOMPARE(action("fit")->shortcut(), QKeySequence(Qt::Key_F));
    }

    // --- preferences ----------------------------------------------------------------------------------------------------

    void whatIsChosenHoldsAtOnceAndTheNextTime()
    {
        press(m_window.get(), Qt::Key_Comma, Qt::ControlModifier);
        QTRY_VERIFY(dialog() != nullptr && dialog()->isVisible());
        picture("preferences");
        pick("preferenceTheme", "Dark");
        QTRY_VERIFY(m_window->palette().color(QPalette::Window).lightness() < 100);
        QVERIFY(action("darkTheme")->isChecked());
        dialog()->show(PreferencesDialog::Page::Memory);
        auto* memory = dialog()->findChild<QSpinBox*>("preferenceHistory");
        memory->setFocus();
        memory->selectAll();
        QTest::keyClicks(memory, "128");
        press(memory, Qt::Key_Return);
        QCOMPARE(document().history().memoryLimit(), std::size_t{128} << 20U);
        QCOMPARE(find<QSpinBox>("historyMemoryAllowed")->value(), 128);
        auto* seconds = dialog()->findChild<QuantityField*>("preferenceKeeping");
        seconds->setFocus();
        seconds->selectAll();
        QTest::keyClicks(seconds, "10 s");
        press(seconds, Qt::Key_Return);
        picture("preferences-memory");
        m_window.reset();
        show(m_services);
        const Preferences kept = readPreferences();
        QCOMPARE(kept.historyMegabytes, 128);
        QCOMPARE(kept.keepingInterval, std::chrono::seconds(10));
        QCOMPARE(kept.look, Preferences::Look::Dark);
        QVERIFY(m_window->palette().color(QPalette::Window).lightness() < 100);
    }

    void defaultsComeBack()
    {
        Preferences changed;
        changed.look = Preferences::Look::Light;
        changed.language = "en";
        changed.filmMegabytes = 64;
        changed.lengthUnit = "in";
        m_window->features().preferences->set(changed);
        QCOMPARE(find<QLabel>("units")->text(), QString("in, N, MPa"));
        action("preferences")->trigger();
        QTRY_VERIFY(dialog() != nullptr);
        QCOMPARE(dialog()->findChild<QSpinBox*>("preferenceFilm")->value(), 64);
        QTest::mouseClick(dialog()->findChild<QPushButton*>("preferencesDefaults"), Qt::LeftButton);
        QCOMPARE(readPreferences().filmMegabytes, Preferences().filmMegabytes);
        QCOMPARE(find<QLabel>("units")->text(), QString("mm, N, MPa"));
        QVERIFY(!QSettings().contains("film/megabytes"));
    }

    void lengthsAreShownInTheChosenUnit()
    {
        openExample("bar.step");
        press(m_window.get(), Qt::Key_B);
        QTRY_COMPARE(document().selection().kind, Selection::Kind::Tool);
        auto* size = find<QuantityField>("toolSizeX");
        QTRY_VERIFY(size->text().endsWith(" mm"));
        QVERIFY(size->tip().contains("Units: mm, m, cm, µm, in"));
        Preferences inches = readPreferences();
        inches.lengthUnit = "in";
        m_window->features().preferences->set(inches);
        QVERIFY(size->text().endsWith(" in"));
        size->setFocus();
        size->selectAll();
        QTest::keyClicks(size, "0,5");
        press(size, Qt::Key_Return);
        QTRY_COMPARE(snapshot().tools[0].size.x(), 0.0127);
        Preferences usual = inches;
        usual.lengthUnit = "mm";
        m_window->features().preferences->set(usual);
        QTRY_COMPARE(size->text(), QString("12.7 mm"));
    }

    // --- languages ------------------------------------------------------------------------------------------------------

    void theWindowSpeaksAnotherLanguageAtOnce()
    {
        openExample("bracket.step");
        press(m_window.get(), Qt::Key_B);
        QTRY_COMPARE(document().selection().kind, Selection::Kind::Tool);
        QMap<QString, QString> english;
        for (const QAction* action : m_window->actions())
            english[action->objectName()] = action->text();
        emit document().notice(
            said(Message("Document", "Something is called \"%1\" already: choose another name.").with("Block 1")));
        QTRY_VERIFY(find<QLabel>("bannerText")->text().startsWith("Something is called"));
        action("preferences")->trigger();
        QTRY_VERIFY(dialog() != nullptr);
        pick("preferenceLanguage", "Deutsch");
        QTRY_COMPARE(m_window->menuBar()->actions().front()->text(), QString("&Datei"));
        QCOMPARE(action("open")->text(), QString("Ö&ffnen..."));
        QVERIFY(action("open")->toolTip().startsWith("Ein Teil, ein Projekt oder ein Rezept öffnen ("));
        QCOMPARE(find<QDockWidget>("historyDock")->windowTitle(), QString("Verlauf"));
        QTRY_COMPARE(find<QComboBox>("toolKind")->currentText(), QString("Block"));
        QCOMPARE(find<QComboBox>("toolKind")->itemText(1), QString("Kugel"));
        QVERIFY(!find<QTreeWidget>("modelTree")->findItems("Werkzeuge", Qt::MatchExactly).isEmpty());
        QVERIFY(action("undo")->text().startsWith("Rückgängig"));
        QTRY_VERIFY(find<QLabel>("objectCount")->text().endsWith(" Objekte"));
        QVERIFY(find<PlotView>("probePlot")->hint().startsWith("Noch keine"));
        QTRY_COMPARE(dialog()->windowTitle(), QString("Einstellungen"));
        QTRY_COMPARE(dialog()->findChild<QListWidget*>("preferencesIndex")->item(1)->text(),
                     QString("Speicher und Sicherheit"));
        for (const char* name : {"filmBack", "filmRate-0"})
            QCOMPARE(action(name)->property("whyDisabled").toString(),
                     QString("Zuerst etwas simulieren und darauf zurücksehen."));
        QCOMPARE(find<QComboBox>("filmRate")->itemText(0), QString("0,1x"));
        QCOMPARE(action("filmRate-0")->text(), QString("0,1x"));
        rest();
        picture("german");
        dialog()->close();
        const auto untranslated =
            textsLike({"Properties", "Timeline", "Nothing selected.", "Speed limit", "Force limit"});
        QVERIFY2(untranslated.isEmpty(), qPrintable(untranslated.join(", ")));
        for (const char* name : {"selectAll", "fixSelection", "section", "colorParts", "pull", "compareWithOriginal"})
            QVERIFY2(action(name)->text() != english[name], name);
        QCOMPARE(find<QLabel>("bannerText")->text(),
                 QString("Etwas heißt schon „Block 1“: einen anderen Namen wählen."));
        QTRY_VERIFY2(leftInEnglish().isEmpty(), qPrintable(leftInEnglish().join("; ")));
        QTRY_COMPARE(find<QTreeWidget>("historyTree")->topLevelItem(0)->text(0), QString("bracket.step importieren"));
        for (const char* code : {"fr", "nl", "en"}) {
            Preferences other = readPreferences();
            other.language = code;
            m_window->features().preferences->set(other);
            rest();
            picture(code);
        }
        QCOMPARE(m_window->menuBar()->actions().front()->text(), QString("&File"));
        QCOMPARE(find<QComboBox>("toolKind")->itemText(1), QString("Ball"));
        QVERIFY(action("undo")->text().startsWith("Undo"));
        QCOMPARE(action("renormalize")->text(), QString("Re-normalize"));
    }

    void whatAPersonNamedIsNotTranslated()
    {
        openAndRefill("bar.step", 16);
        const QString part = QString::fromStdString(document().content().bodies[0]->name);
        Preferences german = readPreferences();
        german.language = "de";
        m_window->features().preferences->set(german);
        QCOMPARE(QString::fromStdString(document().content().bodies[0]->name), part);
        QCOMPARE(document().history().tree().records().size(), std::size_t{2}); // opened and refilled, no entry more
    }

    // --- about ----------------------------------------------------------------------------------------------------------

    void aboutNamesWhatKneadIsMadeWith()
    {
        action("about")->trigger();
        QTRY_VERIFY(find<QDialog>("aboutBox") != nullptr);
        auto* list = find<QTreeWidget>("aboutLibraries");
        for (const char* name : {"Qt", "VTK", "OpenCASCADE", "Eigen", "oneTBB", "SQLite"}) {
            const QList<QTreeWidgetItem*> found = list->findItems(name, Qt::MatchExactly);
            QVERIFY2(found.size() == 1, name);
            QVERIFY2(found[0]->text(1).contains(QRegularExpression("^\\d+\\.\\d+")), name);
            QVERIFY2(!found[0]->text(2).isEmpty(), name);
        }
        picture("about");
        QTest::mouseClick(find<QPushButton>("aboutCopy"), Qt::LeftButton);
        QVERIFY(QApplication::clipboard()->text().contains("Qt " + QString(qVersion())));
    }

    // --- panels, status -------------------------------------------------------------------------------------------------

    /// All six examples, without moving it.
    void theFirstPageFitsASmallWindow()
    {
        m_window->resize(1280, 800);
        rest();
        const auto* page = find<QScrollArea>("homePage");
        QVERIFY(page->isVisible());
        QCOMPARE(page->horizontalScrollBar()->maximum(), 0);
    }

    void theWindowBeginsNoLargerThanASmallScreen()
    {
        m_window = std::make_unique<MainWindow>(m_services);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get(), patience));
        QCOMPARE(m_window->size(), MainWindow::firstSize(m_window->screen()->availableSize()));
        QCOMPARE(MainWindow::firstSize({1920, 1080}), QSize(1280, 800));
        const QSize small = MainWindow::firstSize({1280, 800}); // the system's title bar comes on top
        QVERIFY(small.width() < 1280 && small.height() <= 760);
    }

    void fullScreenLeavesAMaximizedWindowMaximized()
    {
        m_window->showMaximized();
        QTRY_VERIFY(m_window->isMaximized());
        for (int i = 0; i < 2; ++i) {
            press(m_window.get(), Qt::Key_F11);
            QTRY_VERIFY(m_window->isFullScreen() && action("fullScreen")->isChecked());
            press(m_window.get(), Qt::Key_F11);
            QTRY_VERIFY(!m_window->isFullScreen() && !action("fullScreen")->isChecked());
            QVERIFY(m_window->isMaximized());
        }
    }

    void panelsCloseComeBackAndAreRemembered()
    {
        auto* dock = find<QDockWidget>("propertiesDock");
        QVERIFY(dock->isVisible());
        action("show_propertiesDock")->trigger();
        QVERIFY(!dock->isVisible());
        auto* timeline = find<QDockWidget>("timelineDock");
        m_window->addDockWidget(Qt::TopDockWidgetArea, timeline);
        QCOMPARE(m_window->dockWidgetArea(timeline), Qt::TopDockWidgetArea);
        m_window->close();
        m_window.reset();
        show(m_services);
        QVERIFY(!find<QDockWidget>("propertiesDock")->isVisible());
        QCOMPARE(m_window->dockWidgetArea(find<QDockWidget>("timelineDock")), Qt::TopDockWidgetArea);
        action("resetLayout")->trigger();
        QTRY_VERIFY(find<QDockWidget>("propertiesDock")->isVisible());
        QCOMPARE(m_window->dockWidgetArea(find<QDockWidget>("timelineDock")), Qt::BottomDockWidgetArea);
        QTRY_VERIFY(std::abs(find<QDockWidget>("propertiesDock")->width() - 300) < 40);
        picture("layout-reset");
    }

    void panelsOfOccasionComeWithTheOccasion()
    {
        for (const char* name : {"measureDock", "probeDock", "forcesDock"})
            QVERIFY2(find<QDockWidget>(name)->isHidden(), name);
        action("show_probeDock")->trigger();
        QVERIFY(find<QDockWidget>("probeDock")->isVisible());
        m_window->close();
        m_window.reset();
        show(m_services);
        QVERIFY(!find<QDockWidget>("probeDock")->isHidden());
        action("resetLayout")->trigger();
        QTRY_VERIFY(find<QDockWidget>("probeDock")->isHidden());
        openExample("bar.step");
        action("forcePlot")->trigger();
        QTRY_VERIFY(find<QDockWidget>("forcesDock")->isVisible());
        action("placeProbe")->trigger();
        QTRY_VERIFY(find<QDockWidget>("probeDock")->isVisible());
    }

    void noButtonFallsOffTheToolBar()
    {
        openExample("bar.step");
        const auto* bar = find<QToolBar>("toolBar");
        for (const int width : {1280, 1920})
            for (const char* code : {"de", "fr", "nl", "en"}) {
                Preferences other = readPreferences();
                other.language = code;
                m_window->features().preferences->set(other);
                m_window->resize(width, 800);
                QTRY_COMPARE(m_window->width(), width);
                QTRY_VERIFY2(bar->findChild<QToolButton*>("measureButton")->geometry().right() < bar->width(), code);
                QVERIFY2(bar->findChild<QToolButton*>("measureButton")->isVisible(), code);
            }
        const auto* play = qobject_cast<QToolButton*>(bar->widgetForAction(action("play")));
        QCOMPARE(play->toolButtonStyle(), Qt::ToolButtonTextBesideIcon);
        picture("tool-bar-wide");
    }

    void theToolBarStaysWhereItIsWhileTimeRuns()
    {
        openExample("bar.step");
        const auto* bar = find<QToolBar>("toolBar");
        const auto places = [bar] {
            QList<QRect> all;
            for (const auto* button : bar->findChildren<QToolButton*>())
                all << button->geometry();
            return all;
        };
        drawn();
        const QList<QRect> before = places();
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QTRY_COMPARE(action("play")->text(), QString("Pause"));
        drawn();
        QCOMPARE(places(), before);
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QTRY_COMPARE(action("play")->text(), QString("Play"));
    }

    void theSelectionBarIsShownWithTheViewAsWished()
    {
        const auto* bar = find<QToolBar>("selectionBar");
        QVERIFY(bar->isHidden());
        openExample("bar.step");
        QVERIFY(bar->isVisible());
        action("show_selectionBar")->trigger();
        QVERIFY(bar->isHidden());
        show(m_services);
        openExample("bar.step");
        QVERIFY(find<QToolBar>("selectionBar")->isHidden());
    }

    void everyPanelIsListed()
    {
        for (const QDockWidget* dock : m_window->findChildren<QDockWidget*>()) {
            QVERIFY2(action(("show_" + dock->objectName()).toUtf8()) != nullptr, qPrintable(dock->objectName()));
            QVERIFY(dock->features().testFlag(QDockWidget::DockWidgetClosable));
            QVERIFY(dock->features().testFlag(QDockWidget::DockWidgetMovable));
        }
    }

    void messagesAndTheHintTakeTurns()
    {
        auto* hint = find<QLabel>("navigationHint");
        QVERIFY(hint->isVisible());
        m_window->statusBar()->showMessage("Saved bracket.knead.", 300);
        QVERIFY(!hint->isVisible());
        QTRY_VERIFY(hint->isVisible());
        m_window->statusBar()->showMessage("Saved bracket.knead.");
        m_window->open(QStringList(example("bar.step")));
        QVERIFY(m_window->statusBar()->currentMessage().isEmpty()); // the task is shown there
        QVERIFY(!hint->isVisible());
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning(), patience);
        QTRY_VERIFY(hint->isVisible());
    }

    // --- first page -----------------------------------------------------------------------------------------------------

    void theFirstPageComesBackWithoutClosingThePart()
    {
        QVERIFY(!action("firstPage")->isEnabled() && !action("addPart")->isEnabled());
        openExample("bar.step", 10);
        press(m_window.get(), Qt::Key_Space);
        QTRY_VERIFY(snapshot().playing);
        action("firstPage")->trigger();
        QVERIFY(find<QScrollArea>("homePage")->isVisible() && !m_window->viewport().isVisible());
        QTRY_VERIFY(!snapshot().playing);
        press(m_window.get(), Qt::Key_Escape);
        QVERIFY(m_window->viewport().isVisible() && !find<QScrollArea>("homePage")->isVisible());
        QVERIFY(!action("firstPage")->isChecked() && !document().isEmpty());
        QTRY_VERIFY(document().isSettled());
        m_window->projects().saveTo(QDir(m_folder.path()).filePath("first.knead"));
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->projects().isModified(), patience);
        action("firstPage")->trigger();
        auto* menu = find<QMenu>("examplesMenu");
        QVERIFY(menu->isEnabled() && menu->actions().size() > 6);
        action("example-plate.step")->trigger(); // another part ends it
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning() && m_window->windowTitle().startsWith("plate"),
                                 patience);
        QVERIFY(m_window->viewport().isVisible() && !action("firstPage")->isChecked());
    }

    void anotherWindowIsAtHand()
    {
        QAction* another = action("newWindow");
        QVERIFY(another != nullptr && another->isEnabled()); // without a part, too
        QCOMPARE(another->shortcut(), QKeySequence("Ctrl+N"));
    }

    void theFirstPageShowsExamplesAndFilesOfLateAsPictures()
    {
        for (const char* name : {"bar", "bracket", "grip", "handle", "lump", "plate"})
            QVERIFY2(QFile::exists(example(qPrintable(QString(name) + ".png"))), name);
        QVERIFY(!find<QLabel>("recentTitle")->isVisible());
        picture("home-first");
        openExample("bracket.step");
        QTest::qWait(2500); // a picture is taken
        m_window->close();
        m_window.reset();
        show(m_services);
        auto* card = find<QPushButton>("recent_bracket.step");
        QVERIFY(card != nullptr && card->isVisible());
        QVERIFY(find<QLabel>("recentTitle")->isVisible());
        picture("home-recent");
        m_window->features().preferences->setTheme(Theme::Dark);
        picture("home-dark");
        QTest::mouseClick(card, Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(!document().isEmpty(), patience);
    }

private:
    QTemporaryDir m_folder; ///< for projects

    CommandPalette* palette() { return find<CommandPalette>("commandPalette"); }
    PreferencesDialog* dialog() { return find<PreferencesDialog>("preferencesDialog"); }

    static void press(QWidget* widget, Qt::Key key, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::keyClick(widget, key, modifiers);
    }

    /// Line edits have actions of their own.
    static bool isOfAField(const QAction* action)
    {
        return qobject_cast<QLineEdit*>(action->parent()) != nullptr || action->objectName().startsWith("_q_");
    }

    /// Opens the page of keys at an action.
    void choose(const char* name)
    {
        action("shortcuts")->trigger();
        QTRY_VERIFY(dialog() != nullptr && dialog()->isVisible());
        auto* list = dialog()->findChild<QTreeWidget*>("shortcutList");
        for (int m = 0; m < list->topLevelItemCount(); ++m)
            for (int i = 0; i < list->topLevelItem(m)->childCount(); ++i)
                if (list->topLevelItem(m)->child(i)->data(0, Qt::UserRole).value<QObject*>() == action(name))
                    list->setCurrentItem(list->topLevelItem(m)->child(i));
        QVERIFY(list->currentItem() != nullptr);
    }

    void pick(const char* box, const QString& text)
    {
        auto* choice = dialog()->findChild<QComboBox*>(box);
        QVERIFY(choice->findText(text) >= 0);
        choice->setFocus();
        choice->setCurrentIndex(choice->findText(text));
    }

    /// Labels and buttons of the window that read so.
    /// Texts of the code, as shapes, that are said otherwise in German; and how they are said there.
    static QList<std::pair<QRegularExpression, QRegularExpression>> germanPhrases()
    {
        QList<std::pair<QRegularExpression, QRegularExpression>> phrases;
        QFile file(QStringLiteral(KNEAD_RESOURCES "/translations/knead_de.ts"));
        QString source;
        if (!file.open(QFile::ReadOnly))
            return phrases;
        for (QXmlStreamReader reader(&file); !reader.atEnd();) {
            if (reader.readNext() != QXmlStreamReader::StartElement)
                continue;
            if (reader.name() == u"source")
                source = reader.readElementText();
            else if (reader.name() == u"translation")
                if (const QString german = reader.readElementText(QXmlStreamReader::IncludeChildElements);
                    german != source && !source.contains("%n") && lettersIn(source) >= 3)
                    phrases.emplace_back(shapeOf(source), shapeOf(german));
        }
        return phrases;
    }

    static qsizetype lettersIn(const QString& text)
    {
        return std::ranges::count_if(QString(text).remove(QRegularExpression("%\\d")),
                                     [](QChar c) { return c.isLetter(); });
    }

    static QRegularExpression shapeOf(const QString& phrase)
    {
        static const QRegularExpression place("%\\d");
        QStringList pieces;
        for (const QString& piece : phrase.split(place))
            pieces << QRegularExpression::escape(piece);
        return QRegularExpression(QRegularExpression::anchoredPattern(pieces.join("(.+)")));
    }

    /// What somebody sees of the window, or reads when the mouse rests on it.
    QStringList shownTexts()
    {
        QStringList texts;
        for (const QWidget* widget : m_window->findChildren<QWidget*>()) {
            if (!widget->isVisible() || qobject_cast<const QLineEdit*>(widget) != nullptr)
                continue; // what is typed is a person's
            for (const char* name : {"text", "title", "windowTitle", "toolTip", "suffix", "prefix"})
                texts << widget->property(name).toString();
            if (const auto* box = qobject_cast<const QComboBox*>(widget))
                for (int i = 0; i < box->count(); ++i)
                    texts << box->itemText(i);
            if (const auto* tree = qobject_cast<const QTreeWidget*>(widget)) {
                for (int c = 0; c < tree->columnCount(); ++c)
                    texts << tree->headerItem()->text(c);
                for (QTreeWidgetItemIterator item(const_cast<QTreeWidget*>(tree)); *item != nullptr; ++item)
                    texts << (*item)->text(0);
            }
        }
        for (const QAction* action : m_window->findChildren<QAction*>())
            if (!action->objectName().startsWith("example-")) // names of files, as "Bend bar", are no words of ours
                texts << action->text() << action->toolTip();
        texts.removeDuplicates();
        texts.removeAll(QString());
        return texts;
    }

    QStringList leftInEnglish()
    {
        static const auto phrases = germanPhrases();
        QStringList left;
        for (const QString& text : shownTexts()) {
            const auto isGerman = [&](const auto& phrase) { return phrase.second.match(text).hasMatch(); };
            const auto isEnglish = [&](const auto& phrase) { return phrase.first.match(text).hasMatch(); };
            if (std::ranges::any_of(phrases, isEnglish) && std::ranges::none_of(phrases, isGerman))
                left << text;
        }
        return left;
    }

    QStringList textsLike(const QStringList& texts)
    {
        QStringList found;
        for (const QLabel* label : m_window->findChildren<QLabel*>())
            if (texts.contains(label->text()))
                found << label->text();
        for (const QWidget* widget : m_window->findChildren<QDockWidget*>())
            if (texts.contains(widget->windowTitle()))
                found << widget->windowTitle();
        return found;
    }
};

int main(int argc, char** argv)
{
    prepareGraphics();
    QApplication application(argc, argv);
    WindowShellTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "window_shell_test.moc"
