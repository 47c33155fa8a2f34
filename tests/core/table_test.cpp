// The floor as a table: what touched a sticky one holds on to it, up to its adhesion.
#include "support/thread_limit.h"

#include "core/mechanics/contact_law.h"
#include "core/simulation/moment.h"
#include "support/kneaded_clay.h"
#include "support/scenes.h"

#include <QTest>

#include <cmath>

using namespace knead;

namespace {

constexpr double spacing = 2e-3;         // [m]
constexpr double adhesion = 5e3;         // [Pa]
const Vec3 size(0.012, 0.012, 0.006);    // of a block that stands on the table
const double area = size.x() * size.y(); // of it on the table
constexpr double density = 1000;
constexpr double lifting = adhesion / (density * 0.006); // acceleration that just lifts it off [m/s^2]

Material rubber()
{
    Material material{.density = density, .youngsModulus = 1e6, .poissonRatio = 0.45, .dampingRatio = 0.1};
    material.friction = 0.4;
    return material;
}

/// A block on a table, for a moment pressed on it by its weight.
Scene onTable(Integrator integrator, double stickiness, double friction = 0.4)
{
    Scene scene;
    scene.bodies.push_back(scenes::body(shapes::box(size), spacing, rubber(), "block"));
    scene.floorHeight = -0.5 * size.z();
    scene.floorAdhesion = stickiness;
    scene.floorFriction = friction;
    scene.gravity = Vec3(0, 0, -9.81);
    scene.integrator = integrator;
    return scene;
}

void run(Simulation& simulation, double duration)
{
    const double end = simulation.time() + duration;
    while (simulation.time() < end && simulation.health().ok)
        simulation.step();
}

double heightOf(Simulation& simulation)
{
    return scenes::meanPosition(*simulation.snapshot()).z();
}

/// How high the block is after something has pulled it up.
double liftedBy(Integrator integrator, double stickiness, double acceleration)
{
    Simulation simulation(onTable(integrator, stickiness));
    run(simulation, 0.02);
    simulation.post(SetGravity{Vec3(0, 0, acceleration)});
    run(simulation, 0.05);
    const auto shot = simulation.snapshot();
    if (!shot->health.ok || shot->energy.imbalanceShare() > 0.05)
        return std::nan("");
    return heightOf(simulation);
}

} // namespace

class TableTest : public QObject {
    Q_OBJECT

private slots:
    void endsThatStickPullUpToTheirAdhesionAndPartBeyond()
    {
        const ContactParameters sticky{.stiffness = 1e4, .adhesion = 2};
        const ContactStep step{.duration = 1e-3, .stickSpeed = 1};
        const FrictionMemory touched = contactForce({.overlap = 1e-5}, sticky, step).memory;
        QVERIFY(touched.sticks);
        const ContactResult held = contactForce({.overlap = -1.5e-4, .memory = touched}, sticky, step);
        QCOMPARE(held.force().z(), -1.5);
        QVERIFY(held.memory.sticks);
        QCOMPARE(held.energy, 0.5 * 1e4 * 1.5e-4 * 1.5e-4);
        ContactStep trial = step;
        trial.isTrial = true;
        QCOMPARE(contactForce({.overlap = -3e-4, .memory = touched}, sticky, trial).force().z(), -2.0);
        const ContactResult torn = contactForce({.overlap = -3e-4, .memory = touched}, sticky, step);
        QVERIFY(torn.force().isZero(0));
        QVERIFY(torn.memory.isEmpty());
        QCOMPARE(torn.released, 0.5 * 1e4 * 2e-4 * 2e-4 + 2 * 1e-4);
        ContactParameters tacky = sticky;
        tacky.adhesionReach = 1e-3;
        QCOMPARE(contactForce({.overlap = -9e-4, .memory = touched}, tacky, step).force().z(), -2.0);
        QVERIFY(contactForce({.overlap = -1.1e-3, .memory = touched}, tacky, step).memory.isEmpty());
        // What has not touched yet does not stick.
        QVERIFY(contactForce({.overlap = -1e-5}, sticky, step).force().isZero(0));
    }

    void frictionGoesByPressureAndAdhesion()
    {
        const ContactParameters sticky{.stiffness = 1e4, .friction = 0.5, .adhesion = 2};
        const ContactStep step{.duration = 1e-3, .stickSpeed = 1};
        const ContactResult result =
            contactForce({.overlap = 1e-4, .relativeVelocity = Vec3(1, 0, 0)}, sticky, step); // pressed by 1 N
        QVERIFY(std::abs(result.friction.x() + 0.5 * (1 + 2)) < 1e-3);
    }

    void aBlockIsHeldUpToTheAdhesionTimesItsArea_data()
    {
        QTest::addColumn<Integrator>("integrator");
        QTest::newRow("explicit") << Integrator::semiImplicitEuler;
        QTest::newRow("implicit") << Integrator::implicitEuler;
    }
    void aBlockIsHeldUpToTheAdhesionTimesItsArea()
    {
        QFETCH(Integrator, integrator);
        // It is pulled suddenly, which can be twice as much as what pulls on and on.
        QVERIFY(std::abs(liftedBy(integrator, adhesion, 0.45 * lifting)) < 1e-4);
        QVERIFY(liftedBy(integrator, adhesion, 1.2 * lifting) > 0.05 * size.z());
        QVERIFY(liftedBy(integrator, 0, 0.45 * lifting) > 0.05 * size.z());
    }

    void aStickyTableHoldsWhatAPushWouldSlide()
    {
        for (const double stickiness : {0.0, adhesion}) {
            Simulation simulation(onTable(Integrator::implicitEuler, stickiness));
            run(simulation, 0.02);
            simulation.post(SetGravity{Vec3(8, 0, -9.81)}); // friction alone holds 0.4 of the weight
            run(simulation, 0.05);
            const double way = scenes::meanPosition(*simulation.snapshot()).x();
            QVERIFY2(stickiness > 0 ? way < 1e-4 : way > 1e-3, qPrintable(QString::number(way)));
        }
    }

    void whatSticksGoesOnFromAMomentToTheSameBits()
    {
        Simulation simulation(onTable(Integrator::implicitEuler, adhesion));
        run(simulation, 0.02);
        simulation.post(SetGravity{Vec3(0, 0, 0.5 * lifting)});
        run(simulation, 0.02);
        simulation.post(KeepMoment{});
        simulation.step();
        const MomentPointer kept = simulation.keepMoment();
        run(simulation, 0.02);
        const std::uint64_t hash = simulation.stateHash();
        simulation.goTo(kept);
        run(simulation, 0.02);
        QCOMPARE(simulation.stateHash(), hash);
        QVERIFY(std::abs(heightOf(simulation)) < 1e-4);
    }

    void aStickyToolPullsWhatItTouched()
    {
        for (const double stickiness : {0.0, 2e3}) {
            Scene scene = onTable(Integrator::implicitEuler, 0);
            Manipulator plate{.name = "plate", .size = Vec3(0.02, 0.02, 0.004)};
            plate.kind = ToolKind::plate;
            plate.adhesion = stickiness;
            plate.speedLimit = 0.05;
            plate.pose.position = Vec3(0, 0, 0.5 * size.z() + 0.002 + 1e-4);
            scene.manipulators.push_back(plate);
            Simulation simulation(scene);
            Pose pose = plate.pose;
            pose.position.z() -= 3e-4;
            simulation.post(SetManipulatorMotion{0, GoTo{pose}});
            run(simulation, 0.05);
            pose.position.z() += 0.005;
            simulation.post(SetManipulatorMotion{0, GoTo{pose}});
            run(simulation, 0.2);
            const double height = heightOf(simulation);
            QVERIFY2(stickiness > 0 ? height > 3e-3 : height < 1e-3, qPrintable(QString::number(height)));
        }
    }

    /// A ball is pressed into clay until 4 mm are left, and comes out again: its rim has closed over it, and pulls.
    void aLumpThatWasDentedDeeplyStaysOnAStickyTable()
    {
        const Vec3 lump(0.045, 0.036, 0.024);
        Scene scene;
        scene.bodies.push_back(scenes::body(shapes::box(lump), 3e-3, scenes::modelingClay(), "lump"));
        scene.bodies[0].surface = std::make_shared<const TriangleMesh>(shapes::box(lump));
        scene.floorHeight = -0.5 * lump.z();
        scene.floorAdhesion = 2e4;
        scene.floorFriction = 1;
        scene.gravity = Vec3(0, 0, -9.81);
        scene.integrator = Integrator::implicitEuler;
        Manipulator ball{.name = "ball", .size = Vec3::Constant(0.5 * lump.z())};
        ball.kind = ToolKind::ball;
        ball.speedLimit = 0.1;
        ball.pose.position = Vec3(0, 0, 0.75 * lump.z() + 1e-4);
        scene.manipulators.push_back(ball);
        Simulation simulation(scene);
        Pose pose = ball.pose;
        for (const double height : {-0.5 * lump.z() + 0.004 + 0.25 * lump.z(), 2 * lump.z()}) {
            pose.position.z() = height;
            simulation.post(SetManipulatorMotion{0, GoTo{pose}});
            run(simulation, 0.6);
        }
        simulation.snapshot(); // forces are means since the one before
        simulation.step();
        const auto shot = simulation.snapshot();
        QVERIFY2(shot->health.ok, shot->health.message.english().c_str());
        QVERIFY(shot->refills > 2);
        QVERIFY(shot->tools[0].force.norm() < 1e-9);
        double lowest = 1;
        for (const Vec3& place : shot->bodies[0].positions)
            lowest = std::min(lowest, place.z());
        QVERIFY2(std::abs(lowest - *scene.floorHeight) < 0.6 * 3e-3, qPrintable(QString::number(lowest)));
        QVERIFY2(std::abs(scenes::meanPosition(*shot).z()) < 2e-3,
                 qPrintable(QString::number(scenes::meanPosition(*shot).z())));
    }

    void adhesionsOutOfRangeAreRefused()
    {
        Simulation simulation(onTable(Integrator::implicitEuler, 0));
        simulation.post(SetFloor{0, 0.4, -1});
        simulation.step();
        QVERIFY(QString::fromStdString(simulation.snapshot()->notice.english()).contains("adhesion"));
        Manipulator tool{.name = "tool"};
        tool.adhesion = 1e10;
        QCOMPARE(manipulatorProblems(tool).size(), std::size_t{1});
    }
};

QTEST_MAIN(TableTest)
#include "table_test.moc"
