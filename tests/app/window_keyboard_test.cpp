#include "support/window_on_test.h"
#include "ui/commands/command_palette.h"
#include "ui/commands/listed_actions.h"
#include "ui/commands/shortcuts.h"
#include "ui/run_window.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QToolBar>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

using namespace knead;

/// What the keyboard reaches: entries of choices, and everything that panels offer.
class WindowKeyboardTest : public QObject, WindowOnTest {
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
        QSettings().clear();
        QSettings().setValue("language", "en");
        show(m_services);
    }

    void cleanup() { m_window.reset(); }

    /// Most letters are keys of the window: G is gravity, R nothing, H hides the body.
    void lettersChooseFromAListThatHasTheKeyboard()
    {
        openExample("bar.step", 10);
        document().select({Selection::Kind::Body, 0});
        auto* kind = find<QComboBox>("bodyKind");
        raise("propertiesDock");
        kind->setFocus(Qt::TabFocusReason);
        QVERIFY(kind->hasFocus());
        QTest::keyClick(kind, Qt::Key_G); // "Glue"
        QCOMPARE(kind->currentText(), QString("Glue"));
        QTRY_VERIFY(snapshot().bodies[0].kind == BodyKind::glue);
        QVERIFY(!action("gravity")->isChecked() && snapshot().gravity.isZero());
        QTest::qWait(QApplication::keyboardInputInterval() + 100);
        QTest::keyClick(kind, Qt::Key_R);
        QCOMPARE(kind->currentText(), QString("Rigid"));
        QTest::qWait(QApplication::keyboardInputInterval() + 100);
        QTest::keyClick(kind, Qt::Key_D);
        QCOMPARE(kind->currentText(), QString("Deformable"));
        // Other keys stay those of the window.
        QTest::keyClick(kind, Qt::Key_K, Qt::ControlModifier);
        QTRY_VERIFY(find<CommandPalette>("commandPalette")->isVisible());
        QTest::keyClick(find<QLineEdit>("paletteField"), Qt::Key_Escape);
        QTest::keyClick(kind, Qt::Key_Space);
        QTRY_VERIFY(snapshot().playing);
        QTest::keyClick(kind, Qt::Key_Space);
        QTRY_VERIFY(!snapshot().playing);
        // Who chose with the mouse goes on working in the view: a letter must not change what was chosen.
        clickAndClose(kind);
        QVERIFY(kind->hasFocus());
        QTest::keyClick(kind, Qt::Key_G);
        QTRY_VERIFY(action("gravity")->isChecked());
        QCOMPARE(kind->currentText(), QString("Deformable"));
    }

    /// One after the other, as Tab goes; each stop is to be seen.
    void tabLeadsToTheToolBarAndNowhereThatShowsNothing()
    {
        openExample("bar.step", 10);
        m_window->viewport().setFocus();
        QSet<const QWidget*> stops;
        for (int i = 0; i < 400; ++i) {
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
            const QWidget* stop = QApplication::focusWidget();
            QVERIFY(stop != nullptr);
            QVERIFY2(stop->metaObject()->className() != QByteArray("QScrollArea"), qPrintable(stop->objectName()));
            if (stops.contains(stop))
                break;
            stops << stop;
        }
        auto* bar = find<QToolBar>("toolBar");
        for (QAction* of : {action("gravity"), action("play")})
            QVERIFY2(stops.contains(bar->widgetForAction(of)), qPrintable(of->objectName()));
        QWidget* gravity = bar->widgetForAction(action("gravity"));
        gravity->setFocus(Qt::TabFocusReason);
        QTest::keyClick(gravity, Qt::Key_Return);
        QTRY_VERIFY(action("gravity")->isChecked() && !snapshot().gravity.isZero());
        QVERIFY(gravity->hasFocus());
        QTest::keyClick(gravity, Qt::Key_Space); // the simulation's, as everywhere
        QTRY_VERIFY(snapshot().playing);
        QTest::keyClick(gravity, Qt::Key_Space);
        QTRY_VERIFY(!snapshot().playing);
    }

    void whereTheKeyboardIsIsSeen()
    {
        QWidget page;
        auto* column = new QVBoxLayout(&page);
        auto* first = new QPushButton("First", &page);
        const std::vector<QWidget*> widgets = {new QPushButton("Button", &page), new QToolButton(&page),
                                               new QTreeWidget(&page),           new QListWidget(&page),
                                               new QPlainTextEdit(&page),        new QLineEdit(&page)};
        column->addWidget(first);
        for (QWidget* widget : widgets) {
            widget->setFocusPolicy(Qt::StrongFocus);
            column->addWidget(widget);
        }
        page.show();
        QVERIFY(QTest::qWaitForWindowExposed(&page, patience));
        page.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&page, patience));
        for (QWidget* widget : widgets) {
            first->setFocus(Qt::TabFocusReason);
            QTest::qWait(50);
            const QImage without = widget->grab().toImage();
            widget->setFocus(Qt::TabFocusReason);
            QTest::qWait(50);
            QVERIFY2(widget->grab().toImage() != without, widget->metaObject()->className());
        }
    }

    void noListInThePanelsLetsALetterThrough()
    {
        openExample("bar.step", 10);
        int count = 0;
        for (QComboBox* choice : m_window->findChildren<QComboBox*>()) {
            QFocusEvent reached(QEvent::FocusIn, Qt::TabFocusReason);
            QApplication::sendEvent(choice, &reached);
            for (const Qt::Key letter : {Qt::Key_G, Qt::Key_B, Qt::Key_7, Qt::Key_H, Qt::Key_X}) {
                QKeyEvent asked(QEvent::ShortcutOverride, letter, Qt::NoModifier, QChar(letter).toLower());
                asked.ignore();
                QApplication::sendEvent(choice, &asked);
                QVERIFY2(asked.isAccepted(), qPrintable(choice->objectName()));
            }
            ++count;
        }
        QVERIFY(count >= 12);
    }

    /// Boxes and lists of panels that switch something, and the actions that do the same.
    void whatPanelsSwitchIsInMenusAndThePaletteAndTakesAKey()
    {
        openExample("bar.step", 10);
        const QHash<QString, QString> actionOfBox = {
            {"automaticRange", "automaticRange"}, {"sectionHatched", "sectionHatched"}, {"gizmoOwnAxes", "ownAxes"}};
        int boxes = 0;
        for (const QCheckBox* box : ofPanels<QCheckBox>()) {
            if (box->objectName() == "toolRolls") // of the selected tool, as the numbers below
                continue;
            QString name = actionOfBox.value(box->objectName());
            if (name.isEmpty() && box->objectName().endsWith("Box"))
                name = box->objectName().chopped(3);
            QVERIFY2(isOffered(action(qPrintable(name))), qPrintable(box->objectName()));
            ++boxes;
        }
        QVERIFY(boxes >= 13);
        const QHash<QString, QStringList> actionsOfChoice = {
            {"colorQuantity", {"colorParts", "color-strain", "color-vonMisesStress"}},
            {"shading", {"shadingUsual", "shadingZebra"}},
            {"colorMap", {"colorMapViridis", "colorMapCividis", "colorMapGray"}},
            {"sectionAxis", {"sectionX", "sectionY", "sectionZ", "sectionEye"}},
            {"simulationSpeed", {"simulationSpeed-0", "simulationSpeed-8"}},
            {"gravityPreset", {"gravityPreset-0", "gravityPreset-4"}},
            {"tableKind", {"tableKind-0", "tableKind-3"}},
            {"integrator", {"integrator-0", "integrator-3"}},
            {"filmRate", {"filmRate-0", "filmRate-6"}},
            {"spaceMouseDrives", {"spaceMouseTool"}},
            {"threads", {"preferences"}},
        };
        // What belongs to one thing that is selected, or only to what a plot shows, stays where it is.
        const QStringList numbers = {"bodyKind",  "materialPreset", "regionPreset", "toolKind",
                                     "takenUnit", "forceComponent", "probeQuantity"};
        for (const QComboBox* choice : ofPanels<QComboBox>()) {
            const QString name = choice->objectName();
            QVERIFY2(actionsOfChoice.contains(name) != numbers.contains(name), qPrintable(name));
            for (const QString& one : actionsOfChoice.value(name))
                QVERIFY2(isOffered(action(qPrintable(one))), qPrintable(one));
        }
        for (const char* film : {"filmStart", "filmBack", "filmPlay", "filmOn", "filmEnd", "filmBranch", "filmReturn"})
            QVERIFY2(isOffered(action(film)), film);
    }

    void thePaletteChoosesColorsAndCuts()
    {
        openExample("bar.step", 10);
        ViewportWidget& view = m_window->viewport();
        command("strain");
        QVERIFY(view.options().colors.quantity == SurfaceQuantity::strain);
        QCOMPARE(find<QComboBox>("colorQuantity")->currentText(), QString("Strain"));
        command("map gray");
        QVERIFY(view.options().colors.map == ColorMap::gray);
        QCOMPARE(find<QComboBox>("colorMap")->currentText(), QString("Gray"));
        command("section across y");
        QVERIFY(view.options().section.plane.has_value());
        QCOMPARE(view.options().section.plane->normal, Vec3(Vec3::UnitY()));
        QCOMPARE(find<QComboBox>("sectionAxis")->currentText(), QString("Y"));
        QVERIFY(action("sectionY")->isChecked() && action("section")->isChecked());
        command("hatched");
        QVERIFY(!view.options().section.isHatched && !find<QCheckBox>("sectionHatched")->isChecked());
        command("moon");
        QTRY_COMPARE(snapshot().gravity.z(), -1.62);
        QCOMPARE(find<QComboBox>("gravityPreset")->currentText(), QString("Moon"));
        command("implicit euler");
        QTRY_VERIFY(find<QComboBox>("integrator")->currentText().contains("mplicit Euler"));
    }

    void aKeyForASectionIsKept()
    {
        openExample("bar.step", 10);
        Shortcuts& shortcuts = *m_window->findChild<Shortcuts*>();
        QVERIFY(shortcuts.knows(action("sectionZ")));
        shortcuts.set(action("sectionZ"), {QKeySequence("Ctrl+Alt+Z")});
        QTest::keyClick(m_window.get(), Qt::Key_Z, Qt::ControlModifier | Qt::AltModifier);
        QVERIFY(m_window->viewport().options().section.plane.has_value());
        QCOMPARE(m_window->viewport().options().section.plane->normal, Vec3(Vec3::UnitZ()));
        m_window.reset();
        show(m_services);
        QCOMPARE(action("sectionZ")->shortcut(), QKeySequence("Ctrl+Alt+Z"));
    }

private:
    /// But those that describe a deformation before it is applied: they switch nothing of the window.
    template <class Widget>
    QList<Widget*> ofPanels()
    {
        QList<Widget*> all;
        for (const QDockWidget* dock : m_window->findChildren<QDockWidget*>())
            if (dock->objectName() != "deformDock")
                all += dock->findChildren<Widget*>();
        return all;
    }

    bool isOffered(QAction* action)
    {
        if (action == nullptr || action->objectName().isEmpty())
            return false;
        const Shortcuts& shortcuts = *m_window->findChild<Shortcuts*>();
        for (const ListedAction& one : listedActions(*m_window))
            if (one.action == action)
                return !one.menu.isEmpty() && shortcuts.knows(action);
        return false;
    }

    void raise(const char* dock)
    {
        find<QDockWidget>(dock)->show();
        find<QDockWidget>(dock)->raise();
        drawn();
    }

    /// A click opens the list, Esc closes it: the keyboard stays.
    void clickAndClose(QComboBox* choice)
    {
        QTest::mouseClick(choice, Qt::LeftButton);
        [[maybe_unused]] const bool isOpen =
            QTest::qWaitFor([] { return QApplication::activePopupWidget() != nullptr; }, 200);
        if (QWidget* list = QApplication::activePopupWidget())
            QTest::keyClick(list, Qt::Key_Escape);
        QTRY_VERIFY(QApplication::activePopupWidget() == nullptr);
        drawn();
    }

    /// By the palette, as a person types it.
    void command(const char* letters)
    {
        QTest::keyClick(m_window.get(), Qt::Key_K, Qt::ControlModifier);
        auto* field = find<QLineEdit>("paletteField");
        QTRY_VERIFY(field->hasFocus());
        QTest::keyClicks(field, letters);
        QTest::keyClick(field, Qt::Key_Return);
        drawn();
    }
};

int main(int argc, char** argv)
{
    prepareGraphics();
    QApplication application(argc, argv);
    WindowKeyboardTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "window_keyboard_test.moc"
