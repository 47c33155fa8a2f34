#include "support/thread_limit.h"

#include "core/simulation/gesture.h"
#include "core/simulation/moment.h"
#include "support/scenes.h"

#include <QTest>

#include <cmath>

using namespace knead;

namespace {

constexpr double spacing = 2e-3; // [m]

Material rubber()
{
    return {.density = 1100, .youngsModulus = 1e6, .poissonRatio = 0.25, .dampingRatio = 0.1};
}

/// A block that stands on the floor, and falls a little at first.
Scene standing(const Material& material = rubber())
{
    Scene scene;
    scene.bodies.push_back(scenes::box({6, 6, 6}, spacing, material));
    scene.gravity = Vec3(0, 0, -9.81);
    scene.floorHeight = -3 * spacing - 1e-4;
    scene.integrator = Integrator::implicitEuler;
    return scene;
}

Manipulator plateAbove(double gap)
{
    Manipulator plate{.name = "plate", .size = Vec3(0.03, 0.03, 0.004)};
    plate.pose.position = Vec3(0, 0, 3 * spacing + 0.002 + gap);
    return plate;
}

void runFor(Simulation& simulation, double duration)
{
    const double end = simulation.time() + duration;
    while (simulation.time() < end - 1e-9 && simulation.health().ok)
        simulation.step();
}

double heightOf(const Snapshot& shot)
{
    double highest = -1;
    for (const Vec3& place : shot.bodies[0].positions)
        highest = std::max(highest, place.z());
    return highest;
}

} // namespace

class RestTest : public QObject {
    Q_OBJECT

private slots:
    /// What goes out of it on neither side is held, and waits for nothing.
    void aPlateAcrossTheMiddleComesToRest()
    {
        Scene scene = standing();
        Manipulator plate{.name = "plate", .size = Vec3(0.03, 0.03, 2 * spacing)};
        plate.motion = HoldStill{};
        scene.manipulators.push_back(plate);
        Simulation simulation(scene);
        runFor(simulation, 4);
        const auto shot = simulation.snapshot();
        QVERIFY(shot->rest > 0);
        QVERIFY(shot->penetration > 0.5); // and it is said
        QVERIFY(shot->energy.imbalanceShare() < 0.01);
    }

    void whatHasComeToRestStays()
    {
        Simulation simulation(standing());
        QCOMPARE(simulation.snapshot()->rest, std::uint64_t{0});
        runFor(simulation, 3);
        const auto before = simulation.snapshot();
        QVERIFY(before->rest > 0);
        runFor(simulation, 1);
        const auto after = simulation.snapshot();
        QCOMPARE(after->rest, before->rest);
        QVERIFY(after->bodies[0].positions == before->bodies[0].positions);
        QVERIFY(std::abs(after->time - before->time - 1) < 0.02);
        QVERIFY(after->step >= before->step + 60);
        QVERIFY(after->energy.imbalanceShare() < 0.01);
        // It stands on its weight.
        const double pressed = 1100 * 9.81 * std::pow(6 * spacing, 2) * 6 * spacing;
        Vec3 sum = Vec3::Zero();
        simulation.showPressing(true);
        for (const Vec3& force : *simulation.snapshot()->bodies[0].pressing)
            sum += force;
        QVERIFY2(std::abs(sum.z() / pressed - 1) < 0.02, qPrintable(QString::number(sum.z() / pressed)));
    }

    void sagsAsFarAsItWouldWithoutRest()
    {
        Simulation resting(standing());
        runFor(resting, 3);
        QVERIFY(resting.snapshot()->rest > 0);
        // A grip that creeps far away keeps a scene from resting.
        Scene scene = standing();
        Body other = scenes::box({2, 2, 2}, spacing, rubber());
        other.aggregate = std::make_shared<const Aggregate>(
            fill(shapes::moved(shapes::box(Vec3::Constant(2 * spacing)), {.position = Vec3(0.1, 0, 0.1)}),
                 {.spacing = spacing}));
        std::vector<ObjectIndex> all(other.aggregate->size());
        for (ObjectIndex i = 0; i < all.size(); ++i)
            all[i] = i;
        scene.bodies.push_back(other);
        scene.fixtures.push_back({"grip", 1, all, Vec3(1e-4, 0, 0)});
        Simulation moving(scene);
        runFor(moving, 3);
        QCOMPARE(moving.snapshot()->rest, std::uint64_t{0});
        QVERIFY2(std::abs(heightOf(*moving.snapshot()) - heightOf(*resting.snapshot())) < 2e-3 * spacing,
                 qPrintable(QString::number((heightOf(*moving.snapshot()) - heightOf(*resting.snapshot())) / spacing)));
    }

    void toolWakesIt()
    {
        Scene scene = standing();
        scene.manipulators.push_back(plateAbove(0.003));
        Simulation simulation(scene);
        runFor(simulation, 3);
        const std::uint64_t rest = simulation.snapshot()->rest;
        const double height = heightOf(*simulation.snapshot());
        QVERIFY(rest > 0);
        simulation.post(SetManipulatorMotion{0, DriveAt{Vec3(0, 0, -0.01), Vec3::Zero()}});
        runFor(simulation, 0.5);
        QCOMPARE(simulation.snapshot()->rest, std::uint64_t{0});
        QVERIFY(heightOf(*simulation.snapshot()) < height - 0.001);
        simulation.post(SetManipulatorMotion{0, HoldStill{}});
        runFor(simulation, 3);
        QVERIFY(simulation.snapshot()->rest > rest); // another one
        QVERIFY(simulation.snapshot()->tools[0].force.norm() > 1);
    }

    void keyFramesWakeItWhenTheyMove()
    {
        Scene scene = standing();
        Manipulator plate = plateAbove(0.001);
        const Pose up = plate.pose;
        const Pose down{up.position - Vec3(0, 0, 0.003), up.rotation};
        plate.motion = FollowKeyFrames{{{0, up}, {4, up}, {4.5, down}}};
        scene.manipulators.push_back(plate);
        Simulation simulation(scene);
        runFor(simulation, 3.9);
        QVERIFY(simulation.snapshot()->rest > 0);
        runFor(simulation, 0.7);
        QCOMPARE(simulation.snapshot()->rest, std::uint64_t{0});
        QVERIFY(simulation.snapshot()->tools[0].force.norm() > 1);
        QCOMPARE(simulation.snapshot()->tools[0].pose.position.z(), down.position.z());
    }

    void gravityWakesIt()
    {
        Simulation simulation(standing());
        runFor(simulation, 3);
        QVERIFY(simulation.snapshot()->rest > 0);
        simulation.post(SetGravity{Vec3::Zero()});
        simulation.step();
        QCOMPARE(simulation.snapshot()->rest, std::uint64_t{0});
    }

    /// What has flowed goes on healing, so that it tears as late as it would.
    void clayGoesOnHealing()
    {
        Material clay{.density = 1800, .youngsModulus = 1e6, .poissonRatio = 0.4, .dampingRatio = 0.1};
        clay.yieldStress = 2e3;
        clay.elongationAtBreak = 0.5;
        clay.tensileStrength = 1e4;
        clay.healingTime = 2;
        Scene scene = standing(clay);
        Manipulator plate = plateAbove(0.0005);
        const Pose up = plate.pose;
        const Pose down{up.position - Vec3(0, 0, 0.002), up.rotation};
        plate.motion = FollowKeyFrames{{{0, up}, {0.3, down}, {0.6, up}}};
        scene.manipulators.push_back(plate);
        Simulation simulation(scene);
        const auto damage = [&] {
            const Gesture gesture = endGesture(simulation);
            double sum = 0;
            for (const double each : gesture.moment->bodies[0].changes.plastic.damage)
                sum += each;
            return sum;
        };
        runFor(simulation, 0.7);
        const double first = damage();
        QVERIFY(first > 0);
        runFor(simulation, 4);
        QVERIFY(simulation.snapshot()->rest > 0);
        const double last = damage();
        QVERIFY2(std::abs(last / first / std::exp(-2.0) - 1) < 0.1, qPrintable(QString::number(last / first)));
    }

    void freeFlightIsNoRest()
    {
        Scene scene = standing();
        scene.floorHeight.reset();
        scene.gravity = Vec3::Zero();
        scene.bodies[0].velocity = Vec3(0.01, 0, 0);
        Simulation simulation(scene);
        runFor(simulation, 2);
        QCOMPARE(simulation.snapshot()->rest, std::uint64_t{0});
        QVERIFY(std::abs(scenes::meanPosition(*simulation.snapshot()).x() - 0.02) < 1e-4);
    }

    void rigidBodiesRestToo()
    {
        Scene scene = standing();
        scene.bodies[0].kind = BodyKind::rigid;
        Simulation simulation(scene);
        runFor(simulation, 3);
        QVERIFY(simulation.snapshot()->rest > 0);
        simulation.post(SetGravity{Vec3(0, 0, 9.81)});
        runFor(simulation, 0.2);
        QVERIFY(scenes::meanPosition(*simulation.snapshot()).z() > 0.1);
    }

    void sameBitsForAnyNumberOfThreads()
    {
        std::vector<std::uint64_t> hashes;
        for (const int threads : {1, 2, 4}) {
            hashes.push_back(onThreads(threads, [] {
                Scene scene = standing();
                Manipulator plate = plateAbove(0.001);
                plate.motion = FollowKeyFrames{{{0, plate.pose},
                                                {2, plate.pose},
                                                {2.2, {plate.pose.position - Vec3(0, 0, 0.002), plate.pose.rotation}}}};
                scene.manipulators.push_back(plate);
                Simulation simulation(scene);
                runFor(simulation, 2.3);
                return simulation.stateHash();
            }));
        }
        QCOMPARE(hashes[1], hashes[0]);
        QCOMPARE(hashes[2], hashes[0]);
    }
};

QTEST_APPLESS_MAIN(RestTest)
#include "rest_test.moc"
