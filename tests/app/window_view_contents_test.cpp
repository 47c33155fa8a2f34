#include "support/views_on_test.h"
#include "ui/panels/timeline_axis.h"
#include "ui/run_window.h"
#include "ui/viewport/color_legend.h"

#include <QLabel>
#include <QtTest>

#include <cmath>

using namespace knead;

/// Several views of a part: what each of them shows, and what their cameras follow.
class WindowViewContentsTest : public QObject, ViewsOnTest {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        if (!hasDisplay())
            KNEAD_SKIP_WITHOUT("display", "The views need a display: run this test under xvfb-run.");
        prepare(Eyes::open);
    }

    void init()
    {
        QSettings().clear();
        show(m_services);
    }

    void cleanup() { m_window.reset(); }

    void eachViewShowsThePartFromItsSide()
    {
        openExample("bracket.step");
        action("grid")->trigger();
        press(Qt::Key_F4, Qt::ShiftModifier);
        drawn();
        const Box box = document().content().box;
        for (const ViewSlot slot : {ViewSlot::front, ViewSlot::top, ViewSlot::right}) {
            SideView& side = *views().sideView(slot);
            QVERIFY(!side.camera().perspective);
            QCOMPARE(side.accessibleName(), views().name(slot).name());
            QRectF seen;
            for (const auto& body : document().frame()->bodies)
                for (const Vec3& vertex : body->places) {
                    const QPointF at = *side.widgetPosition(vertex);
                    seen |= QRectF(at - QPointF(0.5, 0.5), QSizeF(1, 1));
                }
            QVERIFY(QRectF(side.rect()).contains(seen));
            const Vec3 s = box.sizes();
            const double wide = slot == ViewSlot::right ? s.y() : s.x();
            const double high = slot == ViewSlot::top ? s.y() : s.z();
            QVERIFY(std::abs(seen.width() / seen.height() / (wide / high) - 1) < 0.05);
            // What is drawn is where it should be: material within, ground around.
            const QRect drawn = materialIn(side.grabFramebuffer());
            QVERIFY2(std::abs(drawn.width() - seen.width()) < 6 && std::abs(drawn.height() - seen.height()) < 6,
                     qPrintable(QString("%1x%2, not %3x%4")
                                    .arg(drawn.width())
                                    .arg(drawn.height())
                                    .arg(seen.width())
                                    .arg(seen.height())));
        }
    }

    void thingsLightUpUnderTheMouseInEveryView()
    {
        openExample("bracket.step");
        closeBanner();
        press(Qt::Key_F4, Qt::ShiftModifier);
        press(Qt::Key_2);
        drawn();
        for (const ViewSlot slot : {ViewSlot::front, ViewSlot::top, ViewSlot::right}) {
            const QPoint face = seenFace(slot);
            const QImage before = views().sideView(ViewSlot::front)->grabFramebuffer();
            mouseMove(placeOf(slot).topLeft() + face);
            QVERIFY(!view().marks().hovered.isEmpty());
            if (slot == ViewSlot::front)
                QTRY_VERIFY(views().sideView(slot)->grabFramebuffer() != before); // and is seen to
            mouseMove(placeOf(slot).bottomLeft() + QPoint(5, -5));                // beside the part
            QVERIFY(view().marks().hovered.isEmpty());
        }
        QCOMPARE(views().activeSlot(), ViewSlot::free);
    }

    void linkedCamerasPanAndZoomTogetherAndTurnAlone()
    {
        openExample("bracket.step");
        press(Qt::Key_F4, Qt::ShiftModifier);
        rest();
        std::array<Camera, 4> before = cameras();
        wheel(placeOf(ViewSlot::front).center(), 240);
        QVERIFY(views().camera(ViewSlot::front).distance < 0.8 * before[1].distance);
        for (const ViewSlot slot : {ViewSlot::free, ViewSlot::top, ViewSlot::right}) // free cameras
            QVERIFY(isSame(views().camera(slot), before[index(slot)]));
        QCOMPARE(views().activeSlot(), ViewSlot::free); // a wheel chooses nothing

        press(Qt::Key_F5, Qt::ShiftModifier);
        QVERIFY(action("linkedViews")->isChecked());
        verifyLinked();
        before = cameras();
        wheel(placeOf(ViewSlot::top).center() + QPoint(40, 20), 240);
        verifyLinked();
        QVERIFY(view().camera().distance < 0.8 * before[0].distance);
        before = cameras();
        const QPoint start = placeOf(ViewSlot::front).center();
        mousePress(Qt::MiddleButton, start, Qt::ShiftModifier);
        mouseMove(start + QPoint(40, 30), Qt::ShiftModifier);
        mouseRelease(Qt::MiddleButton, start + QPoint(40, 30));
        verifyLinked();
        QVERIFY((view().camera().target - before[1].target).norm() > 0);
        for (const ViewSlot slot : allViewSlots) {
            QCOMPARE(views().camera(slot).yaw, before[index(slot)].yaw);
            QCOMPARE(views().camera(slot).pitch, before[index(slot)].pitch);
        }
        before = cameras();
        mousePress(Qt::MiddleButton, start);
        mouseMove(start + QPoint(40, 30));
        mouseRelease(Qt::MiddleButton, start + QPoint(40, 30));
        QVERIFY(view().camera().yaw != before[1].yaw);
        for (const ViewSlot slot : {ViewSlot::free, ViewSlot::top, ViewSlot::right})
            QCOMPARE(views().camera(slot).yaw, before[index(slot)].yaw);
        press(Qt::Key_F); // smoothly
        rest();
        verifyLinked();
        press(Qt::Key_7); // and the wheel elsewhere does not stop it halfway
        wheel(placeOf(ViewSlot::top).center(), 120);
        rest();
        QCOMPARE(views().name(ViewSlot::front).name(), QString("Top"));
        verifyLinked();
        press(Qt::Key_F5, Qt::ShiftModifier);
        before = cameras();
        wheel(placeOf(ViewSlot::front).center(), 240);
        QVERIFY(isSame(views().camera(ViewSlot::free), before[0]));
    }

    void allViewsFollowTheSimulationAndHiddenOnesCostNothing()
    {
        openExample("bracket.step");
        press(Qt::Key_F4, Qt::ShiftModifier);
        press(Qt::Key_B);
        QTRY_COMPARE(snapshot().tools.size(), std::size_t{1});
        document().post(SetManipulatorMotion{0, DriveAt{Vec3(0, 0, -0.05)}});
        drawn();
        std::array<QImage, 4> before;
        std::array<std::size_t, 4> drawings{};
        for (const ViewSlot slot : {ViewSlot::front, ViewSlot::top, ViewSlot::right}) {
            before[index(slot)] = views().sideView(slot)->grabFramebuffer();
            drawings[index(slot)] = views().sideView(slot)->drawings();
        }
        press(Qt::Key_Space);
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().time > 0.4, patience);
        bothThemes("simulating");
        qInfo("drawing takes %.1f ms in the active view, %.1f ms in one beside it", 1e3 * view().renderSeconds(),
              1e3 * views().sideView(ViewSlot::top)->renderSeconds());
        for (const ViewSlot slot : {ViewSlot::front, ViewSlot::top, ViewSlot::right}) {
            QTRY_VERIFY_WITH_TIMEOUT(views().sideView(slot)->drawings() > drawings[index(slot)] + 3, patience);
            QVERIFY(views().sideView(slot)->grabFramebuffer() != before[index(slot)]);
        }
        press(Qt::Key_V);
        SideView* hidden = views().sideView(ViewSlot::front);
        QVERIFY(!hidden->isVisible());
        drawn();
        const std::size_t count = hidden->drawings();
        const double then = snapshot().time;
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().time > then + 0.1, patience);
        QCOMPARE(hidden->drawings(), count);
        press(Qt::Key_Space);
        QTRY_VERIFY(!snapshot().playing && document().isSettled());
        press(Qt::Key_V);
        QTRY_VERIFY(hidden->drawings() > count && !hidden->isStale());
        // They show the same moment: the tool is where the document has it.
        const auto seen = hidden->widgetPosition(snapshot().tools[0].pose.position);
        mouseMove(placeOf(ViewSlot::front).topLeft() + seen->toPoint());
        QCOMPARE(view().marks().hoveredTool, std::optional<ToolId>(snapshot().tools[0].id));
        QTRY_VERIFY(hidden->findChild<QWidget*>("forceLabel0") != nullptr);
    }

    void sectionAndColorsAreInAllViews()
    {
        openExample("bracket.step");
        m_window->banner().hide(); // that the filling is coarse takes room
        action("grid")->trigger();
        press(Qt::Key_F2, Qt::ShiftModifier);
        drawn();
        SideView& front = *views().sideView(ViewSlot::front);
        const QImage plain = front.grabFramebuffer();
        action("color-displacement")->trigger();
        QTRY_VERIFY(view().scale());
        QTRY_VERIFY(front.findChild<ColorLegend*>()->isVisible());
        QTRY_COMPARE(front.findChild<ColorLegend*>()->text().title, QString("Displacement [mm]"));
        const QImage colored = front.grabFramebuffer();
        const QPoint place = seenFace(ViewSlot::front);
        QVERIFY(colored.pixelColor(place) != plain.pixelColor(place));
        press(Qt::Key_S, Qt::ShiftModifier); // what is beyond the middle in x is cut off
        QTRY_VERIFY(front.grabFramebuffer() != colored);
        const Box box = document().content().box;
        const QImage cut = front.grabFramebuffer();
        const QRect seen = materialIn(plain);
        const QRect left = materialIn(cut);
        QVERIFY2(left.width() < 0.7 * seen.width(),
                 qPrintable(QString("%1 of %2").arg(left.width()).arg(seen.width())));
        bothThemes("section");
        press(Qt::Key_F4, Qt::ShiftModifier);
        press(Qt::Key_V, Qt::ShiftModifier); // before and after
        rest();
        for (const ViewSlot slot : {ViewSlot::front, ViewSlot::top, ViewSlot::right})
            QTRY_VERIFY_WITH_TIMEOUT(views().sideView(slot)->findChild<QWidget*>("dividerHandle")->isVisible(),
                                     patience);
        auto* line = views().sideView(ViewSlot::top)->findChild<QWidget*>("dividerHandle");
        const QPoint middle = line->mapTo(m_window.get(), line->rect().center());
        drag(middle, middle - QPoint(line->parentWidget()->width() / 4, 0)); // in any of them
        QVERIFY(std::abs(*view().options().divider - 0.25) < 0.02);
        QVERIFY(views().activeSlot() != ViewSlot::top);
        auto* legend = view().findChild<ColorLegend*>(); // leaves the cube alone, and is the only one in low views
        QVERIFY(legend->isVisible() && legend->y() > 110);
        QTRY_VERIFY_WITH_TIMEOUT(!front.findChild<ColorLegend*>()->isVisible(), patience);
        bothThemes("all");
    }

    void theNextPartIsFittedInAllViews()
    {
        openExample("bracket.step");
        press(Qt::Key_F4, Qt::ShiftModifier);
        drawn();
        openExample("bar.step");
        QTRY_VERIFY(!document().isEmpty());
        const Box box = document().content().box;
        for (const ViewSlot slot : {ViewSlot::front, ViewSlot::top, ViewSlot::right}) {
            const SideView& side = *views().sideView(slot);
            for (const Vec3& corner : {Vec3(box.min()), Vec3(box.max())})
                QVERIFY(QRectF(side.rect()).contains(*side.widgetPosition(corner)));
            QVERIFY((views().camera(slot).target - box.center()).norm() < 1e-9);
        }
        m_window->open(QStringList(example("bracket.step"))); // while they are hidden
        press(Qt::Key_V);
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning(), patience);
        press(Qt::Key_V);
        drawn();
        for (const ViewSlot slot : {ViewSlot::front, ViewSlot::top, ViewSlot::right})
            QVERIFY((views().camera(slot).target - document().content().box.center()).norm() < 1e-9);
        QVERIFY(!materialIn(views().sideView(ViewSlot::top)->grabFramebuffer()).isEmpty());
    }

    /// Also beside a legend, which takes some of its room.
    void whatShowsAllOfThePartGoesOnToDoSo()
    {
        openExample("plate.step");
        action("color-displacement")->trigger();
        QTRY_VERIFY(view().findChild<ColorLegend*>()->isVisible());
        press(Qt::Key_F2, Qt::ShiftModifier);
        press(Qt::Key_1, Qt::KeypadModifier); // as wide as the view
        press(Qt::Key_F);
        rest();
        const double before = view().camera().viewHeight();
        m_window->resize(1000, 800);
        QTRY_COMPARE(m_window->width(), 1000);
        drawn();
        const double after = view().camera().viewHeight();
        QVERIFY(after > 1.1 * before);
        press(Qt::Key_F);
        rest();
        QVERIFY(std::abs(view().camera().viewHeight() / after - 1) < 1e-3);
    }

    void thePastIsSeenInAllViews()
    {
        openExample("bracket.step");
        press(Qt::Key_F4, Qt::ShiftModifier);
        press(Qt::Key_B);
        QTRY_COMPARE(snapshot().tools.size(), std::size_t{1});
        document().post(SetManipulatorMotion{0, DriveAt{Vec3(0, 0, -0.05)}});
        press(Qt::Key_Space);
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().time > 0.4, patience);
        press(Qt::Key_Space);
        QTRY_VERIFY(!snapshot().playing && document().isSettled());
        rest();
        SideView& front = *views().sideView(ViewSlot::front);
        const QImage present = front.grabFramebuffer();
        auto* axis = find<TimelineAxis>("timelineAxis");
        QTRY_VERIFY(axis->timeline().pictures.size() > 3);
        const double early = 0.2 * axis->timeline().end;
        QTest::mouseClick(axis, Qt::LeftButton, {}, axis->placeOf(early));
        QTRY_VERIFY(view().isLookingBack());
        QTRY_VERIFY(front.grabFramebuffer() != present);
        const QLabel* caption = find<QLabel>("pastCaption"); // not under the name
        QVERIFY(caption->isVisible());
        const QRect name(view().mapFromGlobal(views().name(ViewSlot::free).mapToGlobal(QPoint())),
                         views().name(ViewSlot::free).size());
        QVERIFY(!caption->geometry().intersects(name));
        picture("viewports-past");
        // Another view becomes the active one, and it is still the past that is seen.
        press(Qt::Key_Tab, Qt::ControlModifier);
        QVERIFY(view().isLookingBack() && caption->isVisible());
        press(Qt::Key_Escape);
        QTRY_VERIFY(!view().isLookingBack());
        action("recordPictures")->trigger(); // of the active one, and says so
        QTRY_VERIFY(find<QDialog>("recordDialog") != nullptr);
        QVERIFY(find<QLabel>("recordView")->text().endsWith(": " + views().name(views().activeSlot()).name()));
        picture("viewports-record");
        find<QDialog>("recordDialog")->reject();
    }
};

int main(int argc, char** argv)
{
    prepareGraphics();
    QApplication application(argc, argv);
    WindowViewContentsTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "window_view_contents_test.moc"
