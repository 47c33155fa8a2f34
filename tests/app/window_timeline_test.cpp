#include "support/history_on_test.h"
#include "ui/document/entry_names.h"
#include "ui/panels/timeline_axis.h"
#include "ui/panels/timeline_panel.h"
#include "ui/project/project_keeper.h"
#include "ui/run_window.h"

#include <QComboBox>
#include <QDockWidget>
#include <QHelpEvent>
#include <QLabel>
#include <QToolButton>
#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace knead;

/// Looking back along the timeline, and branching from there, whatever else goes on.
class WindowTimelineTest : public QObject, HistoryOnTest {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        if (!hasDisplay())
            KNEAD_SKIP_WITHOUT("display", "The view needs a display: run this test under xvfb-run.");
        prepare();
    }

    void init() { openBar(); }
    void cleanup() { m_window.reset(); }

    void theTimelineLooksBackAndBranches()
    {
        addBlock();
        key(Qt::Key_G);
        simulate(0.4);
        document().history().setKey(tree().current(), true);
        key(Qt::Key_G);
        simulate(0.4);
        const std::uint64_t end = digest();
        const Entry last = tree().current();
        auto* panel = find<TimelinePanel>("timelinePanel");
        auto* axis = find<TimelineAxis>("timelineAxis");
        auto* caption = find<QLabel>("pastCaption");
        QTRY_COMPARE(axis->timeline().ticks.back().entry, last);
        const Timeline line = axis->timeline();
        QVERIFY(line.pictures.size() > 10);
        QCOMPARE(line.end, present().time);
        QCOMPARE(line.present, line.end);

        // A drag looks back; nothing changes but the view.
        const Timeline::Picture& middle = line.pictures[line.pictures.size() / 3];
        const auto dragTo = [&](double at) {
            QTest::mousePress(axis, Qt::LeftButton, {}, axis->placeOf(line.present));
            QTest::mouseMove(axis, axis->placeOf(0.6 * line.end));
            QTest::mouseMove(axis, axis->placeOf(at));
        };
        dragTo(middle.at + 0.4 * PlaybackCache::interval);
        QVERIFY(panel->isLookingBack());
        QTRY_VERIFY(caption->isVisible());
        QVERIFY(caption->text().startsWith("Looking back at "));
        QTest::mouseRelease(axis, Qt::LeftButton, {}, axis->placeOf(middle.at + 0.4 * PlaybackCache::interval));
        QVERIFY(panel->isLookingBack());
        QCOMPARE(digest(), end);
        QCOMPARE(tree().current(), last);
        pictures("timeline");

        // The film plays to its end, at any rate.
        find<QComboBox>("filmRate")->setCurrentText("8x");
        QTest::mouseClick(find<QToolButton>("filmPlay"), Qt::LeftButton);
        QTRY_COMPARE(find<QLabel>("filmState")->text(), timeText(line.end) + " / " + timeText(line.end));
        QTest::mouseClick(find<QToolButton>("filmBack"), Qt::LeftButton);
        QVERIFY(panel->isLookingBack());
        QTest::mouseClick(find<QToolButton>("filmReturn"), Qt::LeftButton);
        QVERIFY(!panel->isLookingBack() && !caption->isVisible());

        // What one sees is where a branch begins.
        dragTo(middle.at + 0.4 * PlaybackCache::interval);
        QTest::mouseRelease(axis, Qt::LeftButton, {}, axis->placeOf(middle.at + 0.4 * PlaybackCache::interval));
        QTest::mouseClick(find<QToolButton>("filmBranch"), Qt::LeftButton);
        settle();
        QVERIFY(presentName().startsWith("Branch at "));
        QVERIFY(tree().current() != last && !panel->isLookingBack());
        QCOMPARE(present().step, middle.frame->step);
        QCOMPARE(present().time, middle.frame->time);
        for (std::size_t i = 0; i < snapshot().bodies[0].positions.size(); ++i)
            for (Eigen::Index axisIndex = 0; axisIndex < 3; ++axisIndex)
                QCOMPARE(static_cast<float>(snapshot().bodies[0].positions[i][axisIndex]),
                         middle.frame->objects[0][3 * i + static_cast<std::size_t>(axisIndex)]);
        QTRY_COMPARE(axis->timeline().end, middle.at);
        QCOMPARE(axis->timeline().pictures.back().frame, middle.frame);
        const std::uint64_t branch = digest();
        simulate(0.1);
        settle();
        undo();
        QCOMPARE(digest(), branch);

        // A double click on the tick of an entry goes there.
        document().goToEntry(last);
        QCOMPARE(digest(), end);
        QTRY_COMPARE(axis->timeline().end, line.end);
        const Timeline::Tick key =
            *std::find_if(line.ticks.begin(), line.ticks.end(), [](const Timeline::Tick& tick) { return tick.isKey; });
        dragTo(key.at);
        QTest::mouseRelease(axis, Qt::LeftButton, {}, axis->placeOf(key.at));
        settle();
        QCOMPARE(tree().current(), last); // to look at it is not to go there
        QVERIFY(panel->isLookingBack());
        QTest::mouseDClick(axis, Qt::LeftButton, {}, axis->placeOf(key.at));
        settle();
        QVERIFY(tree().current() != last && present().time == tree().record(key.entry).time);
        QVERIFY(!panel->isLookingBack());
        dragTo(middle.at + 0.4 * PlaybackCache::interval);
        QTest::keyClick(m_window.get(), Qt::Key_Space); // time goes on from the present
        QTRY_VERIFY(snapshot().playing);
        QVERIFY(!panel->isLookingBack());
        QTest::mouseRelease(axis, Qt::LeftButton, {}, axis->placeOf(middle.at));
    }

    /// Or a press would land beside the mouse, and the end of the axis would lie under buttons.
    void pressingDoesNotMoveTheAxis()
    {
        const Timeline line = filmed();
        const QRect before = axis().geometry();
        for (const double share : {0.3, 0.6, 0.9}) {
            const int x = static_cast<int>(share * axis().width());
            QTest::mouseMove(&axis(), QPoint(x, axis().height() / 2));
            QTest::mousePress(&axis(), Qt::LeftButton, {}, QPoint(x, axis().height() / 2));
            QTest::qWait(100); // panels are laid out later
            QVERIFY(panel().isLookingBack());
            QVERIFY(find<QToolButton>("filmBranch")->isVisible());
            QCOMPARE(axis().geometry(), before);
            QTest::mouseRelease(&axis(), Qt::LeftButton, {}, QPoint(x, axis().height() / 2));
            QTest::qWait(100);
            QCOMPARE(axis().geometry(), before);
            const double at = axis().lookedAt().value_or(-1);
            QVERIFY(std::abs(axis().placeOf(at).x() - x) <= 6); // a tick attracts
        }
        for (const int x : {1, axis().width() - 2}) // to the rim of the axis
            QCOMPARE(m_window->childAt(axis().mapTo(m_window.get(), QPoint(x, axis().height() / 2))), &axis());
        QTest::mouseClick(find<QToolButton>("filmReturn"), Qt::LeftButton);
        QTest::qWait(100);
        QCOMPARE(axis().geometry(), before);
    }

    void branchingLosesNothingThatIsUnderWay()
    {
        const Timeline line = filmed();
        const Entry last = tree().current();
        const Timeline::Picture& middle = line.pictures[line.pictures.size() / 2];
        const double place = middle.at + 0.4 * PlaybackCache::interval;
        press(line.present);
        moveTo(place);
        QTest::mouseRelease(&axis(), Qt::LeftButton, {}, axis().placeOf(place));
        key(Qt::Key_Period); // others may follow, so it is no entry yet
        QVERIFY(document().isUnderWay() && panel().isLookingBack());
        QTest::mouseClick(find<QToolButton>("filmBranch"), Qt::LeftButton);
        settle();
        QVERIFY(presentName().startsWith("Branch at "));
        QCOMPARE(present().step, middle.frame->step);
        QCOMPARE(tree().current(), last + 2);
        QCOMPARE(tree().record(last + 1).parent, last);
        QCOMPARE(tree().record(last + 1).step, tree().record(last).step + 1);
        QCOMPARE(present().parent, tree().record(last).parent);
        verifyStraightRun();
    }

    /// The film on the axis is then still that of a run under way.
    void whatWasJustSeenIsBranchedAt()
    {
        addBlock();
        key(Qt::Key_G);
        const double end = snapshot().time + 0.4;
        key(Qt::Key_Space);
        const auto isFilmed = [&] { // as far as the axis knows
            const auto& pictures = axis().timeline().pictures;
            return pictures.size() > 4 && pictures.back().isUnderWay;
        };
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().time >= end && isFilmed(), patience);
        key(Qt::Key_Space);
        for (int i = 0; i < 3; ++i)
            QTest::mouseClick(find<QToolButton>("filmBack"), Qt::LeftButton);
        QVERIFY(panel().isLookingBack());
        const Timeline line = axis().timeline();
        QVERIFY(isFilmed());
        QTest::mouseClick(find<QToolButton>("filmBranch"), Qt::LeftButton);
        settle();
        QVERIFY2(presentName().startsWith("Branch at "), qPrintable(presentName()));
        QCOMPARE(present().step, line.pictures[line.pictures.size() - 4].frame->step);
        verifyStraightRun();
    }

    void theWindowDoesNotWaitForWhatIsLookedAt()
    {
        const Timeline line = filmed();
        QStringList seen;
        connect(&panel(), &TimelinePanel::looked, this, [&seen](const FramePointer& frame, const QString& text) {
            if (frame)
                seen << text;
        });
        press(line.present);
        for (const std::size_t share : {5, 4, 3, 2})
            moveTo(line.pictures[line.pictures.size() / share].at);
        QVERIFY(seen.empty());
        const QString last = "Looking back at " + find<QLabel>("filmState")->text().section(" / ", 0, 0);
        QTRY_VERIFY(!seen.empty() && seen.last().startsWith(last));
        QVERIFY(seen.size() <= 2); // what was passed before it could be drawn, was not
        QTest::mouseRelease(&axis(), Qt::LeftButton, {}, axis().placeOf(line.present));
        settle();
        QVERIFY(!panel().isLookingBack() && !find<QLabel>("pastCaption")->isVisible());
        seen.clear();
        press(line.present);
        moveTo(line.pictures[1].at);
        panel().stopLooking(); // before it was drawn
        QTest::qWait(200);
        QVERIFY(seen.empty() && !find<QLabel>("pastCaption")->isVisible());
    }

    /// By menu and keys.
    void theFilmIsThereWithoutItsPanel()
    {
        find<QDockWidget>("timelineDock")->toggleViewAction()->trigger();
        QVERIFY(!panel().isVisible());
        addBlock();
        auto* toEnd = action("filmEnd");
        QVERIFY(!toEnd->isEnabled() && !find<QComboBox>("filmRate")->isEnabled());
        QCOMPARE(action("filmRate-0")->statusTip(), QString("Simulate something first, and look back at it."));
        for (const double time : {0.3, 0.3}) { // of the second run the film is longer
            simulate(time);
            settle();
            QTRY_VERIFY(toEnd->isEnabled() && find<QComboBox>("filmRate")->isEnabled());
            QVERIFY(action("filmRate-0")->isEnabled() && action("filmRate-0")->statusTip().isEmpty());
            QTRY_COMPARE(axis().timeline().end, snapshot().time);
            const QString end = timeText(snapshot().time);
            toEnd->trigger();
            QVERIFY(panel().isLookingBack());
            QTRY_COMPARE(find<QLabel>("filmState")->text(), end + " / " + end);
            QTest::keyClick(m_window.get(), Qt::Key_Escape);
            QVERIFY(!panel().isLookingBack());
        }
    }

    void anotherPartTakesTheTimelineAway()
    {
        const Timeline line = filmed();
        const QPoint inBetween = axis().placeOf(0.4 * line.end);
        press(line.present);
        moveTo(0.7 * line.end);
        QVERIFY(panel().isLookingBack());
        m_window->projects().open(
            prepareFiles(m_services.import, {.paths = {example("plate.step").toStdString()}}, {}, TaskControl::none()));
        const auto drag = [&] {
            QHelpEvent help(QEvent::ToolTip, inBetween, axis().mapToGlobal(inBetween));
            QApplication::sendEvent(&axis(), &help);
            QTest::mouseMove(&axis(), inBetween + QPoint(30, 0));
            QTest::mouseMove(&axis(), inBetween);
        };
        drag();
        QVERIFY(!panel().isLookingBack() && axis().timeline().pictures.empty());
        document().branchAt(line.pictures.back().entry, line.pictures.back().frame->step); // there is no such entry
        QVERIFY(!document().isGoing());
        settle();
        drag();
        QTest::mouseRelease(&axis(), Qt::LeftButton, {}, inBetween);
        QVERIFY(document().content().bodies[0]->name != "Bar");
    }

    void anotherFillingHasATimelineOfItsOwn()
    {
        const Timeline line = filmed();
        const QPoint inBetween = axis().placeOf(0.4 * line.end);
        const auto dragUntilSettled = [&] {
            while (!document().isSettled()) {
                QTest::mouseMove(&axis(), inBetween + QPoint(30, 0));
                QTest::mouseMove(&axis(), inBetween);
                QTest::qWait(5);
                QVERIFY(document().isGoing() || axis().timeline().pictures.empty());
            }
        };
        press(line.present);
        moveTo(0.7 * line.end);
        document().refill(
            prepareRefill(document().content(), 2 * document().content().spacing, snapshot(), {}, TaskControl::none()));
        QVERIFY(axis().timeline().pictures.empty());
        dragUntilSettled();
        undo();
        settle();
        QTRY_COMPARE(axis().timeline().pictures.size(), line.pictures.size());
        moveTo(0.7 * line.end);
        QVERIFY(panel().isLookingBack());
        redo();
        dragUntilSettled();
        QVERIFY(!find<QLabel>("pastCaption")->isVisible()); // nothing was filmed here
        QTest::mouseRelease(&axis(), Qt::LeftButton, {}, inBetween);
    }

private:
    TimelinePanel& panel() { return *find<TimelinePanel>("timelinePanel"); }
    TimelineAxis& axis() { return *find<TimelineAxis>("timelineAxis"); }
    void press(double at) { QTest::mousePress(&axis(), Qt::LeftButton, {}, axis().placeOf(at)); }
    void moveTo(double at) { QTest::mouseMove(&axis(), axis().placeOf(at)); }

    /// Something falls, and is on the axis.
    Timeline filmed()
    {
        document().post(SetGravity{Vec3(0, 0, -9.81)});
        simulate(0.4);
        settle();
        [&] { QTRY_COMPARE(axis().timeline().ticks.back().entry, tree().current()); }();
        return axis().timeline();
    }
};

int main(int argc, char** argv)
{
    prepareGraphics();
    QApplication application(argc, argv);
    WindowTimelineTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "window_timeline_test.moc"
