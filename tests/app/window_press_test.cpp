// What happens at once: a newly opened part is pressed by one click, a thumb goes into clay by two, and the tour goes by what is done.
// With real events.
#include "support/file_dialog_on_test.h"
#include "support/history_on_test.h"
#include "ui/dialogs/export_dialog.h"
#include "ui/help/tour.h"
#include "ui/interaction/hands.h"
#include "ui/panels/press_button.h"
#include "ui/run_window.h"

#include <QAction>
#include <QLabel>
#include <QMessageBox>
#include <QMouseEvent>
#include <QPushButton>
#include <QScrollArea>
#include <QTemporaryDir>
#include <QToolBar>
#include <QToolButton>

#include <algorithm>

using namespace knead;

class WindowPressTest : public QObject, HistoryOnTest {
    Q_OBJECT

    QToolButton& button() { return *m_window->findChild<QToolButton*>("pressButton"); }

    /// Of all objects, as a share of the size of the bodies.
    double largestShift()
    {
        double most = 0;
        for (const Snapshot::BodyState& body : snapshot().bodies)
            for (const Vec3& displacement : body.displacements())
                most = std::max(most, displacement.norm());
        return most / document().content().box.diagonal().norm();
    }

    ViewportWidget& view() { return m_window->viewport(); }
    Tour* tour() { return find<Tour>("tour"); }
    QString title() { return tour()->findChild<QLabel*>("tourTitle")->text(); }

    /// In the view.
    QPoint spot() { return view().mapFrom(m_window.get(), tour()->spot().center()); }

    /// By its button on the first page.
    void beginTour()
    {
        show(m_services);
        QTest::mouseClick(find<QPushButton>("homeTry"), Qt::LeftButton);
        waitForTasks();
        QVERIFY(comesTrue([this] { return tour() != nullptr && tour()->isVisible(); }));
        lookWhereItTurns();
        tour()->look();
    }

    /// What is pointed at can be clicked, and the part, too.
    void verifyNothingIsCovered()
    {
        drawn();
        tour()->look();
        const QRect card = tour()->geometry();
        QVERIFY(m_window->rect().contains(card));
        QVERIFY(!card.intersects(tour()->spot()));
        if (!tour()->spot().isEmpty()) {
            const QWidget* there = m_window->childAt(tour()->spot().center());
            QVERIFY(there != tour() && !tour()->isAncestorOf(there) && there->objectName() != "tourRing");
        }
        const Box box = view().materialBox();
        for (const Vec3& place : {box.min(), box.max(), Vec3(box.center())})
            QVERIFY(!card.contains(view().mapTo(m_window.get(), view().widgetPosition(place)->toPoint())));
    }

    /// Holds the button there until something is so.
    template <class Condition>
    void hold(const QPoint& place, const QPoint& way, const Condition& isSo)
    {
        QTest::mouseMove(&view(), place);
        QTest::mousePress(&view(), Qt::LeftButton, {}, place);
        for (int i = 1; i <= 10; ++i) {
            const QPointF at(place + way * i / 10); // sent, as the display may lose some of a quick row of moves
            QMouseEvent move(QEvent::MouseMove, at, view().mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
            QApplication::sendEvent(&view(), &move);
            QTest::qWait(15); // the pace of a hand
        }
        QVERIFY(comesTrue(isSo));
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, place + way);
    }

    void goesTo(int step)
    {
        QVERIFY2(comesTrue([&] { return tour() != nullptr && tour()->step() == step; }),
                 qPrintable(tour() != nullptr ? title() : QString("it has ended")));
    }

private slots:
    void initTestCase()
    {
        if (!hasDisplay())
            KNEAD_SKIP_WITHOUT("display", "The view needs a display: run this test under xvfb-run.");
        prepare();
    }

    void cleanup() { m_window.reset(); }

    void aClickPressesANewPart()
    {
        show(m_services);
        QVERIFY(!button().isVisible() && !action("pressIt")->isEnabled());
        openExample("bar.step", 16);
        settle();
        QTRY_VERIFY(button().isVisible());
        QVERIFY(action("pressIt")->isEnabled());
        const QRect area(button().mapTo(m_window.get(), QPoint()), button().size());
        QVERIFY(m_window->rect().contains(area));
        picture("press-it");
        const std::size_t entries = tree().records().size();
        QTest::mouseClick(&button(), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().playing, patience);
        QVERIFY(!button().isVisible());
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().time > 1, patience);
        key(Qt::Key_Space);
        settle();
        QCOMPARE(snapshot().tools.size(), std::size_t{1});
        QCOMPARE(snapshot().fixtures.size(), std::size_t{1});
        QVERIFY2(largestShift() > 0.03 && largestShift() < 0.3, qPrintable(QString::number(largestShift())));
        QVERIFY(!button().isVisible());
        picture("pressed");
        QVERIFY(tree().records().size() > entries);
        const auto entry = std::find_if(tree().records().begin(), tree().records().end(),
                                        [](const HistoryRecord& record) { return record.name == "Press it"; });
        QVERIFY(entry != tree().records().end());

        // Back at the start it is offered again.
        while (action("undo")->isEnabled()) {
            undo();
            settle();
        }
        QTRY_VERIFY(button().isVisible());
        QVERIFY(snapshot().tools.empty() && snapshot().fixtures.empty());
    }

    /// From the first page: one click opens clay, the second is held, and there is a dent.
    void twoClicksMakeADentInClay()
    {
        show(m_services);
        m_window->resize(1280, 800);
        rest();
        picture("home-try");
        const auto* begin = find<QPushButton>("homeTry");
        const auto* page = find<QScrollArea>("homePage");
        QVERIFY(begin->isVisible() && page->rect().contains(begin->mapTo(page, begin->rect().center())));
        for (const QPushButton* other : page->findChildren<QPushButton*>()) // nothing on the page stands out but this
            QCOMPARE(other->property("role").toString() == "primary", other == begin);
        QVERIFY(tour() == nullptr); // nothing lies over the page
        beginTour();
        QCOMPARE(document().content().model->parts.size(), std::size_t{1});
        QVERIFY(snapshot().materials.front().yields()); // rubber would spring back
        QVERIFY(action("sculptThumb")->isChecked());
        verifyNothingIsCovered();
        picture("tour-press");
        const QPoint place = spot();
        const double before = view().hitAt(place).place.z();
        hold(place, {}, [this] { return snapshot().time > 0.5; });
        QVERIFY(comesTrue([this] { return !snapshot().playing; }));
        settle();
        drawn();
        const double depth = before - view().hitAt(place).place.z(); // [m], of a block 24 mm high
        QVERIFY2(depth > 1e-3 && depth < 12e-3, qPrintable(QString::number(depth)));
        picture("tour-dent");
        QTest::mouseClick(find<QPushButton>("tourEnd"), Qt::LeftButton);
        QVERIFY(comesTrue([this] { return tour() == nullptr; }));
        QCOMPARE(m_window->hands().settings().choices().sculptStrength, 1.0); // as it was
    }

    /// Press, pull, export: each is noticed by itself.
    void theTourGoesByWhatIsDone()
    {
        beginTour();
        QCOMPARE(tour()->step(), 0);
        hold(spot(), {}, [this] { return snapshot().time > 0.3; });
        goesTo(1);

        // First it points at the brush, then at a corner.
        verifyNothingIsCovered();
        auto* bar = find<QToolBar>("sculptBar");
        auto* pull = bar->widgetForAction(action("pull"));
        QVERIFY(tour()->spot().contains(QRect(pull->mapTo(m_window.get(), QPoint()), pull->size())));
        picture("tour-pull");
        QVERIFY(comesTrue([this] { return !snapshot().playing; }));
        QTest::mouseClick(pull, Qt::LeftButton);
        QVERIFY(action("pull")->isChecked());
        verifyNothingIsCovered();
        picture("tour-corner");
        const double begin = snapshot().time;
        hold(spot(), QPoint(0, -60), [&] { return snapshot().time > begin + 0.3; });
        goesTo(2);
        QVERIFY(comesTrue([this] { return !snapshot().playing; }));
        settle();

        verifyNothingIsCovered();
        picture("tour-export");
        const QTemporaryDir folder;
        const QString file = folder.filePath("clay.step");
        new FileDialogAnswer(file, this);
        key(Qt::Key_E, Qt::ControlModifier);
        QVERIFY(comesTrue([this] { return find<ExportDialog>("exportDialog") != nullptr; }));
        QTest::keyClick(find<ExportDialog>("exportDialog"), Qt::Key_Return);
        QVERIFY(comesTrue([&] { return QFile::exists(file); }));
        goesTo(3);
        waitForTasks();
        QCOMPARE(problem(), QString());
        picture("tour-end");

        // The keyboard reaches the card from the view; there Esc ends it.
        m_window->activateWindow(); // there may be no window manager that does it
        QVERIFY(QTest::qWaitForWindowActive(m_window.get(), patience));
        view().setFocus();
        QTest::keyClick(&view(), Qt::Key_Tab);
        QVERIFY(tour()->isAncestorOf(QApplication::focusWidget()));
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
        QVERIFY(comesTrue([this] { return tour() == nullptr; }));
        QVERIFY(view().hasFocus() && !document().isEmpty());
    }

    /// What counts is that the clay is pressed, not the way.
    void theTourTakesKeysForTheDeed()
    {
        beginTour();
        key(Qt::Key_Escape); // the thumb is not wanted
        QVERIFY(!action("sculptThumb")->isChecked());
        key(Qt::Key_B);
        QVERIFY(comesTrue([this] { return snapshot().tools.size() == 1; }));
        key(Qt::Key_Space);
        view().setFocus();
        QTest::keyPress(&view(), Qt::Key_PageDown);
        goesTo(1);
        QTest::keyRelease(&view(), Qt::Key_PageDown);
        key(Qt::Key_Space);
        settle();
    }

    void theTourGoesBackAndSkipsByKeys()
    {
        beginTour();
        view().setFocus();
        const auto press = [this](const char* name) {
            for (int i = 0; i < 4 && QApplication::focusWidget()->objectName() != name; ++i)
                QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
            QCOMPARE(QApplication::focusWidget()->objectName(), QString(name));
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
        };
        press("tourSkip");
        QCOMPARE(tour()->step(), 1);
        picture("tour-focus");
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Backtab);
        QCOMPARE(QApplication::focusWidget()->objectName(), QString("tourBack"));
        press("tourBack");
        QCOMPARE(tour()->step(), 0);
        QVERIFY(tour()->isAncestorOf(QApplication::focusWidget()));
        press("tourSkip");
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return); // as well as Space
        QCOMPARE(tour()->step(), 2);
        QVERIFY(!document().isPlaying());
        Preferences german = readPreferences();
        german.language = "de";
        m_window->features().preferences->set(german);
        QCOMPARE(find<QPushButton>("tourBack")->text(), QString("Zurück"));
        german.language = "en";
        m_window->features().preferences->set(german);
        QCOMPARE(title(), QString("Export"));
        press("tourEnd");
        QVERIFY(comesTrue([this] { return tour() == nullptr; }));
    }

    /// As everything that opens another part; and it ends when that is another one.
    void theTourAsksBeforeWorkIsLost()
    {
        openBar();
        document().addTool(ToolKind::ball);
        settle();
        action("tour")->trigger();
        QVERIFY(comesTrue([this] { return find<QMessageBox>("saveQuestion") != nullptr; }));
        QTest::keyClick(find<QMessageBox>("saveQuestion"), Qt::Key_Escape);
        QTest::qWait(50);
        QVERIFY(tour() == nullptr && !m_window->tasks().isRunning());
        QCOMPARE(snapshot().tools.size(), std::size_t{1});
        action("tour")->trigger();
        QVERIFY(comesTrue([this] { return find<QMessageBox>("saveQuestion") != nullptr; }));
        QTest::mouseClick(find<QMessageBox>("saveQuestion")->button(QMessageBox::Discard), Qt::LeftButton);
        QVERIFY(comesTrue([this] { return tour() != nullptr; }));
        openExample("plate.step", 12);
        QVERIFY(comesTrue([this] { return tour() == nullptr; }));
    }

    /// Whoever has begun to work on the part is not in need of it.
    void itIsGoneWhenAPersonBegins()
    {
        show(m_services);
        openExample("bracket.step", 12);
        settle();
        QTRY_VERIFY(button().isVisible());
        document().addTool(ToolKind::ball);
        settle();
        QTRY_VERIFY(!button().isVisible());
        QVERIFY(!action("pressIt")->isEnabled());
        undo();
        settle();
        QTRY_VERIFY(button().isVisible());
    }
};

int main(int argc, char** argv)
{
    prepareGraphics();
    QApplication application(argc, argv);
    WindowPressTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "window_press_test.moc"
