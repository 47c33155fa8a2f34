#include "support/scenes.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace knead;

namespace {

constexpr double spacing = 2e-3; // [m]
constexpr double radius = 5e-3;  // of the tool [m]
constexpr double way = 8e-3;     // that it is moved over the material [m]

Manipulator tool(ToolKind kind)
{
    Manipulator roller{.name = "roller", .kind = kind, .rollsFreely = true};
    roller.size = kind == ToolKind::ball ? Vec3(Vec3::Constant(2 * radius)) : Vec3(2 * radius, 2 * radius, 20e-3);
    return roller;
}

/// Lies across x.
Quaternion lying()
{
    return Quaternion(Eigen::AngleAxisd(0.5 * std::numbers::pi, Vec3::UnitX()));
}

/// A rubber block that is held at its foot, and a rough tool that is pressed 1 mm into it and then moved along x.
Scene rolledBlock(ToolKind kind, bool rolls, Integrator integrator)
{
    const Material rubber{
        .density = 1100, .youngsModulus = 2e5, .poissonRatio = 0.25, .dampingRatio = 0.1, .friction = 0.8};
    Scene scene;
    scene.bodies.push_back(scenes::box({14, 8, 5}, spacing, rubber));
    scene.fixtures.push_back(
        {"foot", 0, objectsInBox(*scene.bodies[0].aggregate, Box(Vec3(-1, -1, -1), Vec3(1, 1, -1.9 * spacing)))});
    scene.integrator = integrator;
    Manipulator roller = tool(kind);
    roller.rollsFreely = rolls;
    roller.friction = 0.8;
    const double top = 2.5 * spacing;
    const auto at = [&](double x, double z) { return Pose{Vec3(x, 0, top + radius + z), lying()}; };
    roller.pose = at(-way / 2, 0.2e-3);
    roller.motion = FollowKeyFrames{{{0, roller.pose}, {0.1, at(-way / 2, -1e-3)}, {0.6, at(way / 2, -1e-3)}}};
    scene.manipulators.push_back(roller);
    return scene;
}

void runTo(Simulation& simulation, double end)
{
    while (simulation.time() < end - 1e-9 && simulation.health().ok)
        simulation.step();
}

/// About y, from how it lay [rad].
double turned(const Quaternion& rotation)
{
    const Eigen::AngleAxisd turn(rotation * lying().conjugate());
    return turn.angle() * turn.axis().y();
}

} // namespace

class RollingToolTest : public QObject {
    Q_OBJECT

private slots:
    /// w = (n x v) / r.
    void whereItPressesItsSurfaceStandsStill()
    {
        Manipulator roller = tool(ToolKind::cylinder);
        roller.pose.rotation = lying();
        const Vec3 forward(0.02, 0, 0);
        for (const Vec3& force : {Vec3(0, 0, 3), Vec3(0, 2, 0.1), Vec3(0, 0, -7), Vec3(0.3, 0, 4)}) {
            const Vec3 rate = rollingRate(roller, forward, force);
            const Vec3 along = roller.pose.rotation * Vec3::UnitZ();
            QVERIFY(rate.cross(along).norm() < 1e-12);
            const Vec3 inward = -(force - force.dot(along) * along).normalized();
            const Vec3 there = forward + rate.cross(radius * inward);
            QVERIFY(std::abs(there.dot(inward.cross(along))) < 1e-12);
        }
        QVERIFY((rollingRate(roller, forward, Vec3(0, 0, 1)) - Vec3(0, 0.02 / radius, 0)).norm() < 1e-12);
        QVERIFY(rollingRate(roller, Vec3(0, 0.02, 0), Vec3(0, 0, 1)).isZero(1e-12)); // along its axis it slides
        QVERIFY(rollingRate(roller, forward, Vec3::Zero()).isZero(0));
        Manipulator ball = tool(ToolKind::ball);
        QVERIFY((rollingRate(ball, Vec3(0, 0.02, 0), Vec3(0, 0, 1)) - Vec3(-0.02 / radius, 0, 0)).norm() < 1e-12);
        for (const ToolKind kind : {ToolKind::box, ToolKind::wedge, ToolKind::plate}) {
            Manipulator other = tool(kind);
            QVERIFY(!other.rolls() && rollingRate(other, forward, Vec3(0, 0, 1)).isZero(0));
        }
        roller.rollsFreely = false;
        QVERIFY(rollingRate(roller, forward, Vec3(0, 0, 1)).isZero(0));
    }

    /// Its axis goes where its motion has it; what it has rolled stays.
    void itsMotionTurnsItsAxisOnly()
    {
        Manipulator roller = tool(ToolKind::cylinder);
        const Quaternion rolled(Eigen::AngleAxisd(0.7, Vec3::UnitZ()));
        roller.pose.rotation = rolled;
        roller.motion = GoTo{{Vec3(1e-3, 0, 0), Quaternion::Identity()}};
        QVERIFY(advance(roller, 0, 1).rotation.angularDistance(rolled) < 1e-12);
        roller.motion = GoTo{{Vec3(1e-3, 0, 0), lying()}};
        roller.speedLimit = 10;
        const Quaternion lies = advance(roller, 0, 10).rotation;
        QVERIFY((lies * Vec3::UnitZ() - lying() * Vec3::UnitZ()).norm() < 1e-12);
        QVERIFY(lies.angularDistance(lying()) > 0.6);
        Manipulator ball = tool(ToolKind::ball);
        ball.pose.rotation = rolled;
        ball.motion = GoTo{{Vec3(1e-3, 0, 0), lying()}};
        QVERIFY(advance(ball, 0, 1).rotation.angularDistance(rolled) < 1e-12);
    }

    /// A rough roller that does not turn drags the material along; one that rolls goes over it.
    void rollsOverMaterialInsteadOfDraggingIt_data()
    {
        QTest::addColumn<ToolKind>("kind");
        QTest::addColumn<Integrator>("integrator");
        QTest::newRow("roller, frames") << ToolKind::cylinder << Integrator::implicitEuler;
        QTest::newRow("roller, short steps") << ToolKind::cylinder << Integrator::semiImplicitEuler;
        QTest::newRow("ball, frames") << ToolKind::ball << Integrator::implicitEuler;
    }
    void rollsOverMaterialInsteadOfDraggingIt()
    {
        QFETCH(ToolKind, kind);
        QFETCH(Integrator, integrator);
        const auto rolled = [&](bool rolls) {
            Simulation simulation(rolledBlock(kind, rolls, integrator));
            runTo(simulation, 0.55);
            return simulation.health().ok ? simulation.snapshot()->tools[0] : ToolState{};
        };
        const ToolState sliding = rolled(false);
        const ToolState rolling = rolled(true);
        QVERIFY(sliding.force.z() > 0.05 && rolling.force.z() > 0.05);
        QVERIFY(std::abs(turned(sliding.pose.rotation)) < 1e-9);
        const double gone = (rolling.pose.position.x() + way / 2) / radius;
        QVERIFY2(std::abs(turned(rolling.pose.rotation) / gone - 1) < 0.1,
                 qPrintable(QString("%1 of %2").arg(turned(rolling.pose.rotation)).arg(gone)));
        const auto drag = [](const ToolState& tool) { return std::abs(tool.force.x()) / tool.force.z(); };
        QVERIFY2(drag(rolling) < 0.25 * drag(sliding),
                 qPrintable(QString("%1 beside %2").arg(drag(rolling)).arg(drag(sliding))));
    }

    /// To the same bits after going back, and after a reset.
    void rollsTheSameWayAgain()
    {
        Simulation simulation(rolledBlock(ToolKind::cylinder, true, Integrator::implicitEuler));
        runTo(simulation, 0.3);
        const MomentPointer moment = simulation.keepMoment();
        runTo(simulation, 0.5);
        const std::uint64_t hash = simulation.stateHash();
        const Quaternion rotation = simulation.snapshot()->tools[0].pose.rotation;
        simulation.goTo(moment);
        runTo(simulation, 0.5);
        QCOMPARE(simulation.stateHash(), hash);
        QVERIFY(simulation.snapshot()->tools[0].pose.rotation.coeffs() == rotation.coeffs());
        simulation.post(Reset{});
        simulation.step();
        QVERIFY(std::abs(turned(simulation.snapshot()->tools[0].pose.rotation)) < 1e-9);
    }

    void whetherItRollsIsAMatterOfItsForm()
    {
        Simulation simulation(rolledBlock(ToolKind::cylinder, false, Integrator::implicitEuler));
        const auto form = [](ToolKind kind, const Vec3& size) {
            return ReshapeManipulator{
                .tool = 0, .size = size, .friction = 0.8, .speedLimit = 0.5, .kind = kind, .rollsFreely = true};
        };
        simulation.post(form(ToolKind::cylinder, Vec3(2 * radius, 2 * radius, 0.02)));
        runTo(simulation, 0.4);
        const double rolled = turned(simulation.snapshot()->tools[0].pose.rotation);
        QVERIFY(rolled > 0.5);
        QVERIFY(simulation.snapshot()->tools[0].rollsFreely);
        simulation.post(form(ToolKind::box, Vec3(2 * radius, 2 * radius, 0.02)));
        runTo(simulation, 0.5);
        QVERIFY(simulation.health().ok);
    }
};

QTEST_GUILESS_MAIN(RollingToolTest)
#include "rolling_tool_test.moc"
