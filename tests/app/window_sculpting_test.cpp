// Brushes in the view, with real events: what they do, that each stroke is one entry, and their keys.
#include "support/history_on_test.h"
#include "ui/interaction/hands.h"
#include "ui/interaction/sculpt_hand.h"
#include "ui/panels/banner.h"
#include "ui/panels/timeline_axis.h"
#include "ui/panels/timeline_panel.h"
#include "ui/run_window.h"

#include <QMenu>
#include <QToolBar>
#include <QToolButton>
#include <QWheelEvent>

using namespace knead;

class WindowSculptingTest : public QObject, HistoryOnTest {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        if (!hasDisplay())
            KNEAD_SKIP_WITHOUT("display", "The view needs a display: run this test under xvfb-run.");
        prepare();
    }

    void init() { QSettings().remove("hands"); }
    void cleanup() { m_window.reset(); }

    /// Each brush: the material moves, the stroke is one entry with its name, nothing of the hand is left, and it is undone.
    void aStrokeIsOneEntry_data()
    {
        QTest::addColumn<QString>("brush");
        QTest::addColumn<QPoint>("way");
        QTest::addColumn<QString>("entry");
        QTest::newRow("pull") << "pull" << QPoint(0, -60) << "Pull ";
        QTest::newRow("thumb") << "sculptThumb" << QPoint(40, 0) << "Thumb on ";
        QTest::newRow("smooth") << "sculptSmooth" << QPoint(40, 0) << "Smooth ";
        QTest::newRow("flatten") << "sculptFlatten" << QPoint(40, 0) << "Flatten ";
        QTest::newRow("pinch") << "sculptPinch" << QPoint(0, 0) << "Pinch ";
        QTest::newRow("smear") << "sculptSmear" << QPoint(60, 0) << "Smear ";
        QTest::newRow("bend") << "sculptBend" << QPoint(60, 0) << "Bend ";
        QTest::newRow("twist") << "sculptTwist" << QPoint(60, 0) << "Twist ";
    }
    void aStrokeIsOneEntry()
    {
        QFETCH(QString, brush);
        QFETCH(QPoint, way);
        QFETCH(QString, entry);
        openBar();
        const std::uint64_t before = digest();
        const std::size_t entries = tree().records().size();
        action(qPrintable(brush))->trigger();
        QVERIFY(action(qPrintable(brush))->isChecked());
        press(onTop(0.7));
        QVERIFY(hand().isStroking());
        QVERIFY(find<QWidget>("sculptOverlay")->isVisible());
        drag(way);
        const double begin = snapshot().time;
        QVERIFY(comesTrue([&] { return snapshot().time > begin + 0.4; }));
        if (brush != "sculptSmooth") // it levels what stands out, and here nothing does
            QVERIFY2(hand().force() > 0, "the material resists");
        picture(qPrintable("sculpt-" + brush));
        release();
        QVERIFY2(comesTrue([this] { return !snapshot().playing; }), "it stood still before");
        settle();
        QVERIFY(!hand().isStroking());
        QVERIFY(snapshot().tools.empty() && snapshot().fixtures.empty());
        QVERIFY2(snapshot().health.ok, snapshot().health.message.english().c_str());
        QCOMPARE(tree().records().size(), entries + 1);
        QVERIFY2(presentName().startsWith(entry), qPrintable(presentName()));
        verifyUndo(before, presentName());
        verifyStraightRun();
    }

    /// What is seen is not there any more: that is said, and not for longer than it is so.
    void thePastIsNotSculpted()
    {
        openBar();
        QVERIFY(action("pressIt")->isEnabled());
        document().post(SetGravity{Vec3(0, 0, -9.81)});
        simulate(0.2);
        settle();
        undo();
        settle();
        auto* timeline = find<TimelinePanel>("timelinePanel");
        auto* axis = find<TimelineAxis>("timelineAxis");
        QTRY_VERIFY(!axis->timeline().pictures.empty());
        QTRY_VERIFY(action("pressIt")->isEnabled());
        const QPoint place = axis->placeOf(0.5 * axis->timeline().end);
        QTest::mouseClick(axis, Qt::LeftButton, {}, place);
        QTRY_VERIFY(timeline->isLookingBack() && view().isLookingBack());
        QVERIFY(!action("pressIt")->isEnabled() && !find<QWidget>("pressButton")->isVisible());
        action("sculptThumb")->trigger();
        press(onTop(0.7));
        release();
        QVERIFY(!hand().isStroking());
        QVERIFY2(m_window->banner().sentence().contains("Esc returns"), qPrintable(m_window->banner().sentence()));
        QVERIFY(!m_window->banner().isHidden());
        key(Qt::Key_Escape);
        key(Qt::Key_Escape);
        QVERIFY(!timeline->isLookingBack());
        QVERIFY(m_window->banner().isHidden());
        QVERIFY(action("pressIt")->isEnabled());
    }

    void theOtherSideIsDoneToo()
    {
        openBar();
        key(Qt::Key_X, Qt::ShiftModifier);
        QVERIFY(action("mirrorX")->isChecked());
        key(Qt::Key_T);
        press(onTop(0.75));
        QTRY_COMPARE(snapshot().tools.size(), std::size_t{2});
        const double middle = document().content().box.center().x();
        QVERIFY(std::abs(snapshot().tools[0].pose.position.x() + snapshot().tools[1].pose.position.x() - 2 * middle) <
                0.05 * document().size());
        picture("sculpt-mirrored");
        release();
        QVERIFY(comesTrue([this] { return !snapshot().playing; }));
        key(Qt::Key_X, Qt::ShiftModifier);
        QVERIFY(!action("mirrorX")->isChecked());
    }

    /// Radius and strength by keys and wheel; the cursor says what they are. The wheel alone zooms.
    void radiusAndForceAreChangedAtTheCursor()
    {
        openBar();
        key(Qt::Key_T);
        QTest::mouseMove(&view(), onTop(0.5));
        QTRY_VERIFY(find<QWidget>("sculptOverlay")->isVisible()); // the ring
        const double radius = hand().radius();
        key(Qt::Key_BracketRight);
        QVERIFY(hand().radius() > 1.1 * radius);
        key(Qt::Key_BracketLeft);
        key(Qt::Key_BracketLeft);
        QVERIFY(hand().radius() < 0.95 * radius);
        const double distance = view().camera().distance;
        const auto turn = [&](Qt::KeyboardModifiers modifiers) {
            const QPointF place(onTop(0.5));
            QWheelEvent wheel(place, view().mapToGlobal(place), {}, QPoint(0, 120), Qt::NoButton, modifiers,
                              Qt::NoScrollPhase, false);
            QApplication::sendEvent(&view(), &wheel);
        };
        turn(Qt::ShiftModifier);
        QVERIFY(choices().sculptStrength > 1.1);
        QCOMPARE(view().camera().distance, distance);
        turn({});
        QVERIFY(view().camera().distance != distance);
        picture("sculpt-ring");
        key(Qt::Key_Escape);
        QVERIFY(!hand().brush());
        QTRY_VERIFY(!find<QWidget>("sculptOverlay")->isVisible());
    }

    /// At the limit one key gives more force.
    void plusGivesMoreForce()
    {
        openBar();
        key(Qt::Key_T);
        press(onTop(0.5));
        QTRY_COMPARE(snapshot().tools.size(), std::size_t{1});
        const double limit = snapshot().tools[0].forceLimit;
        QTest::keyClick(&view(), Qt::Key_Plus);
        QTRY_VERIFY(snapshot().tools[0].forceLimit > 1.4 * limit);
        QTest::keyClick(&view(), Qt::Key_Escape);
        QVERIFY(!hand().isStroking());
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().tools.empty(), patience);
        release();
        QVERIFY(comesTrue([this] { return !snapshot().playing; }));
    }

    /// Time is stopped in the middle of a stroke: nothing of the hand is left.
    void strokesEndWithTime()
    {
        openBar();
        for (const char* brush : {"sculptThumb", "pull"}) {
            action(brush)->setChecked(true);
            press(onTop(0.5));
            QTRY_VERIFY(!snapshot().tools.empty() || !snapshot().fixtures.empty());
            document().pause();
            QVERIFY(comesTrue([this] { return snapshot().tools.empty() && snapshot().fixtures.empty(); }));
            release();
            settle();
            QVERIFY(!hand().isStroking());
        }
        action("sculptThumb")->setChecked(true);
        press(onTop(0.5));
        document().pause(); // before the finger was seen
        release();
        QVERIFY(comesTrue([this] { return document().isSettled() && snapshot().tools.empty(); }));
        QVERIFY(snapshot().fixtures.empty());
    }

    void whatDoesNotDeformSaysWhy()
    {
        openBar();
        key(Qt::Key_S);
        document().post(SetBodyKind{0, BodyKind::rigid});
        QTRY_COMPARE(snapshot().bodies[0].kind, BodyKind::rigid);
        press(onTop(0.5));
        QVERIFY(!hand().isStroking());
        QVERIFY2(problem().contains("make it deformable"), qPrintable(problem()));
        release();
    }

    void theStripIsBesideTheView()
    {
        openBar();
        auto* bar = find<QToolBar>("sculptBar");
        QVERIFY(bar->isVisible());
        QVERIFY(bar->mapToGlobal(QPoint()).x() >= view().mapToGlobal(QPoint(view().width(), 0)).x());
        for (const char* name : {"pull", "sculptThumb", "sculptSmooth", "sculptFlatten", "sculptPinch", "sculptSmear",
                                 "sculptBend", "sculptTwist", "mirrorX", "mirrorY", "mirrorZ"})
            QVERIFY2(bar->widgetForAction(action(name)) != nullptr, name);
        auto* thumb = qobject_cast<QToolButton*>(bar->widgetForAction(action("sculptThumb")));
        QTest::mouseClick(thumb, Qt::LeftButton);
        QCOMPARE(hand().brush(), std::optional(SculptBrush::thumb));
        auto* smooth = qobject_cast<QToolButton*>(bar->widgetForAction(action("sculptSmooth")));
        QTest::mouseClick(smooth, Qt::LeftButton);
        QCOMPARE(hand().brush(), std::optional(SculptBrush::smooth));
        QVERIFY(!action("sculptThumb")->isChecked());
        QTest::mouseClick(smooth, Qt::LeftButton);
        QVERIFY(!hand().brush());
        action("show_sculptBar")->trigger();
        QVERIFY(!bar->isVisible());
        action("show_sculptBar")->trigger();
        QVERIFY(bar->isVisible());
    }

private:
    ViewportWidget& view() { return m_window->viewport(); }
    const SculptHand& hand() { return m_window->hands().sculpting(); }
    const HandChoices& choices() { return m_window->hands().settings().choices(); }

    /// A pixel of the top of the bar. @param share of its length
    QPoint onTop(double share)
    {
        const Box box = document().content().box;
        return view()
            .widgetPosition(Vec3(box.min().x() + share * box.sizes().x(), box.center().y(), box.max().z()))
            ->toPoint();
    }

    void press(const QPoint& place)
    {
        m_pressed = m_now = place;
        QTest::mouseMove(&view(), place);
        QTest::mousePress(&view(), Qt::LeftButton, {}, place);
    }
    void drag(const QPoint& way)
    {
        for (int step = 1; step <= 6; ++step) {
            m_now = m_pressed + way * step / 6;
            QTest::mouseMove(&view(), m_now);
            QTest::qWait(15); // the pace of a hand
        }
    }
    void release() { QTest::mouseRelease(&view(), Qt::LeftButton, {}, m_now); }

    QPoint m_pressed;
    QPoint m_now;
};

int main(int argc, char** argv)
{
    prepareGraphics();
    QApplication application(argc, argv);
    WindowSculptingTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "window_sculpting_test.moc"
