#include "core/session/pull_spring.h"
#include "ui/document/force_record.h"
#include "ui/interaction/key_bindings.h"
#include "ui/interaction/space_hand.h"
#include "ui/units.h"

#include <QtTest>

#include <cmath>
#include <deque>
#include <numbers>
#include <set>

using namespace knead;

namespace {

/// The way of a patch on an elastic support that is looked at now and then, and late, as from the window.
double settledPatch(const PullSpring& spring, double support, double hand, double pace, int late)
{
    double patch = 0;
    std::deque<double> seen(static_cast<std::size_t>(late) + 1, 0.0);
    for (double time = 0; time < 10; time += pace) {
        seen.push_back(patch);
        seen.pop_front();
        const double then = seen.front();
        const Vec3 material(-support * then, 0, 0);
        patch += pace * pullVelocity(spring, Vec3(hand - then, 0, 0), material, 1).x();
    }
    return patch;
}

} // namespace

/// What hands do, without a window.
class HandsTest : public QObject {
    Q_OBJECT
private slots:
    void thePatchComesToRestWhereSpringAndMaterialAreInBalance()
    {
        const Material rubber{.youngsModulus = 1e6};
        const PullSpring spring = springFor(rubber, 0.005, {.limit = 1e9});
        const double stiffest = 2 * rubber.youngsModulus * spring.radius;
        for (const double support : {0.0, 0.01 * stiffest, stiffest})
            for (const double pace : {0.016, 0.1}) {
                const double hand = 0.01;
                const double balance = spring.stiffness * hand / (spring.stiffness + support);
                QVERIFY2(std::abs(settledPatch(spring, support, hand, pace, pace < 0.05 ? 3 : 0) - balance) <
                             1e-3 * hand,
                         qPrintable(QString("support %1 N/m, every %2 s").arg(support).arg(pace)));
            }
    }

    void theHandPullsNoHarderThanItsLimit()
    {
        const PullSpring spring = springFor({.youngsModulus = 1e6}, 0.005, {.stiffness = 2000, .limit = 3});
        QCOMPARE(springForce(spring, Vec3(0.001, 0, 0)), Vec3(2, 0, 0));
        QVERIFY((springForce(spring, Vec3(0, 0.5, 0)) - Vec3(0, 3, 0)).norm() < 1e-12);
        QVERIFY(pullVelocity(spring, Vec3(0, 0.5, 0), Vec3(0, -3, 0), 1).norm() < 1e-12);
        QVERIFY(pullVelocity(spring, Vec3(0, 0.5, 0), Vec3(0, 1e9, 0), 0.2).norm() <= 0.2 + 1e-12);
    }

    void byItselfTheSpringSuitsTheMaterial()
    {
        const PullSpring clay = springFor({.youngsModulus = 1e6, .yieldStress = 1e4}, 0.005);
        const PullSpring steel = springFor({.youngsModulus = 2e11}, 0.005);
        QVERIFY(steel.stiffness / clay.stiffness > 1e5);
        QVERIFY(clay.limit < 1e4 * 10 * std::numbers::pi * 0.005 * 0.005); // a few yield stresses
    }

    void noKeyDrivesTwoTools()
    {
        std::set<int> all;
        for (const KeyBindings& keys : keyBindings())
            for (const int key : keys.all()) {
                QVERIFY(all.insert(key).second);
                QVERIFY(!keyName(key).isEmpty());
            }
        QCOMPARE(boundKey(Qt::Key_A)->tool, std::size_t{1});
        QCOMPARE(boundKey(Qt::Key_A)->arrow, static_cast<int>(Qt::Key_Left));
        QVERIFY(!boundKey(Qt::Key_Space));
    }

    void theSceneFollowsTheCapOfA3DMouse()
    {
        Camera camera;
        camera.distance = 0.5;
        camera.pitch = 0.3;
        const WindowSize window{800, 600};
        const Vec3 place = camera.target;
        const auto seen = [&](const SpaceMotion& motion) { return *movedBy(camera, motion, 1).project(place, window); };
        QVERIFY(seen({.push = Vec3(1, 0, 0), .seconds = 0.05}).x > 401);
        QVERIFY(seen({.push = Vec3(0, 1, 0), .seconds = 0.05}).y < 299);
        QVERIFY(movedBy(camera, {.push = Vec3(0, 0, 1), .seconds = 0.05}, 1).distance < camera.distance);
        // A point on the near side goes where a turned cap takes it.
        const Vec3 near = camera.target + 0.1 * camera.towardsEye();
        const auto nearSeen = [&](const Vec3& turn) {
            return *movedBy(camera, {.turn = turn, .seconds = 0.05}, 1).project(near, window);
        };
        QVERIFY(nearSeen(Vec3(0, 1, 0)).x > 401);
        QVERIFY(nearSeen(Vec3(1, 0, 0)).y > 301);
        // What comes after a pause is no leap.
        const Camera late = movedBy(camera, {.push = Vec3(1, 0, 0), .seconds = 100}, 1);
        QVERIFY((late.target - camera.target).norm() < 0.2 * camera.viewHeight());
    }

    void a3DMouseDrivesAToolNoFasterThanItsLimit()
    {
        const ToolState tool{.size = Vec3(0.03, 0.04, 0), .speedLimit = 0.2};
        const Camera camera;
        const DriveAt half = toolMotion(tool, camera, {.push = Vec3(0.5, 0, 0)}, 1);
        QVERIFY((half.velocity - 0.1 * camera.right()).norm() < 1e-12);
        const DriveAt hard = toolMotion(tool, camera, {.push = Vec3(3, 3, 3), .turn = Vec3(0, 9, 0)}, 5);
        QVERIFY(std::abs(hard.velocity.norm() - 0.2) < 1e-12);
        QVERIFY(std::abs(hard.angularVelocity.norm() * 0.025 - 0.2) < 1e-12); // of its corners
        QVERIFY((hard.angularVelocity.normalized() - camera.up()).norm() < 1e-12);
    }

    void forcesBecomeATable()
    {
        const auto picture = [](double at, std::vector<ToolState> tools) {
            auto frame = std::make_shared<PlaybackFrame>();
            frame->tools = std::move(tools);
            frame->fixtures = {{.id = 0, .name = "Foot, left", .force = Vec3(0, 0, -1)}};
            Timeline::Picture seen;
            seen.at = at;
            seen.frame = frame;
            return seen;
        };
        Timeline line;
        line.pictures = {picture(0, {}), picture(0.5, {{.id = 3, .name = "Block 1", .force = Vec3(3, 0, 4)}})};
        line.end = 0.5;
        const ForceRecord record = forceRecordOf(line, false);
        QCOMPARE(record.curves.size(), std::size_t{2});
        QCOMPARE(QString::fromStdString(record.curves[0].name), QString("Block 1")); // tools first
        QVERIFY(!record.curves[0].forces[0].has_value());
        QCOMPARE(valueOf(*record.curves[0].forces[1], ForceComponent::magnitude), 5.0);
        QCOMPARE(valueOf(*record.curves[0].forces[1], ForceComponent::z), 4.0);
        const QStringList lines = csvOf(record).split('\n');
        QCOMPARE(lines[0], QString("time [s],Block 1 Fx [N],Block 1 Fy [N],Block 1 Fz [N],Block 1 F [N],"
                                   "\"Foot, left Fx [N]\",\"Foot, left Fy [N]\",\"Foot, left Fz [N]\","
                                   "\"Foot, left F [N]\""));
        QCOMPARE(lines[1], QString("0,,,,,0,0,-1,1"));
        QCOMPARE(lines[2], QString("0.5,3,0,4,5,0,0,-1,1"));
    }

    /// Each stroke has others, which would be lines and columns without end.
    void fingersAndGripsOfBrushesAreNoCurvesUnlessAskedFor()
    {
        auto frame = std::make_shared<PlaybackFrame>();
        frame->tools = {{.id = 0, .name = "Block 1"}, {.id = 1, .name = "Finger 12"}, {.id = 2, .name = "Finger food"}};
        frame->fixtures = {{.id = 0, .name = "Grip 1"}, {.id = 1, .name = "Other hand 1"}, {.id = 2, .name = "Grip"}};
        Timeline line;
        line.pictures.resize(1);
        line.pictures[0].frame = frame;
        const auto names = [&](bool withStrokes) {
            QStringList all;
            for (const ForceRecord::Curve& curve : forceRecordOf(line, withStrokes).curves)
                all << QString::fromStdString(curve.name);
            return all.join(", ");
        };
        QCOMPARE(names(false), QString("Block 1, Finger food, Grip"));
        QCOMPARE(names(true), QString("Block 1, Finger 12, Finger food, Grip 1, Other hand 1, Grip"));
    }

    void anglesAndStiffnessesHaveUnits()
    {
        QCOMPARE(formatQuantity(std::numbers::pi / 12, Quantity::Angle), QString("15°"));
        QCOMPARE(*parseQuantity("90 deg", Quantity::Angle), std::numbers::pi / 2);
        QCOMPARE(formatQuantity(2500, Quantity::Stiffness), QString("2.5 N/mm"));
        QCOMPARE(*parseQuantity("3 N/m", Quantity::Stiffness), 3.0);
    }
};

QTEST_GUILESS_MAIN(HandsTest)
#include "hands_test.moc"
