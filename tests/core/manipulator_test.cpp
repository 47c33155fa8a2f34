#include "core/mechanics/manipulator.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <random>

using namespace knead;

class ManipulatorTest : public QObject {
    Q_OBJECT

private slots:
    void surfaceDistanceOfABox()
    {
        const Vec3 size(2, 4, 6);
        QCOMPARE(boxSurface(size, {3, 0, 0}).distance, 2.0);
        QCOMPARE(boxSurface(size, {0, 0, -5}).normal, Vec3(0, 0, -1));
        QCOMPARE(boxSurface(size, {4, 6, 0}).distance, 5.0); // edge: 3-4-5
        QVERIFY((boxSurface(size, {4, 6, 0}).normal - Vec3(0.6, 0.8, 0)).norm() < 1e-12);
        QCOMPARE(boxSurface(size, {0.5, 0, 0}).distance, -0.5);
        QCOMPARE(boxSurface(size, {0.5, 0, 0}).normal, Vec3(1, 0, 0));
    }

    void movingAlongTheNormalChangesTheDistanceAtUnitRate()
    {
        std::mt19937 random(3);
        std::uniform_real_distribution<double> value(-4, 4);
        const Vec3 size(2, 3, 1);
        for (int i = 0; i < 200; ++i) {
            const Vec3 point(value(random), value(random), value(random));
            const SurfacePoint here = boxSurface(size, point);
            const SurfacePoint there = boxSurface(size, point + 1e-3 * here.normal);
            QVERIFY(std::abs(there.distance - here.distance - 1e-3) < 1e-9);
        }
    }

    void goesToItsTargetAtTheSpeedLimit()
    {
        Manipulator tool;
        tool.speedLimit = 2;
        tool.motion = GoTo{{Vec3(1, 0, 0), Quaternion::Identity()}};
        tool.pose = advance(tool, 0, 0.1);
        QVERIFY((tool.pose.position - Vec3(0.2, 0, 0)).norm() < 1e-12);
        for (int i = 0; i < 10; ++i)
            tool.pose = advance(tool, 0, 0.1);
        QCOMPARE(tool.pose.position, Vec3(1, 0, 0));
    }

    void driveObeysTheSpeedLimit()
    {
        Manipulator tool;
        tool.speedLimit = 1;
        tool.motion = DriveAt{{0, 0, -5}, Vec3::Zero()};
        QVERIFY((advance(tool, 0, 0.5).position - Vec3(0, 0, -0.5)).norm() < 1e-12);
    }

    void yieldsBeyondItsForceLimit()
    {
        Manipulator tool;
        tool.speedLimit = 1;
        const Pose lower{Vec3(0, 0, -0.05), Quaternion::Identity()};
        QCOMPARE(yieldTo({0, 0, 1e9}, tool, lower, 0.1).position, lower.position); // no limit
        tool.forceLimit = 10;
        QCOMPARE(yieldTo({0, 0, 9}, tool, lower, 0.1).position, lower.position);
        QCOMPARE(yieldTo({0, 0, 11}, tool, lower, 0.1).position, tool.pose.position);
        const auto share = [&](double force) { // of the way that a tool goes that may go back
            return (yieldTo({0, 0, force}, tool, lower, 0.1, true).position.z() - tool.pose.position.z()) /
                   (lower.position.z() - tool.pose.position.z());
        };
        QCOMPARE(share(9.4), 1.0);
        QVERIFY(std::abs(share(9.75) - 0.5) < 1e-9 && std::abs(share(10)) < 1e-9);
        QVERIFY(std::abs(share(10.25) + 0.5) < 1e-9 && std::abs(share(20) + 1) < 1e-9);
        QCOMPARE(yieldTo({0, 0, -11}, tool, lower, 0.1).position, lower.position); // with the force
        // What it missed while it stalled it makes up at the speed limit.
        QVERIFY((yieldTo({0, 0, 0}, tool, {Vec3(0, 0, -1), Quaternion::Identity()}, 0.1).position - Vec3(0, 0, -0.1))
                    .norm() < 1e-12);
    }

    void keyFramesAreJoinedByStraightLines()
    {
        Manipulator tool;
        const Quaternion quarter(Eigen::AngleAxisd(std::acos(0.0), Vec3::UnitZ()));
        tool.motion = FollowKeyFrames{{{1, {Vec3(0, 0, 0), Quaternion::Identity()}}, {3, {Vec3(4, 0, 0), quarter}}}};
        QCOMPARE(advance(tool, 0, 0.5).position, Vec3(0, 0, 0));
        const Pose middle = advance(tool, 1.5, 0.5);
        QVERIFY((middle.position - Vec3(2, 0, 0)).norm() < 1e-12);
        QVERIFY(std::abs(middle.rotation.angularDistance(Quaternion::Identity()) - std::acos(0.0) / 2) < 1e-12);
        QCOMPARE(advance(tool, 9, 0.5).position, Vec3(4, 0, 0));
    }

    void hostileNumbersGetASentence()
    {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(manipulatorProblems(Manipulator{.name = "block"}).empty());
        for (const Manipulator& bad :
             {Manipulator{.size = {0, 1, 1}}, Manipulator{.size = {nan, 1, 1}}, Manipulator{.size = {1e30, 1, 1}},
              Manipulator{.pose = {Vec3(nan, 0, 0), Quaternion::Identity()}}, Manipulator{.friction = -1},
              Manipulator{.friction = nan}, Manipulator{.speedLimit = 0}, Manipulator{.speedLimit = nan},
              Manipulator{.forceLimit = 0}, Manipulator{.forceLimit = nan}, Manipulator{.motion = FollowKeyFrames{}},
              Manipulator{.motion = DriveAt{Vec3(nan, 0, 0)}},
              Manipulator{.motion = FollowKeyFrames{{{1, {}}, {1, {}}}}},
              Manipulator{.motion = GoTo{{Vec3(0, nan, 0)}}}})
            QCOMPARE(manipulatorProblems(bad).size(), std::size_t{1});
    }
};

QTEST_GUILESS_MAIN(ManipulatorTest)
#include "manipulator_test.moc"
