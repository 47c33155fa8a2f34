// File > Close.
#include "support/story_on_test.h"
#include "ui/frame/docks.h"
#include "ui/measuring/measuring.h"
#include "ui/panels/timeline_axis.h"
#include "ui/run_window.h"

#include <QDockWidget>
#include <QMessageBox>
#include <QTreeWidget>

using namespace knead;

class WindowCloseTest : public QObject, StoryOnTest {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        if (!hasDisplay())
            KNEAD_SKIP_WITHOUT("display", "The view needs a display: run this test under xvfb-run.");
        prepareStories();
    }

    void cleanup() { m_window.reset(); }

    /// What was done is asked about; then all is as before the first part was opened, and the next one opens as usual.
    void aPartIsClosed()
    {
        beginStory("close");
        QVERIFY(!action("closePart")->isEnabled());
        openByHand(example("bar.step"));
        key(Qt::Key_W, Qt::ControlModifier); // nothing was done
        QTRY_VERIFY(document().isEmpty());
        verifyFirstPage();
        stage("closed");
        openByHand(example("lump.step"));
        key(Qt::Key_B);
        QTRY_COMPARE(snapshot().tools.size(), std::size_t{1});
        play();
        hold(Qt::Key_PageDown, [&, end = snapshot().time + 0.1] { return snapshot().time > end; });
        key(Qt::Key_W, Qt::ControlModifier); // while time runs
        answerAndComeBack(QMessageBox::Cancel);
        QVERIFY(!document().isEmpty());
        stage("kept");
        key(Qt::Key_W, Qt::ControlModifier);
        answerAndComeBack(QMessageBox::Discard);
        QTRY_VERIFY(document().isEmpty());
        verifyFirstPage();
        stage("discarded");
        openByHand(example("bar.step"));
        QVERIFY(snapshot().tools.empty() && !snapshot().playing);
        QCOMPARE(document().history().tree().records().size(), std::size_t{1});
        key(Qt::Key_B);
        QTRY_COMPARE(snapshot().tools.size(), std::size_t{1});
        key(Qt::Key_W, Qt::ControlModifier);
        answerFileDialog(file("bar.knead"));
        QTRY_VERIFY(find<QMessageBox>("saveQuestion") != nullptr);
        QTest::keyClick(find<QMessageBox>("saveQuestion"), Qt::Key_Return); // save, and close then
        QTRY_VERIFY_WITH_TIMEOUT(document().isEmpty(), patience);
        verifyFirstPage();
        QVERIFY(QFile::exists(file("bar.knead")));
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        openByHand(file("bar.knead"));
        QCOMPARE(snapshot().tools.size(), std::size_t{1});
        QVERIFY(!projects().isModified());
        endStory();
    }

    /// Whatever looks at a part has nothing to look at any more, and goes on with the next one.
    void whoLooksAtAPartLetsGoOfIt()
    {
        beginStory("looks");
        openByHand(example("bar.step"));
        for (const char* dock : {"historyDock", "simulationDock", "forcesDock", "performanceDock"})
            if (auto* panel = find<QDockWidget>(dock)) {
                panel->show();
                panel->raise();
            }
        key(Qt::Key_B);
        QTRY_COMPARE(snapshot().tools.size(), std::size_t{1});
        play();
        hold(Qt::Key_PageDown, [&, end = snapshot().time + 0.05] { return snapshot().time > end; });
        pause();
        key(Qt::Key_Escape);
        key(Qt::Key_M);
        click(placeOf(vertexAt(at(0, 0, 20))));
        click(placeOf(vertexAt(at(160, 0, 20))));
        key(Qt::Key_Escape);
        QTRY_COMPARE(find<QTreeWidget>("measurements")->topLevelItemCount(), 1);
        command("strain");
        key(Qt::Key_S, Qt::ShiftModifier);
        command("four views");
        stage("looking");
        auto* axis = find<TimelineAxis>("timelineAxis");
        const double place = 0.5 * axis->timeline().present;
        QTest::mousePress(axis, Qt::LeftButton, {}, axis->placeOf(place));
        QTest::mouseRelease(axis, Qt::LeftButton, {}, axis->placeOf(place));
        QTRY_VERIFY(view().isLookingBack());
        key(Qt::Key_W, Qt::ControlModifier);
        answerAndComeBack(QMessageBox::Discard);
        QTRY_VERIFY(document().isEmpty());
        verifyFirstPage();
        QTest::qWait(1000); // timers of panels look once more
        stage("closed");
        QCOMPARE(find<QTreeWidget>("measurements")->topLevelItemCount(), 0);
        QVERIFY(find<TimelineAxis>("timelineAxis")->timeline().pictures.empty());
        openByHand(example("lump.step"));
        QVERIFY(!view().isLookingBack() && !view().options().section.plane && !view().options().colors.quantity);
        stage("another");
        command("one view");
    }

private:
    /// Keys that follow are for the window.
    void answerAndComeBack(QMessageBox::StandardButton button)
    {
        answer("saveQuestion", button);
        QVERIFY(QTest::qWaitForWindowActive(m_window.get(), patience));
    }

    /// Nothing is open.
    void verifyFirstPage()
    {
        QVERIFY(find<QWidget>("homePage")->isVisible());
        QVERIFY(!view().isVisible());
        QCOMPARE(m_window->windowTitle(), QString("Knead"));
        QVERIFY(!m_window->isWindowModified());
        QCOMPARE(find<QTreeWidget>("modelTree")->topLevelItemCount(), 0);
        QTRY_COMPARE(find<QTreeWidget>("historyTree")->topLevelItemCount(), 0);
        for (const char* name : {"save", "play", "undo", "firstPage", "closePart", "addPart", "export"})
            QVERIFY2(!action(name)->isEnabled(), name);
        QVERIFY(action("open")->isEnabled());
        QVERIFY(!m_window->tasks().isRunning());
    }
};

int main(int argc, char** argv)
{
    prepareGraphics();
    WatchedApplication application(argc, argv);
    WindowCloseTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "window_close_test.moc"
