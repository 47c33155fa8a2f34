#include "support/views_on_test.h"
#include "ui/interaction/gizmo.h"
#include "ui/preferences/preferences.h"
#include "ui/preferences/preferences_feature.h"
#include "ui/run_window.h"

#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QtTest>

#include <cmath>

using namespace knead;

/// Several views of a part: where they lie, which of them is the active one, and what mouse and keys do in them.
class WindowViewportsTest : public QObject, ViewsOnTest {
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

    void viewsComeByKeyMenuAndPalette()
    {
        QVERIFY(!action("fourViews")->isEnabled() && !action("viewAlone")->isEnabled()); // nothing is open
        openExample("bracket.step");
        QVERIFY(action("fourViews")->isEnabled() && !action("viewAlone")->isEnabled());
        QCOMPARE(view().size(), views().size());
        QVERIFY(views().findChildren<SideView*>().isEmpty() && !views().name(ViewSlot::free).isVisible());

        press(Qt::Key_F4, Qt::ShiftModifier);
        QCOMPARE(views().arrangement(), ViewArrangement::four);
        QVERIFY(action("fourViews")->isChecked() && !action("oneView")->isChecked());
        QCOMPARE(namesShown(), QStringList({"Isometric", "Front", "Top", "Right"}));
        QCOMPARE(views().activeSlot(), ViewSlot::free);
        QCOMPARE(placeOf(ViewSlot::top).left(), placeOf(ViewSlot::front).left());
        QCOMPARE(placeOf(ViewSlot::top).bottom(), placeOf(ViewSlot::free).bottom());
        QVERIFY(placeOf(ViewSlot::top).bottom() < placeOf(ViewSlot::front).top());
        QVERIFY(placeOf(ViewSlot::front).right() < placeOf(ViewSlot::right).left());
        drawn();
        bothThemes("four");

        auto* menu = find<QMenu>("viewportsMenu");
        QVERIFY(menu->actions().contains(action("twoViews")) && menu->actions().contains(action("linkedViews")));
        menu->popup(m_window->mapToGlobal(QPoint(100, 100)));
        QTRY_VERIFY(menu->isVisible());
        QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(action("twoViews")).center());
        QCOMPARE(views().arrangement(), ViewArrangement::two);
        QCOMPARE(namesShown(), QStringList({"Isometric", "Front"}));
        QVERIFY(placeOf(ViewSlot::free).right() < placeOf(ViewSlot::front).left());
        QTRY_COMPARE(views().findChildren<SideView*>().size(), 1);
        drawn();
        const Box box = document().content().box;
        for (const Vec3& corner : {Vec3(box.min()), Vec3(box.max())}) // what was whole stays whole in another cell
            QVERIFY(QRectF(QPointF(), placeOf(ViewSlot::front).size())
                        .contains(*views().sideView(ViewSlot::front)->widgetPosition(corner)));
        bothThemes("two");

        press(Qt::Key_K, Qt::ControlModifier);
        QTRY_VERIFY(QApplication::focusWidget() != nullptr && qobject_cast<QLineEdit*>(QApplication::focusWidget()));
        QTest::keyClicks(QApplication::focusWidget(), "one view");
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
        QTRY_COMPARE(views().arrangement(), ViewArrangement::one);
        QCOMPARE(namesShown(), QStringList());
        QCOMPARE(view().size(), views().size());
        QTRY_VERIFY(views().findChildren<SideView*>().isEmpty());
    }

    void aPressMakesAViewTheActiveOneAndDoesItsWork()
    {
        openExample("bracket.step");
        closeBanner();
        press(Qt::Key_F4, Qt::ShiftModifier);
        press(Qt::Key_2); // clicks select faces
        drawn();
        const Camera front = views().camera(ViewSlot::front);
        const Camera free = views().camera(ViewSlot::free);
        QVERIFY(action("perspective")->isChecked());
        clickIn(ViewSlot::front, seenFace(ViewSlot::front));
        QCOMPARE(views().activeSlot(), ViewSlot::front);
        QCOMPARE(view().geometry(), views().cell(ViewSlot::front));
        QVERIFY(isSame(view().camera(), front) && isSame(views().camera(ViewSlot::free), free));
        QVERIFY(!action("perspective")->isChecked());
        QVERIFY(view().hasFocus());
        const Region& selected = document().selected().region();
        QCOMPARE(selected.level, Level::Face);
        QVERIFY(!selected.isEmpty());
        drawn();
        picture("viewports-selected");

        // The middle button turns at once, and the view has no name of a side any more.
        const QPoint middle = placeOf(ViewSlot::right).center();
        mousePress(Qt::MiddleButton, middle);
        mouseMove(middle + QPoint(30, 0));
        mouseMove(middle + QPoint(60, 10));
        mouseRelease(Qt::MiddleButton, middle + QPoint(60, 10));
        QCOMPARE(views().activeSlot(), ViewSlot::right);
        QCOMPARE(views().name(ViewSlot::right).name(), QString("Parallel"));
        QCOMPARE(views().name(ViewSlot::front).name(), QString("Front"));
        QVERIFY(isSame(views().camera(ViewSlot::front), front));
        const Camera turned = view().camera();
        mouseMove(middle); // the button is up
        QVERIFY(isSame(view().camera(), turned));
    }

    void standardViewsAndFitGoToTheActiveView()
    {
        openExample("bracket.step");
        press(Qt::Key_F4, Qt::ShiftModifier);
        press(Qt::Key_Tab, Qt::ControlModifier); // reading order: top, free, front, right
        QCOMPARE(views().activeSlot(), ViewSlot::front);
        const Camera free = views().camera(ViewSlot::free);
        const Camera top = views().camera(ViewSlot::top);
        press(Qt::Key_7);
        QTRY_COMPARE(views().name(ViewSlot::front).name(), QString("Top"));
        press(Qt::Key_5);
        QVERIFY(view().camera().perspective && action("perspective")->isChecked());
        QVERIFY(isSame(views().camera(ViewSlot::free), free) && isSame(views().camera(ViewSlot::top), top));
        const double far = view().camera().distance;
        wheel(placeOf(ViewSlot::front).center(), -600);
        QVERIFY(view().camera().distance > 1.5 * far);
        press(Qt::Key_F);
        QTRY_VERIFY(std::abs(view().camera().distance / far - 1) < 0.1);
        QVERIFY(isSame(views().camera(ViewSlot::free), free) && isSame(views().camera(ViewSlot::top), top));
        press(Qt::Key_Tab, Qt::ControlModifier);
        press(Qt::Key_Tab, Qt::ControlModifier);
        QCOMPARE(views().activeSlot(), ViewSlot::top);

        // The cube of a view that is not active turns that one.
        SideView& right = *views().sideView(ViewSlot::right);
        const QPoint place = placeOf(ViewSlot::right).topLeft();
        const QPoint onCube(right.width() - 50, 50);
        const Region selected = document().selected().region();
        mouseClick(place + onCube);
        QCOMPARE(views().activeSlot(), ViewSlot::right);
        QVERIFY(view().isOnCube(onCube));
        QCOMPARE(document().selected().region(), selected);
        rest(); // the side in the middle of its cube is the one that is looked at already
        QCOMPARE(views().name(ViewSlot::right).name(), QString("Right"));
    }

    /// The other buttons then are free, and the status bar says which ones to use.
    void theMouseNavigatesAsInTheProgramThatIsPreferred()
    {
        openExample("bracket.step");
        rest();
        const auto* hint = find<QLabel>("navigationHint");
        QCOMPARE(hint->text(), QString("Middle: orbit   Shift+middle: pan   Wheel: zoom"));
        Preferences preferences = m_window->features().preferences->now();
        preferences.navigation = "twoButtons";
        m_window->features().preferences->set(preferences);
        QCOMPARE(hint->text(), QString("Right: orbit   Shift+right: pan   Wheel: zoom"));
        const QPoint place = placeOf(ViewSlot::free).center();
        const auto dragged = [&](Qt::MouseButton button, Qt::KeyboardModifiers keys) {
            const Camera before = view().camera();
            mousePress(button, place, keys);
            mouseMove(place + QPoint(10, -30), keys);
            mouseRelease(button, place + QPoint(10, -30));
            return before;
        };
        const Camera turned = dragged(Qt::RightButton, {});
        QVERIFY(turned.yaw != view().camera().yaw);
        const Camera panned = dragged(Qt::RightButton, Qt::ShiftModifier);
        QVERIFY(panned.yaw == view().camera().yaw && panned.target != view().camera().target);
        const Camera zoomed = dragged(Qt::RightButton, Qt::ControlModifier);
        QVERIFY(zoomed.distance > 1.1 * view().camera().distance);
        const Camera same = dragged(Qt::MiddleButton, {});
        QVERIFY(isSame(same, view().camera()));
        preferences.navigation = "freecad"; // a second button makes turning of panning
        m_window->features().preferences->set(preferences);
        const Region selected = document().selected().region();
        const Camera before = view().camera();
        QTest::mouseMove(&view(), view().rect().center());
        const auto send = [&](QEvent::Type type, Qt::MouseButton button, Qt::MouseButtons held, const QPoint& step) {
            const QPoint at = view().rect().center() + step;
            QMouseEvent event(type, at, view().mapToGlobal(at), button, held, Qt::NoModifier);
            QApplication::sendEvent(&view(), &event);
        };
        const Qt::MouseButtons both = Qt::MiddleButton | Qt::LeftButton;
        send(QEvent::MouseButtonPress, Qt::MiddleButton, Qt::MiddleButton, {});
        send(QEvent::MouseMove, Qt::NoButton, Qt::MiddleButton, {20, 0});
        QVERIFY(view().camera().yaw == before.yaw && view().camera().target != before.target);
        send(QEvent::MouseButtonPress, Qt::LeftButton, both, {20, 0});
        send(QEvent::MouseMove, Qt::NoButton, both, {60, 0});
        QVERIFY(view().camera().yaw != before.yaw);
        send(QEvent::MouseButtonRelease, Qt::LeftButton, Qt::MiddleButton, {60, 0});
        send(QEvent::MouseButtonRelease, Qt::MiddleButton, Qt::NoButton, {60, 0});
        QCOMPARE(document().selected().region(), selected);
        const Camera after = view().camera();
        send(QEvent::MouseMove, Qt::NoButton, Qt::NoButton, {0, 0});
        QVERIFY(isSame(view().camera(), after));
    }

    void oneMoreButtonInADragChangesNoView()
    {
        openExample("bracket.step");
        press(Qt::Key_F4, Qt::ShiftModifier);
        const QPoint start = placeOf(ViewSlot::front).center();
        mousePress(Qt::MiddleButton, start);
        mouseMove(start + QPoint(20, 0));
        QCOMPARE(views().activeSlot(), ViewSlot::front);
        mousePress(Qt::LeftButton, start + QPoint(20, 0));
        QCOMPARE(views().activeSlot(), ViewSlot::front);
        mouseRelease(Qt::LeftButton, start + QPoint(20, 0));
        mouseRelease(Qt::MiddleButton, start + QPoint(20, 0));
        QCOMPARE(views().activeSlot(), ViewSlot::front);
        const Camera turned = view().camera();
        mouseMove(start + QPoint(50, 30));
        QVERIFY(isSame(view().camera(), turned));
    }

    void aDragEndsOrGoesOnWhereViewsAreLaidOutAnew()
    {
        openExample("bracket.step");
        press(Qt::Key_F4, Qt::ShiftModifier);
        drawn();
        // It began in a view that was not active: who is not seen hears of no release.
        const QPoint start = placeOf(ViewSlot::front).center();
        mousePress(Qt::MiddleButton, start);
        mouseMove(start + QPoint(20, 0));
        QVERIFY(views().camera(ViewSlot::front).yaw != views().camera(ViewSlot::top).yaw);
        press(Qt::Key_V);
        QVERIFY(views().isAlone());
        mouseRelease(Qt::MiddleButton, start + QPoint(20, 0));
        const Camera turned = view().camera();
        mouseMove(start + QPoint(60, 40));
        QVERIFY(isSame(view().camera(), turned));
        press(Qt::Key_V);
        // The active view turns on, by as much as the mouse moves.
        const double yaw = view().camera().yaw;
        mousePress(Qt::MiddleButton, start);
        mouseMove(start + QPoint(10, 0));
        const double step = view().camera().yaw - yaw;
        QVERIFY(step != 0);
        press(Qt::Key_V);
        mouseMove(start + QPoint(20, 0));
        QVERIFY(std::abs(view().camera().yaw - yaw - 2 * step) < 1e-9);
        mouseRelease(Qt::MiddleButton, start + QPoint(20, 0));
    }

    void linesBetweenViewsAreDragged()
    {
        openExample("bracket.step");
        press(Qt::Key_F4, Qt::ShiftModifier);
        const QPoint cross((placeOf(ViewSlot::front).right() + placeOf(ViewSlot::right).left()) / 2,
                           (placeOf(ViewSlot::top).bottom() + placeOf(ViewSlot::front).top()) / 2);
        const int column = placeOf(ViewSlot::front).width();
        const int row = placeOf(ViewSlot::top).height();
        const QPoint beside(cross.x(), placeOf(ViewSlot::front).center().y());
        drag(beside, beside + QPoint(60, 40));
        QVERIFY(std::abs(placeOf(ViewSlot::front).width() - (column + 60)) <= 1);
        QCOMPARE(placeOf(ViewSlot::top).height(), row); // only the upright line
        QCOMPARE(views().cursor().shape(), Qt::SplitHCursor);
        QCOMPARE(views().name(ViewSlot::front).cursor().shape(), Qt::ArrowCursor);
        drag(cross + QPoint(60, 0), cross + QPoint(-40, 30));
        QVERIFY(std::abs(placeOf(ViewSlot::front).width() - (column - 40)) <= 1);
        QVERIFY(std::abs(placeOf(ViewSlot::top).height() - (row + 30)) <= 1);
        QCOMPARE(views().sideView(ViewSlot::top)->geometry(), placeInGrid(ViewSlot::top));
        drag(cross + QPoint(-40, 30), QPoint(3, 3)); // out of the view: all stay large enough
        for (const ViewSlot slot : allViewSlots)
            QVERIFY(placeOf(slot).width() > 0.1 * views().width() && placeOf(slot).height() > 0.1 * views().height());
        QCOMPARE(views().activeSlot(), ViewSlot::free);
        const QPoint now((placeOf(ViewSlot::front).right() + placeOf(ViewSlot::right).left()) / 2,
                         (placeOf(ViewSlot::top).bottom() + placeOf(ViewSlot::front).top()) / 2);
        QTest::mouseDClick(m_window->windowHandle(), Qt::LeftButton, {}, now);
        QCOMPARE(placeOf(ViewSlot::front).width(), column);
        QCOMPARE(placeOf(ViewSlot::top).height(), row);
    }

    void aDoubleClickOnANameShowsThatViewAloneAndAllAgain()
    {
        openExample("bracket.step");
        press(Qt::Key_F4, Qt::ShiftModifier);
        drawn();
        const Camera right = views().camera(ViewSlot::right);
        doubleClick(views().name(ViewSlot::right));
        QVERIFY(views().isAlone() && action("viewAlone")->isChecked() && action("fourViews")->isChecked());
        QCOMPARE(namesShown(), QStringList({"Right"}));
        QCOMPARE(view().size(), views().size());
        QVERIFY(isSame(view().camera(), right));
        QVERIFY(!action("nextView")->isEnabled());
        drawn();
        picture("viewports-alone");
        doubleClick(views().name(ViewSlot::right));
        QVERIFY(!views().isAlone());
        QCOMPARE(namesShown().size(), 4);
        QCOMPARE(views().activeSlot(), ViewSlot::right);
        press(Qt::Key_V);
        QVERIFY(views().isAlone());
        press(Qt::Key_F1, Qt::ShiftModifier); // one view: the same, without a name
        QVERIFY(!views().isAlone() && !action("viewAlone")->isEnabled());
        QVERIFY(isSame(view().camera(), right));
        QCOMPARE(namesShown(), QStringList());
        press(Qt::Key_F2, Qt::ShiftModifier); // beside the free one
        QCOMPARE(namesShown(), QStringList({"Isometric", "Right"}));
        QCOMPARE(views().activeSlot(), ViewSlot::right);
    }

    void aToolIsDraggedInAViewThatWasNotActive()
    {
        openExample("bracket.step");
        press(Qt::Key_F4, Qt::ShiftModifier);
        press(Qt::Key_B);
        QTRY_COMPARE(snapshot().tools.size(), std::size_t{1});
        drawn();
        const Vec3 start = snapshot().tools[0].pose.position;
        const QPoint grabbed =
            placeOf(ViewSlot::front).topLeft() + views().sideView(ViewSlot::front)->widgetPosition(start)->toPoint();
        drag(grabbed + QPoint(6, 2), grabbed + QPoint(46, 2));
        QCOMPARE(views().activeSlot(), ViewSlot::front);
        QTRY_VERIFY(snapshot().tools[0].pose.position.x() > start.x() + 1e-4);
        const double perPixel = view().camera().viewHeight() / view().height();
        QTRY_VERIFY(std::abs(snapshot().tools[0].pose.position.x() - start.x() - 40 * perPixel) < 2 * perPixel);
        QVERIFY(std::abs(snapshot().tools[0].pose.position.z() - start.z()) < perPixel);
        QCOMPARE(snapshot().tools[0].pose.position.y(), start.y()); // across the line of sight only
    }

    void handlesAreGrabbedWhereTheyAreSeenOnly()
    {
        openExample("bracket.step");
        press(Qt::Key_F4, Qt::ShiftModifier);
        press(Qt::Key_B);
        QTRY_COMPARE(snapshot().tools.size(), std::size_t{1});
        drawn();
        const ToolState tool = snapshot().tools[0];
        SideView& side = *views().sideView(ViewSlot::front);
        const QPoint middle = side.widgetPosition(tool.pose.position)->toPoint();
        const Gizmo handles(tool.pose, side.camera(), side.window());
        int reach = 200;
        while (reach > 0 &&
               motionOf(handles.partAt({double(middle.x() + reach), double(middle.y())})) != GizmoMotion::move)
            --reach;
        const QPoint handle = placeOf(ViewSlot::front).topLeft() + middle + QPoint(reach, 0);
        QVERIFY(reach * side.camera().viewHeight() / side.height() > 0.5 * tool.size.x()); // beside the tool
        drag(handle, handle + QPoint(30, 0));
        QCOMPARE(views().activeSlot(), ViewSlot::front);
        seen();
        QCOMPARE(snapshot().tools[0].pose.position.x(), tool.pose.position.x());
        document().select({Selection::Kind::Tool, tool.id});
        drawn();
        drag(handle, handle + QPoint(30, 0));
        QTRY_VERIFY(snapshot().tools[0].pose.position.x() > tool.pose.position.x() + 1e-4);
    }

    void viewsAreRememberedFromStartToStart()
    {
        openExample("bracket.step");
        press(Qt::Key_F4, Qt::ShiftModifier);
        press(Qt::Key_F5, Qt::ShiftModifier);
        const QPoint line(placeOf(ViewSlot::front).right() + 3, placeOf(ViewSlot::front).center().y());
        drag(line, line + QPoint(50, 0));
        press(Qt::Key_Tab, Qt::ControlModifier);
        press(Qt::Key_1, Qt::ControlModifier);
        QTRY_COMPARE(views().name(ViewSlot::front).name(), QString("Back"));
        const int width = placeOf(ViewSlot::front).width();
        const int whole = views().width();
        m_window.reset();
        show(m_services);
        openExample("bracket.step");
        QCOMPARE(views().arrangement(), ViewArrangement::four);
        QVERIFY(action("fourViews")->isChecked() && action("linkedViews")->isChecked());
        QVERIFY(views().areLinked());
        QCOMPARE(namesShown(), QStringList({"Isometric", "Back", "Top", "Right"}));
        QVERIFY(std::abs(placeOf(ViewSlot::front).width() - width * views().width() / whole) <= 2);
        verifyLinked();
        press(Qt::Key_F1, Qt::ShiftModifier);
        m_window.reset();
        show(m_services);
        QCOMPARE(views().arrangement(), ViewArrangement::one);
    }

    void namesAreInTheLanguageSpoken()
    {
        openExample("bracket.step");
        press(Qt::Key_F4, Qt::ShiftModifier);
        Preferences chosen = readPreferences();
        chosen.language = "de";
        m_window->features().preferences->set(chosen);
        QTRY_COMPARE(namesShown(), QStringList({"Isometrisch", "Vorne", "Oben", "Rechts"}));
        QVERIFY(views().name(ViewSlot::front).toolTip().startsWith("Doppelklick"));
        for (const ViewSlot slot : allViewSlots)
            QVERIFY(views().name(slot).width() >= views().name(slot).sizeHint().width());
        picture("viewports-german");
        chosen.language = "en";
        m_window->features().preferences->set(chosen);
        QTRY_COMPARE(namesShown(), QStringList({"Isometric", "Front", "Top", "Right"}));
        ViewName& name = views().name(ViewSlot::free);
        QFont large = name.font();
        large.setPointSizeF(2 * large.pointSizeF());
        const int before = name.width();
        name.setFont(large);
        QVERIFY(name.width() > 1.5 * before);
        QCOMPARE(name.size(), name.sizeHint());
    }

    void damagedSettingsAreNoTrouble()
    {
        m_window.reset();
        QSettings settings;
        settings.setValue("views/arrangement", "seven");
        settings.setValue("views/column", "nan");
        settings.setValue("views/row", -4);
        settings.setValue("views/top", QVariantList{"inf", 1});
        settings.sync();
        show(m_services);
        openExample("bracket.step");
        QCOMPARE(views().arrangement(), ViewArrangement::one);
        press(Qt::Key_F4, Qt::ShiftModifier);
        QCOMPARE(namesShown(), QStringList({"Isometric", "Front", "Top", "Right"}));
        for (const ViewSlot slot : allViewSlots)
            QVERIFY(placeOf(slot).width() > 40 && placeOf(slot).height() > 30);
    }
};

int main(int argc, char** argv)
{
    prepareGraphics();
    QApplication application(argc, argv);
    WindowViewportsTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "window_viewports_test.moc"
