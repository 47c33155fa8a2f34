// Contacts, rigid bodies and determinism: V17 and V18 of the verification suite, and what the published mode promises.
#include "core/aggregate/published_fill.h"
#include "core/mechanics/rigid_motion.h"
#include "support/material_scenes.h"
#include "support/thread_limit.h"

#include <QTest>

#include <cmath>

using namespace knead;

namespace {

constexpr double spacing = 2e-3;

void runUntil(Simulation& simulation, double time)
{
    while (simulation.time() < time && simulation.health().ok)
        simulation.step();
}

Pose at(const Vec3& position)
{
    return {position, Quaternion::Identity()};
}

/// A clay bar that is kneaded between two balls until it cracks, touches itself and heals: everything at once.
Scene kneadedClay()
{
    Scene scene;
    Material clay = scenes::clay();
    clay.tensileStrength = 5e3; // a little less than it yields at, so that it cracks
    clay.healingTime = 0.002;
    clay.adhesion = 1e4;
    clay.elongationAtBreak = 0.5;
    scene.bodies.push_back(scenes::box({40, 11, 11}, spacing, clay));
    scene.bodies.push_back(scenes::body(
        shapes::moved(shapes::box(8 * spacing * Vec3::Ones()), at(Vec3(0, 0, 10 * spacing))), spacing, clay, "lump"));
    scene.bodies[1].velocity = Vec3(0, 0, -1);
    for (const double side : {-1.0, 1.0}) {
        Manipulator ball{.name = "ball", .size = Vec3::Constant(0.02)};
        ball.kind = ToolKind::ball;
        ball.pose = at({0.01 * side, side * (5.5 * spacing + 0.0105), 0});
        ball.motion = DriveAt{Vec3(0, -side * 0.4, 0), Vec3(0, 0, 5)};
        scene.manipulators.push_back(ball);
    }
    return scene;
}

} // namespace

class VerificationContactTest : public QObject {
    Q_OBJECT

private slots:
    void sameBitsForAnyNumberOfThreads() // V17
    {
        const auto hash = [](int threads) {
            return onThreads(threads, [] {
                Simulation simulation(kneadedClay());
                for (int step = 0; step < 500; ++step)
                    simulation.step();
                const auto shot = simulation.snapshot();
                const bool everything = shot->health.ok && shot->broken > 0 && shot->joints > 0 && shot->contacts > 0 &&
                                        shot->energy.plastic > 0;
                if (!everything)
                    qWarning("%zu broken, %zu joints, %zu contacts, %s", shot->broken, shot->joints, shot->contacts,
                             shot->health.message.english().c_str());
                return everything ? simulation.stateHash() : 0;
            });
        };
        const std::uint64_t expected = hash(1);
        QVERIFY(expected != 0);
        for (const int threads : {2, 4, 8})
            QCOMPARE(hash(threads), expected);
    }

    void lookingDoesNotChangeTheRun()
    {
        const auto hash = [](int lookEvery) {
            Simulation simulation(kneadedClay());
            for (int step = 1; step <= 120; ++step) {
                simulation.step();
                if (step % lookEvery == 0)
                    simulation.snapshot();
            }
            return simulation.stateHash();
        };
        QCOMPARE(hash(3), hash(1000));
    }

    void aRigidBodyOfHeavierMaterialIsHarderToMove()
    {
        for (const double density : {1000.0, 8000.0}) {
            Scene scene;
            Material light;
            light.density = 1000;
            scene.bodies.push_back(scenes::box({4, 4, 4}, spacing, light));
            scene.bodies[0].kind = BodyKind::rigid;
            scene.bodies[0].velocity = Vec3(0.1, 0, 0);
            Simulation simulation(scene);
            Material material = light;
            material.density = density;
            simulation.post(SetMaterial{.body = 0, .material = material});
            runUntil(simulation, 0.01);
            const double mass = density * 64 * std::pow(spacing, 3);
            QVERIFY(std::abs(simulation.snapshot()->momentum.x() / (0.1 * mass) - 1) < 1e-9);
            QVERIFY(std::abs(simulation.snapshot()->energy.kinetic / (0.005 * mass) - 1) < 1e-9);
        }
    }

    void dampingCannotBeTakenAwayFromForwardEuler()
    {
        Simulation simulation(scenes::publishedBar());
        Material undamped = simulation.bodies()[0].material;
        undamped.dampingRatio = 0;
        simulation.post(SetMaterial{.body = 0, .material = undamped});
        simulation.step();
        QVERIFY(!simulation.snapshot()->notice.empty());
        simulation.post(Reset{});
        simulation.applyCommands();
        simulation.step();
        QVERIFY(simulation.health().ok);
    }

    void sameBitsForEveryVicinityMethod()
    {
        std::uint64_t expected = 0;
        for (const VicinityMethod method : vicinityMethods) {
            Scene scene = kneadedClay();
            scene.vicinity = method;
            Simulation simulation(scene);
            for (int step = 0; step < 250; ++step)
                simulation.step();
            if (method == vicinityMethods[0])
                expected = simulation.stateHash();
            QCOMPARE(simulation.stateHash(), expected);
        }
    }

    void ballPressedIntoABlockFeelsHertz() // V18
    {
        // F = 4/3 E / (1 - nu^2) sqrt(R) delta^(3/2); the block is ten contact radii wide.
        Material material;
        material.youngsModulus = 1e6;
        material.dampingRatio = 0.1;
        material.shapeDamping = 150;
        material.friction = 0;
        const int width = 36;
        const int depth = 22;
        Scene scene;
        scene.bodies.push_back(scenes::box({width, width, depth}, spacing, material));
        const Aggregate& aggregate = *scene.bodies[0].aggregate;
        const double top = 0.5 * depth * spacing;
        scene.fixtures.push_back({"bed", 0, objectsInBox(aggregate, Box(Vec3(-1, -1, -1), Vec3(1, 1, -top + 1e-6)))});
        const double radius = 12 * spacing;
        Manipulator ball{.name = "ball", .size = Vec3::Constant(2 * radius)};
        ball.kind = ToolKind::ball;
        ball.pose = at({0, 0, top + radius});
        const double indentation = spacing;
        ball.motion = FollowKeyFrames{{{0, ball.pose}, {0.02, at({0, 0, top + radius - indentation})}}};
        scene.manipulators.push_back(ball);
        Simulation simulation(scene);
        runUntil(simulation, 0.045);
        simulation.snapshot();
        runUntil(simulation, 0.05);
        const double modulus = material.youngsModulus / (1 - 0.25 * 0.25);
        const double expected = 4.0 / 3 * modulus * std::sqrt(radius) * std::pow(indentation, 1.5);
        const double force = simulation.snapshot()->tools[0].force.z();
        qInfo("%.3f of Hertz", force / expected);
        QVERIFY2(std::abs(force / expected - 1) < 0.15, qPrintable(QString::number(force / expected)));
    }

    void aRigidTopKeepsEnergyAndAngularMomentum()
    {
        Scene scene;
        Material steel;
        steel.density = 7850;
        steel.youngsModulus = 2e11;
        scene.bodies.push_back(scenes::box({6, 3, 2}, spacing, steel));
        scene.bodies[0].kind = BodyKind::rigid;
        scene.bodies[0].velocity = Vec3(0.2, 0.1, 0);
        scene.bodies[0].angularVelocity = Vec3(1, 60, 0.5); // about the middle axis: it tumbles
        Simulation simulation(scene);
        const auto start = simulation.snapshot();
        double mostTurned = 0;
        for (int i = 0; i < 20; ++i) {
            runUntil(simulation, 0.05 * (i + 1));
            const auto shot = simulation.snapshot();
            QVERIFY((shot->momentum - start->momentum).norm() < 1e-10 * start->momentum.norm());
            QVERIFY((shot->angularMomentum - start->angularMomentum).norm() < 1e-3 * start->angularMomentum.norm());
            QVERIFY(std::abs(shot->energy.kinetic / start->energy.kinetic - 1) < 5e-3);
            const Vec3 edge = shot->bodies[0].positions.back() - shot->bodies[0].positions.front();
            const Vec3 rest = start->bodies[0].positions.back() - start->bodies[0].positions.front();
            QVERIFY(std::abs(edge.norm() / rest.norm() - 1) < 1e-9); // it keeps its shape
            mostTurned = std::max(mostTurned, (edge - rest).norm() / rest.norm());
        }
        QVERIFY(mostTurned > 1);
        QCOMPARE(simulation.snapshot()->connections, std::size_t{0});
    }

    void rigidAndDeformableBodiesShareTheirMomentum()
    {
        Scene scene;
        Material rubber;
        rubber.youngsModulus = 1e6;
        rubber.friction = 0; // it is no central force: without spin of the objects it takes angular momentum
        Material steel = rubber;
        steel.density = 7850;
        steel.youngsModulus = 2e11;
        scene.bodies.push_back(scenes::box({6, 6, 6}, spacing, rubber));
        scene.bodies.push_back(
            scenes::body(shapes::moved(shapes::box(4 * spacing * Vec3::Ones()), at({5.2 * spacing, 0.3 * spacing, 0})),
                         spacing, steel, "steel"));
        scene.bodies[1].kind = BodyKind::rigid;
        scene.bodies[1].velocity = Vec3(-0.5, 0, 0);
        Simulation simulation(scene);
        const auto start = simulation.snapshot();
        QVERIFY2(simulation.timeStep() > 1e-5, "steel must not set the time step when it is rigid");
        runUntil(simulation, 0.05);
        const auto end = simulation.snapshot();
        QVERIFY((end->momentum - start->momentum).norm() < 1e-10 * start->momentum.norm());
        QVERIFY((end->angularMomentum - start->angularMomentum).norm() < 1e-5 * start->momentum.norm() * 0.01);
        QVERIFY(scenes::meanPosition(*end, 0).x() < -0.001);
        QVERIFY2(std::abs(end->energy.imbalance) < 5e-3 * start->energy.kinetic,
                 qPrintable(QString::number(end->energy.imbalance / start->energy.kinetic)));
    }

    void aBodyMadeRigidOnTheWayKeepsItsMomentum()
    {
        Scene scene;
        Material rubber;
        rubber.youngsModulus = 1e5;
        scene.bodies.push_back(scenes::box({6, 4, 4}, spacing, rubber));
        scene.bodies[0].velocity = Vec3(0.3, 0, 0);
        scene.bodies[0].angularVelocity = Vec3(20, 30, 10);
        Simulation simulation(scene);
        const auto start = simulation.snapshot();
        for (const BodyKind kind : {BodyKind::rigid, BodyKind::deformable}) {
            runUntil(simulation, simulation.time() + 0.02);
            simulation.post(SetBodyKind{0, kind});
            runUntil(simulation, simulation.time() + 0.02);
            const auto shot = simulation.snapshot();
            QCOMPARE(shot->bodies[0].kind, kind);
            QVERIFY((shot->momentum - start->momentum).norm() < 1e-9 * start->momentum.norm());
            QVERIFY((shot->angularMomentum - start->angularMomentum).norm() < 1e-3 * start->angularMomentum.norm());
            QVERIFY(std::abs(shot->energy.imbalance) < 5e-3 * start->energy.kinetic);
        }
    }

    void thePublishedBarHas425ObjectsAndRunsAsPublished()
    {
        Scene scene = scenes::publishedBar();
        const Aggregate& bar = *scene.bodies[0].aggregate;
        QCOMPARE(bar.size(), std::size_t{425});
        QCOMPARE(bar.connectionCount(), std::size_t{3928}); // 3883 as published, 1.2 % fewer
        double sum = 0;
        for (std::size_t d = 0; d < Lattice::directionCount; ++d)
            for (const double w : bar.weight[d])
                sum += w * bar.lattice.direction(static_cast<int>(d)).squaredNorm();
        QVERIFY(std::abs(sum / (15 * bar.meshVolume / spacing) - 1) < 1e-12); // sum k l^2 = 6 E V
        Simulation simulation(scene);
        const double spinBefore = simulation.snapshot()->angularMomentum.norm();
        runUntil(simulation, 0.1);
        QVERIFY2(simulation.health().ok, simulation.health().message.english().c_str());
        const auto shot = simulation.snapshot();
        QVERIFY(shot->energy.kinetic > 0);
        QVERIFY(shot->tools[0].peakForce > 0);
        const double imbalance = std::abs(shot->energy.imbalance) / scenes::turnover(shot->energy);
        // Forward Euler is of first order, and contacts are many times as stiff as the material.
        QVERIFY2(imbalance < 0.02, qPrintable(QString::number(imbalance)));
        // Structural friction brakes rigid rotation, as the published form does.
        Scene spinning = scenes::publishedBar();
        spinning.manipulators.clear();
        spinning.gravity = Vec3::Zero();
        spinning.bodies[0].angularVelocity = Vec3(0, 0, 5);
        Simulation turning(spinning);
        const Vec3 before = turning.snapshot()->angularMomentum;
        runUntil(turning, 0.2);
        QVERIFY(turning.snapshot()->angularMomentum.norm() < 0.98 * before.norm());
        QVERIFY(spinBefore >= 0);
    }

    void forwardEulerNeedsDamping()
    {
        Scene scene = scenes::publishedBar();
        scene.bodies[0].material.dampingRatio = 0;
        QVERIFY_THROWS_EXCEPTION(std::runtime_error, Simulation{scene});
    }

    void aTimeStepThatIsTooLongStopsTheRunAndSaysSo()
    {
        Scene scene;
        scene.bodies.push_back(scenes::box({4, 4, 4}, spacing));
        scene.timeStep = 1e-2;
        Simulation simulation(scene);
        for (int step = 0; step < 2000 && simulation.health().ok; ++step)
            simulation.step();
        QVERIFY(!simulation.health().ok);
        QVERIFY2(simulation.health().message.english().find("time step") != std::string::npos,
                 simulation.health().message.english().c_str());
        scene.timeStep = 1e-5;
        Simulation slow(scene);
        QCOMPARE(slow.timeStep(), 1e-5);
    }

    void massScalingIsReportedAndWorks()
    {
        Scene scene;
        Material steel;
        steel.density = 7850;
        steel.youngsModulus = 2e11;
        steel.poissonRatio = 0.3;
        scene.bodies.push_back(scenes::box({6, 4, 4}, spacing, steel));
        QCOMPARE(Simulation(scene).snapshot()->addedMass, 0.0);
        const double own = Simulation(scene).timeStep();
        scene.massScalingTimeStep = 3 * own;
        Simulation scaled(scene);
        QVERIFY2(scaled.timeStep() > 2.5 * own, qPrintable(QString::number(scaled.timeStep() / own)));
        const double added = scaled.snapshot()->addedMass;
        QVERIFY2(added > 0.7 && added < 0.95, qPrintable(QString::number(added)));
    }

    void aRegionIsOfItsOwnMaterial()
    {
        // Two halves in a row, one ten times as stiff: the soft one stretches ten times as much.
        Scene scene;
        Material soft;
        soft.dampingRatio = 0.2;
        soft.shapeDamping = 100;
        scene.bodies.push_back(scenes::box({16, 4, 4}, spacing, soft));
        const Aggregate& aggregate = *scene.bodies[0].aggregate;
        Material stiff = soft;
        stiff.youngsModulus *= 10;
        const auto between = [&](double low, double high) {
            return objectsInBox(aggregate, Box(Vec3(low, -1, -1), Vec3(high, 1, 1)));
        };
        const double half = 8 * spacing;
        scene.fixtures.push_back({"hold", 0, between(-1, -half + 1e-6)});
        scene.fixtures.push_back({"grip", 0, between(half - 1e-6, 1), Vec3(0.05, 0, 0)});
        Simulation simulation(scene);
        simulation.post(SetMaterial{.body = 0, .material = stiff, .objects = between(1e-6, 1)});
        runUntil(simulation, 0.02);
        simulation.post(MoveFixture{1, Vec3::Zero()});
        runUntil(simulation, 0.15);
        const auto shot = simulation.snapshot();
        const auto displacementAt = [&](double x) {
            double sum = 0;
            int count = 0;
            for (ObjectIndex i = 0; i < aggregate.size(); ++i)
                if (std::abs(aggregate.lattice.position(i).x() - x) < 1e-6) {
                    sum += shot->bodies[0].displacement(i).x();
                    ++count;
                }
            return sum / count;
        };
        const double softStrain = displacementAt(-2 * spacing) - displacementAt(-6 * spacing);
        const double stiffStrain = displacementAt(6 * spacing) - displacementAt(2 * spacing);
        QVERIFY2(std::abs(softStrain / stiffStrain / 10 - 1) < 0.1,
                 qPrintable(QString::number(softStrain / stiffStrain)));
        QVERIFY(std::abs(shot->fixtureForces[0].x() + shot->fixtureForces[1].x()) <
                0.01 * std::abs(shot->fixtureForces[1].x()));
    }
};

QTEST_GUILESS_MAIN(VerificationContactTest)
#include "verification_contact_test.moc"
