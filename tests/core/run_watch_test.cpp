// What a run is measured by, what is said of it and what ends it.
#include "core/mechanics/connection_law.h"
#include "core/simulation/replay.h"
#include "support/changed_moment.h"
#include "support/scenes.h"

#include <QTest>

#include <cmath>

using namespace knead;

namespace {

constexpr double spacing = 2e-3;
const Vec3 earth(0, 0, -9.81);

Material rubber()
{
    Material material;
    material.youngsModulus = 1e6;
    return material;
}

Material aluminum()
{
    return {.density = 2700,
            .youngsModulus = 6.9e10,
            .poissonRatio = 0.33,
            .dampingRatio = 0.01,
            .tensileStrength = 3.1e8,
            .yieldStress = 2.76e8,
            .hardening = 3.4e8,
            .elongationAtBreak = 0.12};
}

/// A plate above a box, its lower face `depth` below the top of the box [spacings].
Scene plateAt(double depth, const Material& material = rubber())
{
    Scene scene;
    scene.bodies.push_back(scenes::box({6, 6, 6}, spacing, material));
    Manipulator plate{.name = "plate", .size = {0.03, 0.03, 0.01}};
    plate.pose.position.z() = (3 - depth) * spacing + 0.005;
    scene.manipulators.push_back(plate);
    return scene;
}

double massOf(const Scene& scene)
{
    return scene.bodies[0].material.density * scene.bodies[0].aggregate->filledVolume;
}

} // namespace

class RunWatchTest : public QObject {
    Q_OBJECT

private slots:
    void scaledMassIsInertiaAndNoWeight_data()
    {
        QTest::addColumn<Integrator>("integrator");
        QTest::newRow("semi-implicit") << Integrator::semiImplicitEuler;
        QTest::newRow("forward") << Integrator::forwardEuler;
        QTest::newRow("implicit") << Integrator::implicitEuler;
    }
    /// The momentum of what falls is its weight times the time, whatever its inertia.
    void scaledMassIsInertiaAndNoWeight()
    {
        QFETCH(Integrator, integrator);
        Scene scene;
        scene.bodies.push_back(scenes::box({6, 4, 4}, spacing, rubber()));
        scene.gravity = earth;
        scene.integrator = integrator;
        scene.timeStep = Simulation(scene).timeStep();
        if (integrator == Integrator::implicitEuler)
            scene.timeStep = 1e-3;
        scene.massScalingTimeStep = 10 * Simulation(scene).snapshot()->stableStep;
        Simulation simulation(scene);
        for (int step = 0; step < 100; ++step)
            simulation.step();
        const auto shot = simulation.snapshot();
        QVERIFY2(shot->addedMass > 0.5, qPrintable(QString::number(shot->addedMass)));
        const double weight = massOf(scene) * 9.81;
        const double momentum = -shot->momentum.z() / shot->time;
        QVERIFY2(std::abs(momentum - weight) < 0.006 * weight, qPrintable(QString::number(momentum / weight)));
        QVERIFY(std::abs(shot->energy.imbalance) < 0.02 * shot->energy.kinetic);
    }

    void massScalingDoesNotChangeTheSag()
    {
        const auto sag = [](bool scaled) {
            Material material = rubber();
            material.shapeDamping = 60;
            Scene scene = scenes::cantilever({12, 3, 3}, spacing, material, earth);
            if (scaled)
                scene.massScalingTimeStep = 3 * Simulation(scene).timeStep();
            Simulation simulation(scene);
            while (simulation.time() < 0.6)
                simulation.step();
            const auto shot = simulation.snapshot();
            // A fixture bears the weight of all that hangs on it.
            if (std::abs(shot->fixtureForces[0].z() + massOf(scene) * 9.81) > 0.01 * massOf(scene) * 9.81)
                return 0.0;
            return shot->bodies[0].displacement(static_cast<ObjectIndex>(shot->objects - 1)).z();
        };
        const double plain = sag(false);
        const double scaled = sag(true);
        QVERIFY(plain < -1e-5);
        QVERIFY2(std::abs(scaled - plain) < 0.01 * std::abs(plain), qPrintable(QString::number(scaled / plain)));
    }

    void aMomentKeepsTheWeightApart()
    {
        Scene scene;
        scene.bodies.push_back(scenes::box({4, 4, 4}, spacing, rubber()));
        scene.gravity = earth;
        scene.massScalingTimeStep = 5 * Simulation(scene).timeStep();
        Simulation simulation(scene);
        simulation.step();
        const MomentPointer moment = simulation.keepMoment();
        for (int step = 0; step < 50; ++step)
            simulation.step();
        Simulation other(scene);
        other.goTo(moment);
        for (int step = 0; step < 50; ++step)
            other.step();
        QCOMPARE(other.stateHash(), simulation.stateHash());
    }

    void theStepIsLongAgainWhenContactsAreGone()
    {
        // A corner between three plates.
        Scene scene;
        scene.bodies.push_back(scenes::box({5, 5, 5}, spacing, rubber()));
        const double half = 2.5 * spacing;
        for (int axis = 0; axis < 3; ++axis) {
            Manipulator plate{.name = "plate", .size = Vec3(0.03, 0.03, 0.03)};
            plate.pose.position[axis] = half + 0.015 - 0.1 * spacing;
            scene.manipulators.push_back(plate);
        }
        const auto run = [&](Simulation& simulation) {
            const double alone = simulation.snapshot()->stableStep;
            for (int step = 0; step < 20; ++step)
                simulation.step();
            const double crowded = simulation.snapshot()->stableStep;
            if (!(crowded < 0.9 * alone))
                return std::pair(alone, crowded);
            for (ToolId tool = 0; tool < 3; ++tool)
                simulation.post(RemoveManipulator{tool});
            for (int step = 0; step < 600; ++step)
                simulation.step();
            return std::pair(alone, simulation.snapshot()->stableStep);
        };
        Simulation simulation(scene);
        const auto [alone, after] = run(simulation);
        // The shape is that of the start but for what still swings; half a contact is kept to spare.
        QVERIFY2(after > 0.95 * alone, qPrintable(QString::number(after / alone)));
        Simulation again(scene);
        run(again);
        QCOMPARE(again.stateHash(), simulation.stateHash());
    }

    void objectsOfMetalThatFlyAreARunaway()
    {
        Scene scene = plateAt(-2, aluminum());
        Simulation simulation(scene);
        scenes::changeState(simulation, [](Moment& moment) {
            moment.bodies[0].velocity.set(0, Vec3(0, 0, -3000)); // a fiftieth of what was let through before
        });
        simulation.step();
        const Health& health = simulation.health();
        QVERIFY(!health.ok);
        QCOMPARE(health.trouble, Trouble::runaway);
        QVERIFY2(health.message.english().find("objects of \"box\" moved at") != std::string::npos,
                 health.message.english().c_str());
        QVERIFY2(health.message.english().find("nothing in the scene makes them faster than") != std::string::npos,
                 health.message.english().c_str());
        QVERIFY(health.message.english().find("Make the tools slower or raise") != std::string::npos);
    }

    /// A shot is no trouble: it is what the scene starts with.
    void bodiesThatAreMeantToBeFastAreNoTrouble()
    {
        Scene scene = plateAt(-2, aluminum());
        scene.bodies[0].velocity = Vec3(900, 0, 0);
        scene.bodies[0].angularVelocity = Vec3(0, 0, 5e3);
        Simulation simulation(scene);
        for (int step = 0; step < 100; ++step)
            simulation.step();
        QVERIFY2(simulation.health().ok, simulation.health().message.english().c_str());
    }

    void energyFromNowhereEndsTheRun()
    {
        Scene scene = plateAt(-2);
        scene.bodies[0].velocity = Vec3(1, 0, 0);
        Simulation simulation(scene);
        for (int step = 0; step < 300; ++step)
            simulation.step();
        QVERIFY(simulation.health().ok);
        const double time = simulation.time();
        scenes::changeState(simulation, [](Moment& moment) {
            VectorArray& velocity = moment.bodies[0].velocity;
            for (std::size_t i = 0; i < velocity.size(); ++i)
                velocity.add(i, i % 2 == 0 ? Vec3(0, 0, 15) : Vec3(0, 0, -15));
        });
        for (int step = 0; step < 600; ++step)
            simulation.step();
        const Health& health = simulation.health();
        QVERIFY(!health.ok);
        QCOMPARE(health.trouble, Trouble::energy);
        QVERIFY2(health.message.english().find("came from nowhere") != std::string::npos,
                 health.message.english().c_str());
        QVERIFY(health.message.english().find("reset") != std::string::npos);
        QCOMPARE(simulation.time(), time); // the last good state
    }

    void aHeavyBodyIsToldThatMassScalingIsToBlame()
    {
        Scene scene = plateAt(-2);
        scene.manipulators.clear();
        scene.massScalingTimeStep = 20 * Simulation(scene).timeStep();
        Simulation simulation(scene);
        scenes::changeState(simulation, [](Moment& moment) { moment.bodies[0].velocity.set(0, Vec3(0, 0, -3000)); });
        simulation.step();
        QVERIFY2(simulation.health().message.english().find("Choose a shorter time step for mass scaling") !=
                     std::string::npos,
                 simulation.health().message.english().c_str());
    }

    void stepsThatAreNotSolvedAreCounted()
    {
        Scene scene;
        scene.bodies.push_back(scenes::box({4, 4, 4}, spacing, rubber()));
        scene.integrator = Integrator::implicitEuler;
        Simulation simulation(scene);
        simulation.step();
        QCOMPARE(simulation.snapshot()->unsolvedSteps, std::uint64_t{0});
        scenes::changeState(simulation, [](Moment& moment) { moment.watch.unsolvedInRow = moment.watch.unsolved = 7; });
        QCOMPARE(simulation.snapshot()->unsolvedSteps, std::uint64_t{7});
        simulation.step();
        QVERIFY(simulation.health().ok);
        QCOMPARE(simulation.snapshot()->unsolvedSteps, std::uint64_t{7});
        QCOMPARE(simulation.keepMoment()->watch.unsolvedInRow, std::uint32_t{0}); // one that is solved ends the row
        simulation.post(Reset{});
        simulation.applyCommands();
        QCOMPARE(simulation.snapshot()->unsolvedSteps, std::uint64_t{0});
    }

    /// Every object somewhere else: no step follows that, and none may say that it did.
    void nonsenseIsStoppedInTheImplicitScheme()
    {
        Scene scene;
        Material steel = aluminum();
        steel.yieldStress = steel.tensileStrength = steel.elongationAtBreak = steel.hardening = 0;
        scene.bodies.push_back(scenes::box({4, 4, 4}, spacing, steel));
        scene.integrator = Integrator::implicitEuler;
        Simulation simulation(scene);
        simulation.step();
        scenes::changeState(simulation, [](Moment& moment) {
            VectorArray& position = moment.bodies[0].position;
            for (std::size_t i = 0; i < position.size(); ++i) {
                const auto turn = static_cast<double>(i);
                position.add(i, 1.2 * spacing * Vec3(std::sin(17 * turn), std::cos(5 * turn), std::sin(3 * turn)));
            }
        });
        for (int step = 0; step < 200 && simulation.health().ok; ++step)
            simulation.step();
        QVERIFY(!simulation.health().ok);
    }

    void aToolThatBeginsInsideIsSaid()
    {
        QVERIFY(Simulation(plateAt(-1)).snapshot()->notice.empty());
        QVERIFY(Simulation(plateAt(0.2)).snapshot()->notice.empty());
        Simulation inside(plateAt(1.5));
        const std::string notice = inside.snapshot()->notice.english();
        QVERIFY2(notice.find("\"plate\" begins 3 mm inside \"box\"") != std::string::npos, notice.c_str());

        Simulation simulation(plateAt(-1));
        Pose pose;
        pose.position.z() = 1.5 * spacing + 0.005;
        simulation.post(PlaceManipulator{0, pose});
        simulation.applyCommands();
        QCOMPARE(simulation.snapshot()->notice.english(), notice);
        pose.position.z() = 0.03;
        simulation.post(PlaceManipulator{0, pose});
        simulation.applyCommands();
        QVERIFY(simulation.snapshot()->notice.empty());
    }

    /// What a tool stores that is put into material is nobody's work, and no error of the scheme.
    void aToolThatBeginsInsideIsNoImbalance_data()
    {
        QTest::addColumn<Integrator>("integrator");
        QTest::newRow("explicit") << Integrator::semiImplicitEuler;
        QTest::newRow("implicit") << Integrator::implicitEuler;
    }
    void aToolThatBeginsInsideIsNoImbalance()
    {
        QFETCH(Integrator, integrator);
        Scene scene = plateAt(1);
        scene.integrator = integrator;
        Simulation simulation(scene);
        const MomentPointer start = simulation.keepMoment();
        for (int step = 0; step < 300; ++step)
            simulation.step();
        const auto shot = simulation.snapshot();
        QVERIFY(shot->health.ok && shot->energy.turnover > 1e-6);
        // The explicit scheme follows such a blow to a few hundredths. Of what is not booked, all would be imbalance.
        const double allowed = integrator == Integrator::implicitEuler ? 0.01 : 0.05;
        QVERIFY2(shot->energy.imbalanceShare() < allowed, qPrintable(QString::number(shot->energy.imbalanceShare())));
        Simulation other(scene);
        other.goTo(start);
        for (int step = 0; step < 300; ++step)
            other.step();
        QCOMPARE(other.stateHash(), simulation.stateHash());
        QCOMPARE(other.snapshot()->energy.imbalance, shot->energy.imbalance);
    }

    /// It hits nothing on its way, and comes to stand in the material as one that was put there.
    void aToolThatJumpsInAStepHitsNothing()
    {
        Scene scene = plateAt(-1);
        const Pose above = scene.manipulators[0].pose;
        Pose inside = above;
        inside.position.z() -= 2 * spacing;
        constexpr double start = 5e-3;
        scene.manipulators[0].motion =
            FollowKeyFrames{{{0, above}, {start, above}, {start + 1e-9, inside}, {1, inside}}};
        Simulation simulation(scene);
        double most = 0;
        while (simulation.time() < 4 * start) {
            simulation.step();
            most = std::max(most, simulation.snapshot()->energy.kinetic);
        }
        const auto shot = simulation.snapshot();
        QVERIFY2(shot->health.ok, shot->health.message.english().c_str());
        // 4 mm in 1 ns would be 4000 km/s; it is pushed out at a hundredth of the speed of sound.
        const double speed = std::sqrt(2 * most / massOf(scene));
        const double soundSpeed = std::sqrt(1e6 / rubber().density);
        QVERIFY2(speed > 0 && speed < 0.1 * soundSpeed, qPrintable(QString::number(speed / soundSpeed)));
        QVERIFY2(shot->energy.imbalanceShare() < 0.05, qPrintable(QString::number(shot->energy.imbalanceShare())));
    }

    /// What is pressed flat against a plate and torn apart is still kept out of it, as its ends are.
    void whatBreaksIsKeptOutOfTheFloorAsBefore()
    {
        Material brittle = rubber();
        brittle.tensileStrength = 2e4;
        Scene scene;
        scene.bodies.push_back(scenes::box({8, 4, 4}, spacing, brittle));
        scene.gravity = earth;
        scene.floorHeight = -2 * spacing;
        Simulation simulation(scene);
        scenes::cut(simulation, 0, 0, 1e-4);
        QVERIFY(simulation.components() > 1);
        while (simulation.time() < 0.2)
            simulation.step();
        const auto shot = simulation.snapshot();
        QVERIFY2(shot->health.ok, shot->health.message.english().c_str());
        QVERIFY2(shot->penetration < 0.1, qPrintable(QString::number(shot->penetration)));
        for (const Vec3& place : shot->bodies[0].positions)
            QVERIFY(place.z() > *scene.floorHeight - 0.1 * spacing);
    }

    void penetrationIsThatOfTheDeepestSurface()
    {
        QCOMPARE(Simulation(plateAt(-1)).snapshot()->penetration, 0.0);
        const double third = Simulation(plateAt(0.3)).snapshot()->penetration;
        QVERIFY2(std::abs(third - 0.3) < 1e-9, qPrintable(QString::number(third)));
        Scene scene = plateAt(0.3);
        scene.floorHeight = -2.6 * spacing; // 0.4 spacings above the bottom
        const double deeper = Simulation(scene).snapshot()->penetration;
        QVERIFY2(std::abs(deeper - 0.4) < 1e-9, qPrintable(QString::number(deeper)));
    }

    void anImbalanceIsAShareOfWhatGoesRound()
    {
        EnergyLedger ledger{.kinetic = 1, .imbalance = 0.02, .turnover = 2};
        QCOMPARE(ledger.imbalanceShare(), 0.01);
        ledger = {.toolWork = 10, .viscous = 9, .imbalance = -1, .turnover = 9};
        QCOMPARE(ledger.imbalanceShare(), 0.1);
        // The implicit scheme takes out; what it adds came from nowhere, though the ledger closes with it.
        ledger = {.kinetic = 4, .numerical = -3, .turnover = 4};
        QCOMPARE(ledger.imbalanceShare(), 0.75);
        QCOMPARE(EnergyLedger().imbalanceShare(), 0.0);
    }
};

QTEST_GUILESS_MAIN(RunWatchTest)
#include "run_watch_test.moc"
