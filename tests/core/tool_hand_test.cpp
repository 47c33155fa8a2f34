#include "core/integration/tool_hand.h"
#include "support/scenes.h"

#include <QTest>

using namespace knead;

namespace {

constexpr double spacing = 2e-3; // [m]

/// A rubber block that is held at its foot, and a smooth ball on it whose hand wants it far inside and to the side.
Scene pressedBlock(double friction)
{
    const Material rubber{
        .density = 1100, .youngsModulus = 1e6, .poissonRatio = 0.25, .dampingRatio = 0.1, .friction = friction};
    Scene scene;
    scene.bodies.push_back(scenes::box({14, 8, 6}, spacing, rubber));
    scene.fixtures.push_back(
        {"foot", 0, objectsInBox(*scene.bodies[0].aggregate, Box(Vec3(-1, -1, -1), Vec3(1, 1, -2.9 * spacing)))});
    scene.integrator = Integrator::implicitEuler;
    Manipulator ball{.name = "ball", .size = Vec3::Constant(0.008), .friction = friction, .speedLimit = 0.1};
    ball.kind = ToolKind::ball;
    ball.pose.position = Vec3(-3 * spacing, 0, 3 * spacing + 0.0041);
    ball.forceLimit = 1;
    ball.motion = GoTo{{ball.pose.position - Vec3(0, 0, 0.02), Quaternion::Identity()}};
    scene.manipulators.push_back(ball);
    return scene;
}

void runFor(Simulation& simulation, double duration)
{
    const double end = simulation.time() + duration;
    while (simulation.time() < end - 1e-9 && simulation.health().ok)
        simulation.step();
}

} // namespace

class ToolHandTest : public QObject {
    Q_OBJECT

private slots:
    void pushesTowardsItselfAndNoHarderThanItMay()
    {
        const ToolHand hand{.goal = Vec3(1, 2, 3), .limit = 5, .stiffness = 100};
        QCOMPARE(hand.forceAt(hand.goal), Vec3(0, 0, 0));
        QVERIFY((hand.forceAt(hand.goal - Vec3(0.01, 0, 0)) - Vec3(1, 0, 0)).norm() < 1e-12);
        const Vec3 away(3, 0, 4);
        QVERIFY((hand.forceAt(hand.goal + away) + away).norm() < 1e-12); // 5 N
    }

    /// What it pushed with stays while the tool is where the hand is.
    void goesOnPushingWhereItIs()
    {
        const ToolHand hand{.goal = Vec3(1, 2, 3), .push = Vec3(0, 3, 0), .limit = 5, .stiffness = 100};
        QCOMPARE(hand.forceAt(hand.goal), Vec3(0, 3, 0));
        QVERIFY((hand.forceAt(hand.goal - Vec3(0, 0.01, 0)) - Vec3(0, 4, 0)).norm() < 1e-12);
        QVERIFY((hand.forceAt(hand.goal - Vec3(0, 1, 0)) - Vec3(0, 5, 0)).norm() < 1e-12);
        QVERIFY((hand.forceAt(hand.goal + Vec3(0, 0.03, 0))).norm() < 1e-12);
    }

    /// Below the limit, and at it across the way; along the way it is a tenth of what a spring to there would have.
    void answersAsItsForceDoes()
    {
        const ToolHand hand{.goal = Vec3(1, 2, 3), .limit = 5, .stiffness = 100};
        constexpr double step = 1e-6;
        for (const double distance : {0.01, 0.04, 0.2, 3.0}) {
            const Vec3 along = Vec3(1, -2, 2) / 3;
            const Vec3 place = hand.goal - distance * along;
            const Mat3 answer = hand.stiffnessAt(place);
            for (const Vec3& across :
                 {Vec3(Vec3(2, 1, 0).normalized()), Vec3(along.cross(Vec3(2, 1, 0)).normalized())}) {
                const Vec3 change =
                    (hand.forceAt(place - step * across) - hand.forceAt(place + step * across)) / (2 * step);
                QVERIFY((answer * across - change).norm() < 1e-6 * hand.stiffness);
            }
            const double kept = along.dot(answer * along);
            if (distance < 0.05)
                QVERIFY(std::abs(kept - hand.stiffness) < 1e-9);
            else
                QVERIFY(std::abs(kept - 0.1 * hand.limit / distance) < 1e-9);
        }
    }

    /// Held up by the material, the ball goes along it to where its hand is.
    void toolAtItsLimitFollowsItsHandSideways()
    {
        Scene scene = pressedBlock(0);
        Simulation simulation(scene);
        runFor(simulation, 0.3);
        const ToolState pressed = simulation.snapshot()->tools[0];
        QVERIFY(pressed.pose.position.z() > 3 * spacing); // far from where the hand is
        QVERIFY2(std::abs(pressed.force.norm() - 1) < 0.01, qPrintable(QString::number(pressed.force.norm())));
        Pose wanted = std::get<GoTo>(scene.manipulators[0].motion).target;
        wanted.position.x() = 3 * spacing;
        simulation.post(SetManipulatorMotion{0, GoTo{wanted}});
        double hardest = 0;
        for (int frame = 0; frame < 60; ++frame) {
            simulation.step();
            hardest = std::max(hardest, simulation.snapshot()->tools[0].force.norm());
        }
        const ToolState there = simulation.snapshot()->tools[0];
        QVERIFY(simulation.health().ok);
        QVERIFY2(std::abs(there.pose.position.x() - wanted.position.x()) < 0.1 * spacing,
                 qPrintable(QString::number(there.pose.position.x() / spacing)));
        QVERIFY2(hardest < 1.02, qPrintable(QString::number(hardest)));
        QVERIFY2(std::abs(there.force.norm() - 1) < 0.01, qPrintable(QString::number(there.force.norm())));
    }

    /// Friction is among what the hand pushes against: nothing exceeds the limit.
    void limitHoldsForFrictionToo()
    {
        Simulation simulation(pressedBlock(1));
        runFor(simulation, 0.3);
        Pose wanted{Vec3(3 * spacing, 0, 0), Quaternion::Identity()};
        simulation.post(SetManipulatorMotion{0, GoTo{wanted}});
        double hardest = 0;
        for (int frame = 0; frame < 60; ++frame) {
            simulation.step();
            hardest = std::max(hardest, simulation.snapshot()->tools[0].force.norm());
        }
        QVERIFY(simulation.health().ok);
        QVERIFY2(hardest < 1.02, qPrintable(QString::number(hardest)));
        QVERIFY2(hardest > 0.95, qPrintable(QString::number(hardest)));
    }

    /// Below its limit a tool is where it was sent.
    void toolComesToWhereItIsSent()
    {
        Scene scene = pressedBlock(0.4);
        Manipulator& ball = scene.manipulators[0];
        const double height = ball.pose.position.z() - 0.0004;
        ball.motion = GoTo{{Vec3(ball.pose.position.x(), 0, height), Quaternion::Identity()}};
        Simulation simulation(scene);
        runFor(simulation, 0.5);
        const ToolState tool = simulation.snapshot()->tools[0];
        QVERIFY(tool.force.norm() > 0.1 && tool.force.norm() < 0.9);
        QVERIFY2(std::abs(tool.pose.position.z() - height) < 1e-9,
                 qPrintable(QString::number(tool.pose.position.z() - height)));
        QVERIFY(std::abs(tool.pose.position.x() - ball.pose.position.x()) < 1e-9);
    }

    /// The tool of a weak hand goes along with a stiff block: as Coulomb has it the block stands still, or comes to the speed of the
    /// hand over v^2 / 2 a with a = (s - u) g, where the hand may push with s times the weight. In steps that are long.
    void stiffBlockOnAFloorIsPushedAsTheLimitHasIt_data()
    {
        QTest::addColumn<double>("modulus");
        QTest::addColumn<double>("share");
        for (const double modulus : {2e9, 2e11})
            for (const double share : {0.3, 0.6, 1.0, 1.5, 5.0})
                QTest::addRow("%g Pa, %g of the weight", modulus, share) << modulus << share;
    }

    void stiffBlockOnAFloorIsPushedAsTheLimitHasIt()
    {
        QFETCH(const double, modulus);
        QFETCH(const double, share);
        constexpr double friction = 0.4;
        constexpr double gap = 1e-4; // [m]
        constexpr double speed = 0.04;
        constexpr double gravity = 9.81;
        const double size = 6 * spacing;
        const double weight = 7850 * size * size * size * gravity;
        Scene scene;
        scene.bodies.push_back(
            scenes::box({6, 6, 6}, spacing,
                        {.density = 7850, .youngsModulus = modulus, .poissonRatio = 0.3, .friction = friction}));
        scene.gravity = Vec3(0, 0, -gravity);
        scene.floorHeight = -size / 2;
        scene.floorFriction = friction;
        scene.integrator = Integrator::implicitEuler;
        Manipulator pusher{.name = "pusher", .size = Vec3::Constant(0.02), .friction = 0};
        pusher.pose.position.x() = -size / 2 - 0.01 - gap;
        pusher.forceLimit = share * weight;
        pusher.motion = DriveAt{Vec3(speed, 0, 0), Vec3::Zero()};
        scene.manipulators.push_back(pusher);
        Simulation simulation(scene);
        const auto start = simulation.snapshot();
        runFor(simulation, 0.4);
        simulation.snapshot(); // forces are means since the last one
        runFor(simulation, 0.1);
        const auto end = simulation.snapshot();
        QVERIFY(simulation.health().ok);
        const double way = scenes::meanPosition(*end).x() - scenes::meanPosition(*start).x();
        const double force = -end->tools[0].force.x() / weight;
        const double lost = share > friction ? speed * speed / (2 * (share - friction) * gravity) : 0;
        const double expected = share > friction ? speed * simulation.time() - gap - lost : 0;
        const QByteArray said = QStringLiteral("%1 mm, %2 expected; %3 of the weight; %4 steps")
                                    .arg(1e3 * way)
                                    .arg(1e3 * expected)
                                    .arg(force)
                                    .arg(end->step)
                                    .toUtf8();
        QVERIFY2(std::abs(way - expected) < (share > friction ? 0.1 * spacing : 1e-3 * spacing), said.constData());
        QVERIFY2(std::abs(force / std::min(share, friction) - 1) < 0.02, said.constData());
        QVERIFY2(end->step < 150, said.constData());
    }

    /// A hand is ahead of its tool by no more than a fiftieth of a spacing, and does not lose that again with each step.
    void toolBelowItsLimitGoesWhereItsHandGoes()
    {
        for (const bool isLimited : {false, true}) {
            Scene scene = pressedBlock(0);
            Manipulator& ball = scene.manipulators[0];
            ball.forceLimit = isLimited ? 1 : std::numeric_limits<double>::infinity();
            ball.motion = DriveAt{Vec3(0, 0, -0.005), Vec3::Zero()};
            Simulation simulation(scene);
            runFor(simulation, 0.1);
            const ToolState tool = simulation.snapshot()->tools[0];
            QVERIFY(tool.force.norm() > 0.01 && tool.force.norm() < 0.9);
            const double gone = ball.pose.position.z() - tool.pose.position.z();
            QVERIFY2(std::abs(gone - 0.0005) < (isLimited ? 0.021 * spacing : 1e-12),
                     qPrintable(QString::number(gone)));
        }
    }
};

QTEST_APPLESS_MAIN(ToolHandTest)
#include "tool_hand_test.moc"
