#include "ui/interaction/gizmo.h"
#include "ui/interaction/typed_value.h"

#include <QKeyEvent>
#include <QtTest>

#include <cmath>
#include <numbers>

using namespace knead;

namespace {

constexpr double pi = std::numbers::pi;
constexpr WindowSize window{1280, 800};

Camera sampleCamera(bool perspective)
{
    Camera camera;
    camera.target = Vec3(0.01, -0.02, 0.03);
    camera.distance = 0.4;
    camera.yaw = 0.9;
    camera.pitch = 0.5;
    camera.perspective = perspective;
    return camera;
}

Pose sampleFrame()
{
    return {Vec3(0.03, 0.01, 0.02), Quaternion(Eigen::AngleAxisd(0.4, Vec3(1, 2, 3).normalized()))};
}

double distance(const Pixel& a, const Pixel& b)
{
    return std::hypot(a.x - b.x, a.y - b.y);
}

/// Where a handle is taken.
Pixel placeOn(const Gizmo& gizmo, GizmoPart part)
{
    const int axis = axisOf(part);
    switch (motionOf(part)) {
    case GizmoMotion::move:
        return gizmo.pixelOf(0.8 * Gizmo::shaftEnd * Vec3::Unit(axis));
    case GizmoMotion::plane: {
        const double middle = (Gizmo::planeBegin + Gizmo::planeEnd) / 2;
        return gizmo.pixelOf(middle * (Vec3::Ones() - Vec3::Unit(axis)));
    }
    case GizmoMotion::turn: {
        const std::vector<Pixel> line = gizmo.ringLine(axis);
        return line[line.size() * 3 / 10];
    }
    default:
        return gizmo.middlePixel();
    }
}

QKeyEvent key(int code, const QString& text = {})
{
    return {QEvent::KeyPress, code, Qt::NoModifier, text};
}

TypedValue typed(const QString& text, int count = 1)
{
    TypedValue value;
    for (const QChar letter : text)
        value.take(letter == u'\t' ? key(Qt::Key_Tab) : key(0, letter), count);
    return value;
}

} // namespace

/// Handles: where they lie, what the mouse does to them, what is typed.
class GizmoTest : public QObject {
    Q_OBJECT
private slots:
    void cameras_data()
    {
        QTest::addColumn<bool>("perspective");
        QTest::newRow("perspective") << true;
        QTest::newRow("parallel") << false;
    }

    void everyHandleIsFoundWhereItIsDrawn_data() { cameras_data(); }
    void everyHandleIsFoundWhereItIsDrawn()
    {
        QFETCH(bool, perspective);
        const Gizmo gizmo(sampleFrame(), sampleCamera(perspective), window);
        for (const GizmoPart part : allGizmoParts)
            QCOMPARE(gizmo.partAt(placeOn(gizmo, part)), part);
        QCOMPARE(gizmo.partAt({10, 10}), GizmoPart::none);
    }

    void itIsAsLargeFarAwayAsNear()
    {
        Camera camera = sampleCamera(true);
        camera.yaw = -pi / 2; // from the front: x lies across
        camera.pitch = 0;
        for (const double distanceOfEye : {0.05, 0.4, 30.0}) {
            camera.distance = distanceOfEye;
            const Gizmo gizmo({camera.target, Quaternion::Identity()}, camera, window);
            QVERIFY(std::abs(distance(gizmo.middlePixel(), gizmo.pixelOf(100 * Vec3::UnitX())) - 100) < 1e-6);
        }
    }

    void anArrowGoesAlongItsAxisUnderTheMouse_data() { cameras_data(); }
    void anArrowGoesAlongItsAxisUnderTheMouse()
    {
        QFETCH(bool, perspective);
        const Camera camera = sampleCamera(perspective);
        const Pose frame = sampleFrame();
        const Gizmo gizmo(frame, camera, window);
        for (const GizmoPart part : {GizmoPart::moveX, GizmoPart::moveY, GizmoPart::moveZ}) {
            const Vec3 axis = gizmo.axis(axisOf(part));
            const Pixel from = *camera.project(frame.position + 0.004 * axis, window);
            const Pixel to = *camera.project(frame.position + 0.0165 * axis, window);
            const GizmoAmount amount = gizmo.amount(part, from, to);
            QVERIFY(std::abs(amount.values[0] - 0.0125) < 1e-12);
            QVERIFY((gizmo.moved(frame, part, amount).position - frame.position - 0.0125 * axis).norm() < 1e-12);
        }
    }

    void aPlaneStaysUnderTheMouse_data() { cameras_data(); }
    void aPlaneStaysUnderTheMouse()
    {
        QFETCH(bool, perspective);
        const Camera camera = sampleCamera(perspective);
        const Pose frame = sampleFrame();
        const Gizmo gizmo(frame, camera, window);
        for (const GizmoPart part : {GizmoPart::planeX, GizmoPart::planeY, GizmoPart::planeZ, GizmoPart::free}) {
            const auto way = gizmo.directions(part);
            const Vec3 shift = 0.007 * way[0] - 0.004 * way[1];
            const GizmoAmount amount =
                gizmo.amount(part, gizmo.middlePixel(), *camera.project(frame.position + shift, window));
            QCOMPARE(amount.count, 2);
            QVERIFY((gizmo.moved(frame, part, amount).position - frame.position - shift).norm() < 1e-12);
        }
    }

    void aRingTurnsWithTheMouse_data() { cameras_data(); }
    void aRingTurnsWithTheMouse()
    {
        QFETCH(bool, perspective);
        const Camera camera = sampleCamera(perspective);
        const Pose frame = sampleFrame();
        const Gizmo gizmo(frame, camera, window);
        for (const GizmoPart part : {GizmoPart::turnX, GizmoPart::turnY, GizmoPart::turnZ}) {
            const Vec3 axis = gizmo.axis(axisOf(part));
            const Vec3 arm = 0.02 * gizmo.axis((axisOf(part) + 1) % 3);
            const Quaternion turn(Eigen::AngleAxisd(pi / 6, axis));
            const Pixel from = *camera.project(frame.position + arm, window);
            const Pixel to = *camera.project(frame.position + turn * arm, window);
            const GizmoAmount amount = gizmo.amount(part, from, to);
            QVERIFY(std::abs(amount.values[0] - pi / 6) < 1e-9);
            const Pose turned = gizmo.moved(frame, part, amount);
            QVERIFY(turned.rotation.angularDistance(turn * frame.rotation) < 1e-9);
            QCOMPARE(turned.position, frame.position);
        }
    }

    void turnsGoOnBeyondHalfATurn()
    {
        Camera camera = sampleCamera(false);
        camera.pitch = pi / 2; // from above
        const Gizmo gizmo({camera.target, Quaternion::Identity()}, camera, window);
        const Pixel from = gizmo.pixelOf(80 * Vec3::UnitX());
        GizmoAmount amount;
        for (int i = 1; i <= 30; ++i) {
            const double angle = i * pi / 12;
            amount = gizmo.amount(GizmoPart::turnZ, from, gizmo.pixelOf(80 * Vec3(std::cos(angle), std::sin(angle), 0)),
                                  amount);
        }
        QVERIFY(std::abs(amount.values[0] - 2.5 * pi) < 1e-9);
    }

    void aRingSeenFromItsSideTurnsAlongItself()
    {
        Camera camera = sampleCamera(false);
        camera.yaw = -pi / 2;
        camera.pitch = 0;
        const Gizmo gizmo({camera.target, Quaternion::Identity()}, camera, window);
        const Pixel from = gizmo.middlePixel();
        const GizmoAmount amount = gizmo.amount(GizmoPart::turnZ, from, {from.x + Gizmo::ring / 2, from.y});
        QVERIFY(std::abs(amount.values[0] - 0.5) < 1e-9); // the near side follows the mouse to the right
    }

    void handlesThatPointAtTheEyeAreNotOffered()
    {
        Camera camera = sampleCamera(true);
        camera.yaw = -pi / 2;
        camera.pitch = 0; // along y
        const Gizmo gizmo({camera.target, Quaternion::Identity()}, camera, window);
        QVERIFY(!gizmo.isUsable(GizmoPart::moveY));
        QVERIFY(!gizmo.isUsable(GizmoPart::planeX));
        QVERIFY(!gizmo.isUsable(GizmoPart::planeZ));
        for (const GizmoPart part : {GizmoPart::moveX, GizmoPart::moveZ, GizmoPart::planeY, GizmoPart::turnY})
            QVERIFY(gizmo.isUsable(part));
    }

    void behindTheEyeThereIsNone()
    {
        const Camera camera = sampleCamera(true);
        const Gizmo gizmo({Vec3(camera.eye() + 0.1 * camera.towardsEye()), Quaternion::Identity()}, camera, window);
        QVERIFY(!gizmo.isVisible());
        QVERIFY(!gizmo.isUsable(GizmoPart::free));
        QCOMPARE(gizmo.partAt({640, 400}), GizmoPart::none);
    }

    void amountsSnapToWholeSteps()
    {
        const GizmoAmount amount = snapped({{0.0126, -0.0034}, 2}, 0.005);
        QVERIFY(std::abs(amount.values[0] - 0.015) < 1e-15);
        QVERIFY(std::abs(amount.values[1] + 0.005) < 1e-15);
    }

    void whatIsTypedTakesThePlaceOfTheMouse()
    {
        const GizmoAmount mouse{{0.002, 0}, 1};
        const auto length = [&](const char* text) {
            return typed(QString::fromUtf8(text)).applied(mouse, Quantity::Length);
        };
        QCOMPARE(length("")->values[0], 0.002);
        QCOMPARE(length("12.5")->values[0], 0.0125);
        QCOMPARE(length("-3,5 mm")->values[0], -0.0035);
        QCOMPARE(length("2cm")->values[0], 0.02);
        QVERIFY(!length("-").has_value());
        QVERIFY(!length("12 kg").has_value());
        QCOMPARE(typed("45").applied(mouse, Quantity::Angle)->values[0], pi / 4);
        QCOMPARE(typed("1 rad").applied(mouse, Quantity::Angle)->values[0], 1.0);
        QVERIFY(TypedValue::belongs(key(Qt::Key_Backspace), false)); // else one too many resets the simulation
        TypedValue corrected = typed("129");
        QVERIFY(corrected.take(key(Qt::Key_Backspace), 1));
        QCOMPARE(corrected.applied(mouse, Quantity::Length)->values[0], 0.012);
    }

    void tabGoesToTheSecondNumber()
    {
        const GizmoAmount amount = *typed("3\t-4", 2).applied({{}, 2}, Quantity::Length);
        QCOMPARE(amount.values[0], 0.003);
        QCOMPARE(amount.values[1], -0.004);
    }

    void keysOfNoNumberGoOnToOthers()
    {
        TypedValue value;
        for (const auto& [code, text] : {std::pair(Qt::Key_B, "b"), std::pair(Qt::Key_Space, " ")})
            QVERIFY(!value.take(key(code, text), 1));
        QVERIFY(value.isEmpty());
    }
};

QTEST_GUILESS_MAIN(GizmoTest)
#include "gizmo_test.moc"
