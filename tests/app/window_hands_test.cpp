// Tools and material by hand, with real events: handles, keys, pulling, the 3D mouse, and the forces that come of it.
#include "support/history_on_test.h"
#include "support/stand_in_spacenavd.h"
#include "ui/document/fold_watch.h"
#include "ui/document/warning_watch.h"
#include "ui/interaction/gizmo_hand.h"
#include "ui/interaction/hands.h"
#include "ui/interaction/key_hand.h"
#include "ui/interaction/press_hand.h"
#include "ui/interaction/sculpt_hand.h"
#include "ui/measuring/fold_marks.h"
#include "ui/measuring/marks_overlay.h"
#include "ui/panels/force_panel.h"
#include "ui/panels/plot_view.h"
#include "ui/panels/quantity_field.h"
#include "ui/run_window.h"

#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QMouseEvent>
#include <QTemporaryDir>
#include <QtTest>

#include <cmath>
#include <numbers>

using namespace knead;

class WindowHandsTest : public QObject, HistoryOnTest {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        if (!hasDisplay())
            KNEAD_SKIP_WITHOUT("display", "The view needs a display: run this test under xvfb-run.");
        qputenv("SPNAV_SOCKET", socketPath().c_str());
        prepare();
    }

    void init() { QSettings().remove("hands"); }
    void cleanup() { m_window.reset(); }

    void anArrowMovesTheToolAlongItsAxis()
    {
        openWithBlock();
        const Pose start = tool().pose;
        const std::size_t entries = tree().records().size();
        press(handle(GizmoPart::moveX));
        drag(QPoint(70, 0));
        QTRY_VERIFY((tool().pose.position - start.position).norm() > 0.002);
        const Vec3 way = tool().pose.position - start.position;
        QVERIFY(std::abs(way.y()) + std::abs(way.z()) < 1e-12);
        QVERIFY2(gizmo().note().startsWith("X ") && gizmo().note().endsWith(" mm"), qPrintable(gizmo().note()));
        pictures("gizmo-move");
        release();
        QVERIFY(gizmo().note().isEmpty());
        settle();
        QCOMPARE(tree().records().size(), entries + 1);
        QCOMPARE(presentName(), QString("Move Block 1"));
        undo();
        settle();
        QCOMPARE(tool().pose.position, start.position);
    }

    /// Middle button on top of the left one.
    void theViewIsTurnedWhileAHandleIsDragged()
    {
        openWithBlock();
        const Vec3 start = tool().pose.position;
        press(handle(GizmoPart::moveX));
        drag(QPoint(40, 0));
        QTRY_VERIFY(tool().pose.position != start);
        drawn();
        const Vec3 reached = tool().pose.position;
        turnBy(QPoint(260, 30));
        drawn();
        QVERIFY2((tool().pose.position - reached).norm() < 1e-12, "turning moves nothing");
        // The arrow is seen otherwise now: along it the tool goes as far as the mouse.
        const auto seen = [this](const Vec3& place) { return *view().widgetPosition(place); };
        const QPointF arrow = seen(reached + Vec3(0.01, 0, 0)) - seen(reached);
        const QPointF before = seen(reached);
        const QPoint way = (arrow * (60 / std::hypot(arrow.x(), arrow.y()))).toPoint();
        moveBy(way);
        QTRY_VERIFY((tool().pose.position - reached).norm() > 0.0005);
        drawn();
        const QPointF gone = seen(tool().pose.position) - before;
        QVERIFY2(std::hypot(gone.x() - way.x(), gone.y() - way.y()) < 6,
                 qPrintable(QStringLiteral("%1 %2 for %3 %4").arg(gone.x()).arg(gone.y()).arg(way.x()).arg(way.y())));
        const Vec3 moved = tool().pose.position - reached;
        QVERIFY(std::abs(moved.y()) + std::abs(moved.z()) < 1e-12);
        QTest::keyClick(&view(), Qt::Key_Escape);
        release();
        settle();
        QCOMPARE(presentName(), QString("Add Block 1"));
    }

    void theViewIsTurnedWhileAToolIsDragged()
    {
        openWithBlock();
        action("gizmo")->setChecked(false);
        const Vec3 start = tool().pose.position;
        press(view().widgetPosition(start)->toPoint());
        moveBy(QPoint(30, -10));
        QTRY_VERIFY((tool().pose.position - start).norm() > 0.0005);
        drawn();
        const Vec3 reached = tool().pose.position;
        turnBy(QPoint(200, 20));
        moveBy(QPoint(1, 0)); // from here on
        drawn();
        QVERIFY2((tool().pose.position - reached).norm() < 1e-3, "it does not jump");
        const QPointF before = *view().widgetPosition(tool().pose.position);
        const Vec3 here = tool().pose.position;
        moveBy(QPoint(40, 20));
        QTRY_VERIFY((tool().pose.position - here).norm() > 0.0005);
        const QPointF gone = *view().widgetPosition(tool().pose.position) - before;
        QVERIFY2(std::hypot(gone.x() - 40, gone.y() - 20) < 6,
                 qPrintable(QStringLiteral("%1 %2").arg(gone.x()).arg(gone.y())));
        release();
        action("gizmo")->setChecked(true);
        settle();
    }

    void aNumberIsTypedWhileDragging()
    {
        openWithBlock();
        const Pose start = tool().pose;
        press(handle(GizmoPart::moveZ));
        drag(QPoint(0, -30));
        QTest::keyClicks(&view(), "12,5");
        QTRY_COMPARE(tool().pose.position.z(), start.position.z() + 0.0125);
        QCOMPARE(gizmo().note(), QString("Z 12,5| = 12.5 mm"));
        drag(QPoint(0, -90)); // the mouse has no say any more
        QTest::keyClick(&view(), Qt::Key_Backspace);
        QTest::keyClick(&view(), Qt::Key_Backspace);
        QTRY_COMPARE(tool().pose.position.z(), start.position.z() + 0.012);
        picture("gizmo-typed");
        QTest::keyClick(&view(), Qt::Key_Return);
        QVERIFY(!gizmo().isDragging());
        release();
        settle();
        QCOMPARE(tool().pose.position, Vec3(start.position + Vec3(0, 0, 0.012)));
        QCOMPARE(presentName(), QString("Move Block 1"));
    }

    void aPlaneTakesTwoNumbers()
    {
        openWithBlock();
        const Pose start = tool().pose;
        press(handle(GizmoPart::planeZ));
        QTest::keyClicks(&view(), "3");
        QTest::keyClick(&view(), Qt::Key_Tab);
        QTest::keyClicks(&view(), "-4 mm");
        QTest::keyClick(&view(), Qt::Key_Return);
        release();
        QTRY_VERIFY((tool().pose.position - start.position - Vec3(0.003, -0.004, 0)).norm() < 1e-12);
    }

    void aRingTurnsTheToolInStepsWithCtrl()
    {
        openWithBlock();
        const Pose start = tool().pose;
        press(handle(GizmoPart::turnZ));
        drag(QPoint(31, 17));
        QTest::keyPress(&view(), Qt::Key_Control);
        seen();
        QVERIFY(tool().pose.rotation.angularDistance(start.rotation) > 0.01);
        const double turned = tool().pose.rotation.angularDistance(start.rotation) * 180 / std::numbers::pi;
        QVERIFY2(std::abs(turned - 5 * std::round(turned / 5)) < 1e-4, qPrintable(QString::number(turned)));
        QVERIFY2(gizmo().note().endsWith(QString::fromUtf8("°")), qPrintable(gizmo().note()));
        picture("gizmo-turn");
        QTest::keyRelease(&view(), Qt::Key_Control);
        release();
        settle();
        QCOMPARE(tool().pose.position, start.position);
        // Typed in degrees, along the tool's own axes.
        HandChoices choices = m_window->hands().settings().choices();
        choices.ownAxes = true;
        m_window->hands().settings().set(choices);
        const Quaternion before = tool().pose.rotation;
        press(handle(GizmoPart::turnX));
        QTest::keyClicks(&view(), "30");
        QTest::keyClick(&view(), Qt::Key_Return);
        release();
        const Quaternion wanted = before * Quaternion(Eigen::AngleAxisd(std::numbers::pi / 6, Vec3::UnitX()));
        QTRY_VERIFY(tool().pose.rotation.angularDistance(wanted) < 1e-9);
    }

    void escPutsTheToolBackAsIfNothingHadBeen()
    {
        openWithBlock();
        settle();
        const std::uint64_t before = digest();
        const std::size_t entries = tree().records().size();
        press(handle(GizmoPart::moveY));
        drag(QPoint(40, 20));
        QTRY_VERIFY(digestOf(snapshot()) != before);
        QTest::keyClick(&view(), Qt::Key_Escape);
        release();
        QTRY_COMPARE(digestOf(snapshot()), before);
        settle();
        QCOMPARE(tree().records().size(), entries);
        QVERIFY(!action("redo")->isEnabled());
        QCOMPARE(action("undo")->text(), QString("Undo \"Add Block 1\""));
        // And one can go on from there.
        press(handle(GizmoPart::moveX));
        drag(QPoint(40, 0));
        release();
        settle();
        QCOMPARE(tree().records().size(), entries + 1);
        verifyStraightRun();
    }

    void whileTimeRunsTheToolKeepsToItsLimits()
    {
        openWithBlock();
        settle();
        const double limit = tool().speedLimit;
        const std::size_t entries = tree().records().size();
        key(Qt::Key_Space);
        QTRY_VERIFY(snapshot().playing && snapshot().time > 0.02);
        const Vec3 start = tool().pose.position;
        const double begin = snapshot().time;
        press(handle(GizmoPart::moveZ));
        QTest::keyClicks(&view(), "-200");
        QTRY_VERIFY_WITH_TIMEOUT(tool().force.norm() > 0, patience);
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().time > begin + 0.4, patience);
        QVERIFY((tool().pose.position - start).norm() <= limit * (snapshot().time - begin) * 1.001 + 1e-9);
        QVERIFY(tool().peakForce < 3 * tool().forceLimit);
        pictures("gizmo-pressing");
        QTest::keyClick(&view(), Qt::Key_Return);
        release();
        key(Qt::Key_Space);
        QTRY_VERIFY(!snapshot().playing);
        settle();
        QVERIFY(tree().records().size() <= entries + 3); // before, the push, after
        verifyStraightRun();
    }

    void theHandlesGiveWayToWhatLiesElsewhere()
    {
        openWithBlock();
        QVERIFY(gizmo().gizmo().has_value());
        key(Qt::Key_F3);
        QVERIFY(!gizmo().gizmo().has_value());
        QVERIFY(!find<QWidget>("gizmo")->isVisible());
        key(Qt::Key_F3);
        QVERIFY(gizmo().gizmo().has_value());
        key(Qt::Key_X); // faces are picked now
        QVERIFY(!gizmo().gizmo().has_value());
        key(Qt::Key_X);
        document().select({});
        QVERIFY(!gizmo().gizmo().has_value());
    }

    void theLeftButtonHasOneModeAtATimeWhichEscLeaves()
    {
        openWithBlock();
        const QStringList all = {"pull", "press", "fixFaces", "measureDistance", "measureAngle", "placeProbe"};
        const auto on = [&] {
            QStringList names;
            for (const QString& name : all)
                if (action(name.toLatin1())->isChecked())
                    names << name;
            return names;
        };
        for (const QString& mode : all + QStringList(all.rbegin(), all.rend() - 1) + all) {
            if (!on().contains(mode))
                action(mode.toLatin1())->trigger();
            QCOMPARE(on(), QStringList(mode));
            QVERIFY(!gizmo().gizmo().has_value()); // its handles could not be taken
            QCOMPARE(m_window->hands().sculpting().brush().has_value(), mode == "pull");
            QCOMPARE(m_window->hands().pressing().isOn(), mode == "press");
            QCOMPARE(view().isFixing(), mode == "fixFaces");
        }
        key(Qt::Key_Escape);
        QVERIFY(on().isEmpty());
        QVERIFY(gizmo().gizmo().has_value()); // the tool is selected as before
        QCOMPARE(view().cursor().shape(), Qt::ArrowCursor);
        // Beside the part a mode of its own selects nothing.
        key(Qt::Key_F6);
        QCOMPARE(view().cursor().shape(), Qt::PointingHandCursor);
        QTest::mouseClick(&view(), Qt::LeftButton, {}, QPoint(12, view().height() / 2));
        QCOMPARE(document().selection().kind, Selection::Kind::Tool);
        openExample("bar.step", 12); // another part begins without
        QVERIFY(on().isEmpty());
        QVERIFY(!view().hasMode());
    }

    void whatIsDraggedWhenAModeBeginsEndsAsItBegan()
    {
        openWithBlock();
        const Vec3 start = tool().pose.position;
        press(handle(GizmoPart::moveX));
        drag(QPoint(-40, 0));
        key(Qt::Key_M);
        QVERIFY(gizmo().isDragging());
        drag(QPoint(-60, 0));
        release();
        QVERIFY(!gizmo().isDragging());
        QVERIFY(!document().isInGesture());
        QTRY_VERIFY((tool().pose.position - start).norm() > 0.001);
        QVERIFY(action("measureDistance")->isChecked());
    }

    void twoFastPressesOnAHandleAreForTheHandle()
    {
        openWithBlock();
        const QPoint place = handle(GizmoPart::moveX);
        press(place);
        QVERIFY(gizmo().isDragging());
        release();
        QTest::mouseDClick(&view(), Qt::LeftButton, {}, place); // the second press only
        QVERIFY(gizmo().isDragging());
        release();
        QCOMPARE(document().selection().kind, Selection::Kind::Tool);
        QVERIFY(!gizmo().isDragging());
    }

    void unitsAreTypedIntoAHandleAlsoWhileKeysDriveTools()
    {
        openWithBlock();
        const Vec3 start = tool().pose.position;
        key(Qt::Key_F4);
        press(handle(GizmoPart::moveX));
        QTest::keyClicks(&view(), "2e-3 m"); // E drives the second tool
        QTest::keyClick(&view(), Qt::Key_Return);
        release();
        QTRY_VERIFY((tool().pose.position - start - Vec3(0.002, 0, 0)).norm() < 1e-12);
    }

    void escPutsAToolThatIsDraggedByItselfBack()
    {
        openWithBlock();
        const std::uint64_t before = digest();
        const std::size_t entries = tree().records().size();
        key(Qt::Key_F3); // without handles
        press(view().widgetPosition(tool().pose.position)->toPoint());
        drag(QPoint(40, 0));
        QTRY_VERIFY(digestOf(snapshot()) != before);
        QTest::keyClick(&view(), Qt::Key_Escape);
        drag(QPoint(80, 0));
        release();
        QTRY_COMPARE(digestOf(snapshot()), before);
        settle();
        QCOMPARE(tree().records().size(), entries);
        key(Qt::Key_F3);
    }

    void handlesAndForcesAreShownAsBefore()
    {
        openBar();
        key(Qt::Key_F3);
        key(Qt::Key_F8);
        openBar(); // in another window
        QVERIFY(!action("gizmo")->isChecked());
        QVERIFY(!action("forces")->isChecked());
        QVERIFY(!view().options().forces);
        key(Qt::Key_F3);
        key(Qt::Key_F8);
        QVERIFY(view().options().forces);
    }

    void eachToolHasKeysOfItsOwn()
    {
        openWithBlock();
        addBlock();
        addBlock();
        place(0, Vec3(-0.03, 0, 0));
        place(2, Vec3(0.03, 0, 0));
        settle();
        key(Qt::Key_F4);
        QTRY_VERIFY(find<QWidget>("keyCards")->isVisible());
        key(Qt::Key_1, Qt::KeypadModifier);
        key(Qt::Key_F);
        rest();
        // One step for a press while time stands still.
        const std::array<Vec3, 3> start = places();
        for (int times = 0; times < 3; ++times) // however fast they follow each other
            QTest::keyClick(&view(), Qt::Key_Right);
        QTest::keyClick(&view(), Qt::Key_E);
        QTest::keyClick(&view(), Qt::Key_L, Qt::ShiftModifier);
        const double step = m_window->hands().settings().choices().keyStep;
        QTRY_VERIFY((places()[0] - start[0] - Vec3(3 * step, 0, 0)).norm() < 1e-12);
        QTRY_VERIFY((places()[1] - start[1] - Vec3(0, 0, step)).norm() < 1e-12);
        QTRY_VERIFY((places()[2] - start[2] - Vec3(step / 5, 0, 0)).norm() < 1e-12);
        // So many steps per second while it runs, and all at a time.
        settle();
        key(Qt::Key_Space);
        QTRY_VERIFY(snapshot().playing);
        QTest::keyPress(&view(), Qt::Key_PageUp);
        QTest::keyPress(&view(), Qt::Key_E);
        QTest::keyPress(&view(), Qt::Key_O);
        QCOMPARE(m_window->hands().keys().pressed().size(), std::size_t{3});
        seen();
        const std::array<Vec3, 3> before = places();
        const double begin = snapshot().time;
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().time > begin + 0.2, patience);
        const double speed = m_window->hands().settings().choices().keySpeed();
        const double passed = snapshot().time - begin;
        for (std::size_t i = 0; i < 3; ++i)
            QVERIFY(std::abs(places()[i].z() - before[i].z() - speed * passed) < 1e-6);
        pictures("keys");
        for (const Qt::Key pressed : {Qt::Key_PageUp, Qt::Key_E, Qt::Key_O})
            QTest::keyRelease(&view(), pressed);
        QVERIFY(m_window->hands().keys().pressed().empty());
        seen();
        const std::array<Vec3, 3> end = places();
        const double stopped = snapshot().time;
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().time > stopped + 0.1, patience);
        QCOMPARE(places()[1], end[1]);
        key(Qt::Key_Space);
        settle();
        verifyStraightRun();
        QTest::keyClick(&view(), Qt::Key_Escape);
        QVERIFY(!m_window->hands().keys().isOn());
        QTRY_VERIFY(!find<QWidget>("keyCards")->isVisible());
    }

    void theKeyboardDrivesOneToolWhileTheMouseDragsAnother()
    {
        openWithBlock();
        addBlock();
        place(0, Vec3(-0.04, 0, 0.02));
        place(1, Vec3(0.04, 0, 0.02));
        settle();
        key(Qt::Key_F4);
        key(Qt::Key_1, Qt::KeypadModifier);
        key(Qt::Key_F);
        rest();
        document().select({Selection::Kind::Tool, snapshot().tools[1].id});
        const std::array<Vec3, 3> start = places();
        key(Qt::Key_Space);
        QTRY_VERIFY(snapshot().playing && snapshot().time > 0.12);
        QTRY_VERIFY(document().history().isSettled());
        const std::size_t entries = tree().records().size();
        QTest::keyPress(&view(), Qt::Key_Up); // the left hand
        press(handle(GizmoPart::moveX));      // the right hand
        for (int i = 1; i <= 10; ++i) {
            drag(QPoint(-4 * i, 0));
            QTest::qWait(30);
        }
        QTRY_VERIFY((places()[0] - start[0]).y() > 0.002);
        QTRY_VERIFY((places()[1] - start[1]).x() < -0.002);
        QTest::keyRelease(&view(), Qt::Key_Up);
        drag(QPoint(-60, 0));
        QVERIFY(document().isInGesture()); // the mouse still holds its tool
        drawn();
        picture("two-hands");
        release();
        QVERIFY(!document().isInGesture());
        key(Qt::Key_Space);
        QTRY_VERIFY(!snapshot().playing);
        settle();
        QVERIFY(tree().records().size() <= entries + 3); // what ran before, both hands, what ran after
        verifyStraightRun();
    }

    void materialIsPulledWithASpring()
    {
        openBar();
        fixOneEnd();
        key(Qt::Key_1, Qt::KeypadModifier);
        key(Qt::Key_F);
        rest();
        settle();
        const std::uint64_t before = digest();
        const std::size_t entries = tree().records().size();
        key(Qt::Key_F6);
        const Box box = document().content().box;
        const Vec3 taken(box.max().x() - 0.1 * box.sizes().x(), box.min().y(), box.center().z());
        press(view().widgetPosition(taken)->toPoint());
        QVERIFY(m_window->hands().sculpting().isStroking());
        QTRY_VERIFY(snapshot().fixtures.size() == 2);
        for (int i = 1; i <= 12; ++i) {
            drag(QPoint(0, -10 * i));
            QTest::qWait(25);
        }
        QTRY_VERIFY_WITH_TIMEOUT(largestRise() > 0.002, patience);
        QVERIFY(m_window->hands().sculpting().force() > 0);
        QTRY_VERIFY(find<QWidget>("sculptOverlay")->isVisible());
        const double time = snapshot().time;
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().time > time + 0.5, patience);
        pictures("pull");
        release();
        QTRY_VERIFY(!snapshot().playing); // it stood still before
        QVERIFY(!m_window->hands().sculpting().isStroking());
        QTRY_COMPARE(snapshot().fixtures.size(), std::size_t{1});
        settle();
        QCOMPARE(tree().records().size(), entries + 1);
        verifyUndo(before, "Pull " + QString::fromStdString(document().content().bodies[0]->name));
        verifyStraightRun();
        key(Qt::Key_Escape);
        QVERIFY(!m_window->hands().sculpting().brush().has_value());
    }

    /// It comes along the normal, stops at its limit, and is lifted; all of that is one entry.
    void materialIsPressedWithAThumb()
    {
        openBar();
        fixBack();
        key(Qt::Key_1, Qt::KeypadModifier);
        key(Qt::Key_F);
        rest();
        settle();
        const std::uint64_t before = digest();
        const std::size_t entries = tree().records().size();
        const PressHand& hand = m_window->hands().pressing();
        key(Qt::Key_F5);
        const Box box = document().content().box;
        const Vec3 place(box.max().x() - 0.1 * box.sizes().x(), box.min().y(), box.center().z()); // on its front
        press(view().widgetPosition(place)->toPoint());
        QVERIFY(hand.isPressing());
        QTRY_COMPARE(snapshot().tools.size(), std::size_t{1});
        QTRY_COMPARE(document().selection().kind, Selection::Kind::Tool); // its force may be typed
        QCOMPARE(find<QLineEdit>("toolForceLimit")->isVisible(), true);
        QTRY_VERIFY_WITH_TIMEOUT(hand.force() > 0.8 * tool().forceLimit, patience);
        QVERIFY(find<QWidget>("pressNote")->isVisible());
        const Vec3 reached = tool().pose.position;
        QVERIFY(std::abs(reached.x() - place.x()) < 2e-3 && std::abs(reached.z() - place.z()) < 2e-3);
        pictures("press");
        const double time = snapshot().time;
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().time > time + 0.2, patience);
        QVERIFY(hand.force() < 1.1 * tool().forceLimit);
        release();
        QVERIFY(!hand.isPressing());
        QTRY_VERIFY_WITH_TIMEOUT(!snapshot().playing, patience); // it stood still before
        QVERIFY(tool().force.norm() < 1e-3 * tool().forceLimit);
        QVERIFY(tool().pose.position.y() < reached.y() - 1e-4);
        settle();
        QCOMPARE(tree().records().size(), entries + 1);
        verifyUndo(before, "Press on " + QString::fromStdString(document().content().bodies[0]->name));
        verifyStraightRun();
        key(Qt::Key_Escape);
        QVERIFY(!hand.isOn());
    }

    /// The tool that is selected, with the limit that was typed; again and again.
    void theSelectedToolIsPressedWhereOneClicks()
    {
        openBar();
        fixBack();
        key(Qt::Key_B);
        QTRY_COMPARE(document().selection().kind, Selection::Kind::Tool);
        document().reshapeTool(snapshot().tools[0].id, [](ToolState& state) { state.forceLimit = 0.5; });
        QTRY_COMPARE(tool().forceLimit, 0.5);
        key(Qt::Key_1, Qt::KeypadModifier);
        key(Qt::Key_F);
        rest();
        settle();
        const PressHand& hand = m_window->hands().pressing();
        key(Qt::Key_F5);
        const Box box = document().content().box;
        for (const double share : {0.3, 0.6}) {
            const Vec3 place(box.min().x() + share * box.sizes().x(), box.min().y(), box.center().z());
            press(view().widgetPosition(place)->toPoint());
            QTRY_VERIFY_WITH_TIMEOUT(hand.force() > 0.4, patience);
            QVERIFY(hand.force() < 0.6);
            QVERIFY(std::abs(tool().pose.position.x() - place.x()) < 2e-3);
            release();
            QTRY_VERIFY_WITH_TIMEOUT(!snapshot().playing, patience);
            QCOMPARE(snapshot().tools.size(), std::size_t{1});
        }
        settle();
        verifyStraightRun();
    }

    /// Whatever comes between, time stands still again and no gesture is left open.
    void pressesEnd_data()
    {
        QTest::addColumn<int>("how");
        QTest::newRow("let go before the thumb is there, and once more") << 0;
        QTest::newRow("the tool is removed") << 1;
        QTest::newRow("time is stopped") << 2;
    }
    void pressesEnd()
    {
        QFETCH(int, how);
        openBar();
        fixBack();
        key(Qt::Key_1, Qt::KeypadModifier);
        key(Qt::Key_F);
        rest();
        settle();
        const PressHand& hand = m_window->hands().pressing();
        key(Qt::Key_F5);
        const Box box = document().content().box;
        const QPoint pixel = view().widgetPosition(Vec3(box.center().x(), box.min().y(), box.center().z()))->toPoint();
        press(pixel);
        QVERIFY(hand.isPressing());
        if (how == 0) {
            release();
            press(pixel);
            release();
        } else {
            QTRY_VERIFY_WITH_TIMEOUT(hand.force() > 0, patience);
            if (how == 1)
                key(Qt::Key_Delete);
            if (how == 2)
                key(Qt::Key_Space);
            release();
        }
        QTRY_VERIFY_WITH_TIMEOUT(!snapshot().playing && !hand.isPressing(), patience);
        settle();
        QVERIFY(!document().isInGesture());
        QCOMPARE(snapshot().tools.size(), std::size_t{how == 1 ? 0U : 1U});
        if (how == 2) {
            const Vec3 place = tool().pose.position;
            key(Qt::Key_Space);
            const double time = snapshot().time;
            QTRY_VERIFY_WITH_TIMEOUT(snapshot().time > time + 0.1, patience);
            QVERIFY((tool().pose.position - place).norm() < 1e-3); // nobody holds it
            key(Qt::Key_Space);
            QTRY_VERIFY(!snapshot().playing);
        }
    }

    void whatCannotBePressedSaysWhy()
    {
        openBar();
        key(Qt::Key_F5);
        document().post(SetBodyKind{0, BodyKind::rigid});
        QTRY_COMPARE(snapshot().bodies[0].kind, BodyKind::rigid);
        const Box box = document().content().box;
        press(view().widgetPosition(Vec3(box.center().x(), box.center().y(), box.max().z()))->toPoint());
        QVERIFY(!m_window->hands().pressing().isPressing());
        QVERIFY2(m_window->banner().sentence().contains("make it deformable"),
                 qPrintable(m_window->banner().sentence()));
        release();
        QVERIFY(snapshot().tools.empty());
    }

    void whatCannotBePulledSaysWhy()
    {
        openBar();
        key(Qt::Key_F6);
        document().post(SetBodyKind{0, BodyKind::rigid});
        QTRY_COMPARE(snapshot().bodies[0].kind, BodyKind::rigid);
        const Box box = document().content().box;
        press(view().widgetPosition(Vec3(box.center().x(), box.center().y(), box.max().z()))->toPoint());
        QVERIFY(!m_window->hands().sculpting().isStroking());
        QVERIFY2(m_window->banner().sentence().contains("make it deformable"),
                 qPrintable(m_window->banner().sentence()));
        release();
        key(Qt::Key_X); // the other mode of the left button
        QVERIFY(!m_window->hands().sculpting().brush().has_value());
    }

    /// One half of a bar is turned over onto the other: that is said, and seen where it is, until it is undone.
    void foldsAreSaidAndSeen()
    {
        openBar();
        const Box box = document().content().box;
        const auto half = [&](double from, double to) {
            Box part = box;
            part.min().x() = box.min().x() + from * box.sizes().x();
            part.max().x() = box.min().x() + to * box.sizes().x();
            return objectsInBox(*document().content().bodies[0]->aggregate, part);
        };
        document().post(AddFixture{{"held", 0, half(-0.1, 0.45)}});
        GripTurn over;
        over.center = Vec3(box.center().x(), box.center().y(), box.center().z() + 0.2 * box.sizes().z());
        over.angularVelocity = Vec3(0.1, -1, 0.15).normalized() * 8;
        over.angle = 3.1;
        document().post(AddFixture{{"turned", 0, half(0.55, 1.1), Vec3::Zero(), over}});
        QTRY_COMPARE(snapshot().fixtures.size(), std::size_t{2});
        auto* folds = m_window->findChild<FoldWatch*>();
        auto* marks = view().findChild<FoldMarks*>();
        QSignalSpy said(folds, &FoldWatch::said);
        QSignalSpy passed(folds, &FoldWatch::passed);
        QVERIFY(folds->folds().empty() && marks->places().empty());
        key(Qt::Key_Space);
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().time > 0.45, patience);
        key(Qt::Key_Space);
        QTRY_VERIFY(!snapshot().playing);
        QTRY_COMPARE_WITH_TIMEOUT(folds->folds().size(), std::size_t{1}, patience);
        QCOMPARE(said.size(), qsizetype{1});
        QVERIFY2(said[0][0].toString().contains("folded over itself"), qPrintable(said[0][0].toString()));
        const std::vector<Vec3> places = folds->placesOf(folds->folds()[0]);
        QVERIFY(!places.empty());
        for (const Vec3& place : places)
            QVERIFY(box.exteriorDistance(place) < 0.5 * box.sizes().x());
        QTRY_VERIFY(find<QWidget>("foldMarks")->isVisible() && !marks->places().empty());
        auto* words = find<MarksOverlay>("warningMarks");
        QTRY_VERIFY(words->isVisible());
        QCOMPARE(words->marks().front().text, QString("Fold"));
        for (const OverlayMark& mark : words->marks()) // what crosses itself has no thickness
            QVERIFY2(!mark.text.startsWith("Wall"), qPrintable(mark.text));
        QVERIFY(std::ranges::find(places, words->marks().front().mark.points.front()) != places.end());
        pictures("folded");
        action("warnings")->trigger();
        QTRY_VERIFY(!words->isVisible() && !find<QWidget>("foldMarks")->isVisible());
        action("warnings")->trigger();
        QTRY_VERIFY(words->isVisible() && find<QWidget>("foldMarks")->isVisible());
        key(Qt::Key_R, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(folds->folds().empty() && marks->places().empty(), patience);
        QCOMPARE(passed.size(), qsizetype{1});
        QCOMPARE(passed[0], said[0]);
        QVERIFY(m_window->banner().isHidden() || m_window->banner().sentence() != said[0][0].toString());
        QVERIFY(!find<QWidget>("foldMarks")->isVisible());
        QTRY_VERIFY_WITH_TIMEOUT(!words->isVisible(), patience);
    }

    /// A bar is pulled until it tears; nothing is marked while it is fine, and again when that is undone.
    void placesThatAreAboutToBreakAreMarked()
    {
        openBar();
        Material material = snapshot().materials[0];
        material.yieldStress = material.elongationAtBreak = 0;
        material.tensileStrength = 0.05 * material.youngsModulus;
        document().post(SetMaterial{0, material});
        const Box box = document().content().box;
        const auto end = [&](double from, double to) {
            Box part = box;
            part.min().x() = box.min().x() + from * box.sizes().x();
            part.max().x() = box.min().x() + to * box.sizes().x();
            return objectsInBox(*document().content().bodies[0]->aggregate, part);
        };
        document().post(AddFixture{{"held", 0, end(-0.1, 0.1)}});
        GripTurn none;
        document().post(AddFixture{{"pulled", 0, end(0.9, 1.1), Vec3(0.012 * box.sizes().x(), 0, 0), none}});
        QTRY_COMPARE(snapshot().fixtures.size(), std::size_t{2});
        auto* words = find<MarksOverlay>("warningMarks");
        QVERIFY(!words->isVisible());
        const auto* watch = m_window->findChild<WarningWatch*>();
        const auto isSeen = [&] { return watch->seen() && watch->seen()->snapshot->step == snapshot().step; };
        while (!words->isVisible() && snapshot().broken == 0) {
            simulate(0.1); // by a twentieth of its strength, or somewhat more
            settle();
            QVERIFY2(comesTrue(isSeen), "nobody looks");
            drawn();
        }
        QCOMPARE(snapshot().broken, std::size_t{0});
        QVERIFY(words->isVisible());
        QVERIFY2(words->marks().front().text.startsWith("Stretched to "), qPrintable(words->marks().front().text));
        QVERIFY(words->marks().front().text.endsWith(" % of breaking"));
        pictures("overstretched");
        key(Qt::Key_R, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(!words->isVisible(), patience);
    }

    void stiffnessOfThePullIsTyped()
    {
        openBar();
        find<QDockWidget>("handsDock")->raise();
        auto* field = find<QuantityField>("pullStiffness");
        QTRY_VERIFY(field->isVisible());
        QCOMPARE(field->placeholderText(), QString("by the material"));
        field->setFocus();
        QTest::keyClicks(field, "2,5 N/mm");
        QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(m_window->hands().settings().choices().pullStiffness, 2500.0);
        QCOMPARE(HandSettings().choices().pullStiffness, 2500.0); // in the next session too
        auto* rate = find<QuantityField>("stepsPerSecond");
        rate->setFocus();
        rate->selectAll();
        QTest::keyClicks(rate, "5000");
        QTest::keyClick(rate, Qt::Key_Return);
        QVERIFY(rate->hasProblem());
        QCOMPARE(m_window->hands().settings().choices().stepsPerSecond, 20.0);
        picture("hand-panel");
    }

    void forcesAreShownPlottedAndWritten()
    {
        openWithBlock();
        fixOneEnd();
        document().select({Selection::Kind::Tool, snapshot().tools[0].id});
        key(Qt::Key_1, Qt::KeypadModifier);
        key(Qt::Key_F);
        rest();
        m_window->features().hands->exportForces(m_folder.filePath("early.csv"));
        QVERIFY(m_window->banner().sentence().contains("press Play"));
        m_window->banner().hide();
        key(Qt::Key_F9);
        QTRY_VERIFY(find<PlotView>("forcePlot")->isVisible());
        key(Qt::Key_Space);
        QTest::keyPress(&view(), Qt::Key_PageDown); // at once: it drives the tool from the first picture on
        QTRY_VERIFY_WITH_TIMEOUT(tool().force.norm() > 0, patience);
        const double time = snapshot().time;
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().time > time + 0.6, patience);
        QTest::keyRelease(&view(), Qt::Key_PageDown);
        auto* label = find<QLabel>(qPrintable(QStringLiteral("forceLabel%1").arg(tool().id)));
        QVERIFY(label != nullptr && label->text().endsWith('N'));
        auto* plot = find<PlotView>("forcePlot");
        const ForceRecord& record = find<ForcePanel>("forcePanel")->record();
        QTRY_VERIFY(!record.curves.empty());
        QTest::mouseMove(plot, plot->rect().center() + QPoint(40, 0));
        pictures("forces");
        key(Qt::Key_F8); // arrows and numbers off
        QTRY_VERIFY(find<QLabel>(qPrintable(QStringLiteral("forceLabel%1").arg(tool().id))) == nullptr);
        key(Qt::Key_F8);
        key(Qt::Key_Space);
        QTRY_VERIFY(!snapshot().playing);
        settle();
        QTRY_COMPARE(record.times.size(), document().timeline().pictures.size()); // it follows at leisure
        QCOMPARE(record.curves.size(), std::size_t{2});                           // the block and the fixture
        QCOMPARE(record.curves[0].name, std::string("Block 1"));
        double largest = 0;
        for (const std::optional<Vec3>& force : record.curves[0].forces)
            largest = std::max(largest, force->norm());
        QVERIFY(largest > 0 && largest <= tool().peakForce * 1.001);
        QTest::mouseClick(plot, Qt::LeftButton, {}, plot->legendArea(1).center().toPoint());
        QVERIFY(plot->isHidden(plot->lines()[1]));

        m_window->features().hands->exportForces(m_folder.filePath("forces.csv"));
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning(), patience);
        QFile file(m_folder.filePath("forces.csv"));
        QVERIFY(file.open(QFile::ReadOnly));
        const QList<QByteArray> lines = file.readAll().trimmed().split('\n');
        QVERIFY(lines[0].startsWith("time [s],Block 1 Fx [N],"));
        QCOMPARE(static_cast<std::size_t>(lines.size()), record.times.size() + 1);
        // Undo takes the plot back too.
        undo();
        settle();
        m_window->features().hands->exportForces(m_folder.filePath("missing/forces.csv"));
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning(), patience);
        QVERIFY(!m_window->banner().sentence().isEmpty());
    }

    void a3DMouseDrivesTheCameraOrTheSelectedTool()
    {
        StandInSpacenavd daemon(socketPath());
        openWithBlock();
        QTRY_VERIFY(daemon.hasClient());
        QTRY_VERIFY(find<QLabel>("spaceMouseState")->text().startsWith("Connected"));
        const Camera start = view().camera();
        for (int i = 0; i < 10; ++i)
            daemon.move({0, 0, 0}, {0, 200, 0}, 16);
        QTRY_VERIFY(std::abs(view().camera().yaw - start.yaw) > 0.1);
        daemon.move({350, 0, 0}, {0, 0, 0}, 16);
        QTRY_VERIFY((view().camera().target - start.target).norm() > 0);
        QCOMPARE(tool().pose.position, places()[0]);

        daemon.pressAndRelease(1); // the tool now
        QTRY_VERIFY(action("spaceMouseTool")->isChecked());
        const Camera camera = view().camera();
        settle();
        const Vec3 before = tool().pose.position;
        daemon.move({0, 350, 0}, {0, 0, 0}, 16);
        QTRY_VERIFY((tool().pose.position - before).dot(camera.up()) > 0.5 * 0.016 * tool().speedLimit);
        QCOMPARE(view().camera().yaw, camera.yaw);
        settle();
        key(Qt::Key_Space);
        QTRY_VERIFY(snapshot().playing);
        const Vec3 running = tool().pose.position;
        daemon.move({175, 0, 0}, {0, 0, 0}, 16);
        QTRY_VERIFY((tool().pose.position - running).dot(camera.right()) > 0.002);
        daemon.hangUp(); // a cable is pulled: the tool stops
        QTRY_VERIFY(find<QLabel>("spaceMouseState")->text().startsWith("None"));
        seen();
        const Vec3 end = tool().pose.position;
        const double stopped = snapshot().time;
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().time > stopped + 0.1, patience);
        QCOMPARE(tool().pose.position, end);
        key(Qt::Key_Space);
        settle();
        verifyStraightRun();
    }

private:
    ViewportWidget& view() { return m_window->viewport(); }
    const GizmoHand& gizmo() { return m_window->hands().gizmo(); }
    const ToolState& tool() { return snapshot().tools.at(0); }
    std::string socketPath() { return m_folder.filePath("spnav.sock").toStdString(); }

    void openWithBlock()
    {
        openBar();
        addBlock();
        key(Qt::Key_F);
        rest();
        settle();
    }

    std::array<Vec3, 3> places()
    {
        std::array<Vec3, 3> all{};
        for (std::size_t i = 0; i < std::min<std::size_t>(3, snapshot().tools.size()); ++i)
            all[i] = snapshot().tools[i].pose.position;
        return all;
    }

    void place(std::size_t index, const Vec3& way)
    {
        const ToolState moved = snapshot().tools[index];
        document().post(PlaceManipulator{moved.id, {moved.pose.position + way, moved.pose.rotation}});
        QTRY_VERIFY((snapshot().tools[index].pose.position - moved.pose.position - way).norm() < 1e-12);
    }

    /// Where a handle of the gizmo can be taken.
    QPoint handle(GizmoPart part)
    {
        const Gizmo handles = *gizmo().gizmo();
        const int axis = axisOf(part);
        Pixel pixel = handles.middlePixel();
        if (motionOf(part) == GizmoMotion::move)
            pixel = handles.pixelOf(0.85 * Gizmo::shaftEnd * Vec3::Unit(axis));
        if (motionOf(part) == GizmoMotion::plane)
            pixel = handles.pixelOf(35 * (Vec3::Ones() - Vec3::Unit(axis)));
        if (motionOf(part) == GizmoMotion::turn) // where no other handle is near
            for (const Pixel& point : handles.ringLine(axis))
                if (handles.partAt({std::round(point.x), std::round(point.y)}) == part)
                    pixel = point;
        return {qRound(pixel.x), qRound(pixel.y)};
    }

    void press(const QPoint& place)
    {
        m_pressed = place;
        QTest::mouseMove(&view(), place);
        QTest::mousePress(&view(), Qt::LeftButton, {}, place);
        m_now = place;
    }
    void drag(const QPoint& way)
    {
        m_now = m_pressed + way;
        QTest::mouseMove(&view(), m_now);
    }
    void release() { QTest::mouseRelease(&view(), Qt::LeftButton, {}, m_now); }
    void moveBy(const QPoint& way, Qt::MouseButtons buttons = Qt::LeftButton)
    {
        m_now += way;
        QMouseEvent event(QEvent::MouseMove, QPointF(m_now), view().mapToGlobal(QPointF(m_now)), Qt::NoButton, buttons,
                          {});
        QApplication::sendEvent(&view(), &event);
    }
    /// Turns the view while the left button is held.
    void turnBy(const QPoint& way)
    {
        QTest::mousePress(&view(), Qt::MiddleButton, {}, m_now);
        for (int i = 0; i < 10; ++i)
            moveBy(way / 10, Qt::LeftButton | Qt::MiddleButton);
        QTest::mouseRelease(&view(), Qt::MiddleButton, {}, m_now);
    }

    void fixOneEnd()
    {
        const Box box = document().content().box;
        document().toggleFace(0, faceAt(Vec3(box.min().x(), box.center().y(), box.center().z())));
        QTRY_COMPARE(snapshot().fixtures.size(), std::size_t{1});
    }

    void fixBack()
    {
        const Box box = document().content().box;
        document().toggleFace(0, faceAt(Vec3(box.center().x(), box.max().y(), box.center().z())));
        QTRY_COMPARE(snapshot().fixtures.size(), std::size_t{1});
    }

    /// The CAD face with a vertex nearest to a place.
    std::uint32_t faceAt(const Vec3& place)
    {
        const Part& part = document().content().model->parts[0];
        std::uint32_t nearest = 0;
        double least = 1e9;
        for (std::size_t t = 0; t < part.mesh.triangles.size(); ++t) {
            Vec3 center = Vec3::Zero();
            for (const auto v : part.mesh.triangles[t])
                center += part.mesh.vertices[v] / 3;
            if (const double away = (center - place).norm(); away < least) {
                least = away;
                nearest = part.mesh.faceOfTriangle[t];
            }
        }
        return nearest;
    }

    double largestRise()
    {
        double rise = 0;
        for (const Vec3& way : snapshot().bodies[0].displacements())
            rise = std::max(rise, way.z());
        return rise;
    }

    QTemporaryDir m_folder;
    QPoint m_pressed;
    QPoint m_now;
};

int main(int argc, char** argv)
{
    prepareGraphics();
    QApplication application(argc, argv);
    WindowHandsTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "window_hands_test.moc"
