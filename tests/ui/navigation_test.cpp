#include "ui/viewport/navigation.h"

#include <QNativeGestureEvent>
#include <QPointingDevice>
#include <QWheelEvent>
#include <QtTest>

#include <set>

using namespace knead;

namespace {

constexpr WindowSize window{800, 600};

/// Of the middle of the window.
QWheelEvent wheel(const QPoint& pixels, const QPoint& turned, Qt::KeyboardModifiers modifiers, Qt::ScrollPhase phase)
{
    return {QPointF(400, 300), QPointF(400, 300), pixels, turned, Qt::NoButton, modifiers, phase, false};
}

} // namespace

class NavigationTest : public QObject {
    Q_OBJECT
private slots:
    void everyPresetOrbitsPansAndZooms()
    {
        for (const NavigationPreset& preset : navigationPresets()) {
            std::set<NavigationMotion> motions;
            for (const NavigationGesture& gesture : preset.gestures) {
                QCOMPARE(preset.motion(gesture.buttons, gesture.modifiers), std::optional(gesture.motion));
                QVERIFY(preset.uses(gesture.buttons));
                motions.insert(gesture.motion);
            }
            QVERIFY2(motions.contains(NavigationMotion::orbit), preset.name);
            QVERIFY2(motions.contains(NavigationMotion::pan), preset.name);
            const QWheelEvent notch = wheel({}, {0, 120}, {}, Qt::NoScrollPhase);
            QVERIFY2(cameraAfterScroll({}, preset, notch, window).distance < Camera().distance, preset.name);
            QVERIFY(!preset.nameOf(NavigationMotion::orbit).isEmpty());
            QVERIFY(preset.nameOf(NavigationMotion::orbit) != preset.nameOf(NavigationMotion::pan));
        }
    }

    void noTwoMotionsShareAGesture()
    {
        std::set<QString> names;
        for (const NavigationPreset& preset : navigationPresets()) {
            QVERIFY2(names.insert(preset.name).second, preset.name);
            std::set<std::pair<int, int>> gestures;
            for (const NavigationGesture& gesture : preset.gestures)
                QVERIFY2(gestures.insert({gesture.buttons.toInt(), gesture.modifiers.toInt()}).second, preset.name);
        }
    }

    void theLeftButtonAloneIsForTheMaterial()
    {
        for (const NavigationPreset& preset : navigationPresets()) {
            QVERIFY2(!preset.uses(Qt::LeftButton), preset.name);
            for (const Qt::KeyboardModifiers keys :
                 {Qt::KeyboardModifiers(Qt::NoModifier), Qt::KeyboardModifiers(Qt::ShiftModifier),
                  Qt::KeyboardModifiers(Qt::ControlModifier), Qt::ShiftModifier | Qt::ControlModifier})
                QVERIFY2(!preset.motion(Qt::LeftButton, keys), preset.name);
        }
    }

    void programsAreAsPeopleKnowThem()
    {
        using enum NavigationMotion;
        struct Row {
            const char* preset;
            Qt::MouseButtons held;
            Qt::KeyboardModifiers keys;
            std::optional<NavigationMotion> motion;
        };
        const Row rows[] = {
            {"knead", Qt::MiddleButton, Qt::NoModifier, orbit},
            {"knead", Qt::MiddleButton, Qt::ShiftModifier, pan},
            {"knead", Qt::MiddleButton, Qt::ControlModifier, pan},
            {"knead", Qt::MiddleButton, Qt::AltModifier, orbit},                 // Alt is the desktop's
            {"knead", Qt::LeftButton | Qt::MiddleButton, Qt::NoModifier, orbit}, // the left one works the material
            {"knead", Qt::RightButton, Qt::NoModifier, {}},
            {"blender", Qt::MiddleButton, Qt::ControlModifier, zoom},
            {"freecad", Qt::MiddleButton, Qt::NoModifier, pan},
            {"freecad", Qt::LeftButton | Qt::MiddleButton, Qt::NoModifier, orbit},
            {"freecad", Qt::RightButton, Qt::ShiftModifier, orbit},
            {"freecad", Qt::RightButton, Qt::NoModifier, {}},
            {"fusion", Qt::MiddleButton, Qt::ShiftModifier, orbit},
            {"fusion", Qt::MiddleButton, Qt::NoModifier, pan},
            {"onshape", Qt::RightButton, Qt::NoModifier, orbit},
            {"onshape", Qt::RightButton, Qt::ControlModifier, pan},
            {"solidworks", Qt::MiddleButton, Qt::ControlModifier, pan},
            {"solidworks", Qt::MiddleButton, Qt::ShiftModifier, zoom},
            {"twoButtons", Qt::RightButton, Qt::ControlModifier, zoom},
        };
        for (const Row& row : rows)
            QVERIFY2(navigationPreset(row.preset).motion(row.held, row.keys) == row.motion, row.preset);
        QCOMPARE(navigationPreset("of no program").name, "knead");
    }

    void theHintSaysWhatToHold()
    {
        QCOMPARE(navigationPreset("knead").nameOf(NavigationMotion::orbit), QString("Middle"));
        QCOMPARE(navigationPreset("knead").nameOf(NavigationMotion::pan), QString("Shift+middle"));
        QCOMPARE(navigationPreset("freecad").nameOf(NavigationMotion::orbit), QString("Middle+left"));
        QCOMPARE(navigationPreset("solidworks").nameOf(NavigationMotion::pan), QString("Ctrl+middle"));
        QCOMPARE(navigationPreset("twoButtons").nameOf(NavigationMotion::orbit), QString("Right"));
    }

    void aDragUpwardsComesNearerToWhereItBegan()
    {
        const Camera before;
        const Pixel start{600, 200};
        const Ray ray = before.ray(start, window);
        const Vec3 place = ray.onPlane(before.target, before.towardsEye());
        const Camera after = cameraAfterDrag(before, NavigationMotion::zoom, {5, -60}, start, window);
        QVERIFY(after.distance < 0.8 * before.distance);
        const std::optional<Pixel> seen = after.project(place, window);
        QVERIFY(seen && std::hypot(seen->x - start.x, seen->y - start.y) < 1e-6);
    }

    void twoFingersPanWhereTheyAreAskedTo()
    {
        const QWheelEvent fingers = wheel({30, -20}, {60, -40}, {}, Qt::ScrollUpdate);
        const Camera before;
        const Camera panned = cameraAfterScroll(before, navigationPreset("twoButtons"), fingers, window);
        QCOMPARE(panned.distance, before.distance);
        const std::optional<Pixel> seen = panned.project(before.target, window);
        QVERIFY(seen && std::hypot(seen->x - 430, seen->y - 280) < 1e-6);
        const QWheelEvent withCtrl = wheel({0, 30}, {0, 60}, Qt::ControlModifier, Qt::ScrollUpdate);
        QVERIFY(cameraAfterScroll(before, navigationPreset("twoButtons"), withCtrl, window).distance < before.distance);
        const Camera zoomed = cameraAfterScroll(before, navigationPreset("knead"), fingers, window);
        QVERIFY(zoomed.distance > before.distance);
    }

    void aPinchZoomsToWhereItIs()
    {
        const Camera before;
        for (const double value : {0.25, -0.2, -5.0}) {
            const QNativeGestureEvent pinch(Qt::ZoomNativeGesture, QPointingDevice::primaryPointingDevice(), 2,
                                            QPointF(600, 200), QPointF(600, 200), QPointF(600, 200), value, {});
            const Camera after = cameraAfterPinch(before, pinch, {600, 200}, window);
            QVERIFY((after.distance < before.distance) == (value > 0));
            QVERIFY(after.distance <= 10.001 * before.distance);
        }
    }
};

QTEST_MAIN(NavigationTest)
#include "navigation_test.moc"
