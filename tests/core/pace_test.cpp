#include "core/simulation/gesture.h"
#include "core/simulation/governor.h"
#include "core/simulation/moment.h"
#include "core/simulation/replay.h"
#include "support/scenes.h"

#include <QTest>

#include <cmath>
#include <vector>

using namespace knead;

namespace {

constexpr double spacing = 2e-3;   // [m]
constexpr double frame = 1.0 / 60; // [s]

/// A rubber block that a ball is driven into.
Scene pressed()
{
    Scene scene;
    scene.bodies.push_back(scenes::box(
        {10, 10, 6}, spacing, {.density = 1100, .youngsModulus = 1e6, .poissonRatio = 0.4, .dampingRatio = 0.1}));
    scene.fixtures.push_back(
        {"foot", 0, objectsInBox(*scene.bodies[0].aggregate, Box(Vec3(-1, -1, -1), Vec3(1, 1, -2.9 * spacing)))});
    scene.integrator = Integrator::implicitEuler;
    Manipulator ball{.name = "ball", .size = Vec3::Constant(0.008)};
    ball.kind = ToolKind::ball;
    ball.pose.position = Vec3(0, 0, 3 * spacing + 0.0041);
    ball.motion = DriveAt{Vec3(0, 0, -0.006), Vec3::Zero()};
    scene.manipulators.push_back(ball);
    return scene;
}

/// Forces of the tool at full thirtieths of a second, at a pace.
std::vector<double> forcesAt(Pace pace)
{
    Simulation simulation(pressed());
    simulation.post(SetPace{pace});
    std::vector<double> forces;
    for (int n = 1; n <= 12; ++n) {
        while (simulation.time() < 2 * n * frame - 1e-9)
            simulation.step();
        forces.push_back(simulation.snapshot()->tools[0].force.norm());
    }
    return forces;
}

/// Frames of so much cost for so long. @return the pace at the end
Pace play(Governor& governor, Pace pace, double cost, double seconds)
{
    for (double time = 0; time < seconds; time += frame)
        pace = governor.see(cost, frame, pace).value_or(pace);
    return pace;
}

} // namespace

class PaceTest : public QObject {
    Q_OBJECT

private slots:
    void stepsOfTheWidePaceLastTwoFrames()
    {
        Simulation simulation(pressed());
        simulation.step();
        QCOMPARE(simulation.timeStep(), frame);
        simulation.post(SetPace{Pace::wide});
        for (int n = 0; n < 3; ++n) // steps get longer by and by
            simulation.step();
        QCOMPARE(simulation.timeStep(), 2 * frame);
        QCOMPARE(simulation.snapshot()->pace, Pace::wide);
        simulation.post(SetPace{Pace::full});
        simulation.step();
        QCOMPARE(simulation.timeStep(), frame);
    }

    /// What is lacking in a step of clay is pressed out of shape for good, and is missing from the ledger.
    void theLedgerOfClayClosesAtEveryPace()
    {
        for (const Pace pace : {Pace::full, Pace::rough, Pace::wide}) {
            Scene scene = pressed();
            Material& clay = scene.bodies[0].material;
            clay.yieldStress = 1e4;
            clay.relaxationTime = 0.002;
            Simulation simulation(scene);
            simulation.post(SetPace{pace});
            while (simulation.time() < 0.5)
                simulation.step();
            const EnergyLedger energy = simulation.snapshot()->energy;
            QVERIFY(energy.plastic > 0.3 * energy.toolWork);
            QVERIFY2(energy.imbalanceShare() < 0.04, qPrintable(QString::number(energy.imbalanceShare())));
        }
    }

    void roughForcesAreWithinThreePercentOfTheLargest()
    {
        const std::vector<double> exact = forcesAt(Pace::full);
        const std::vector<double> rough = forcesAt(Pace::rough);
        QVERIFY(exact.back() > 0.5);
        bool differ = false;
        for (std::size_t n = 0; n < exact.size(); ++n) {
            QVERIFY2(std::abs(rough[n] - exact[n]) < 0.03 * exact.back(),
                     qPrintable(QString::number((rough[n] - exact[n]) / exact.back())));
            differ = differ || rough[n] != exact[n];
        }
        QVERIFY(differ); // it does leave something out
    }

    void frictionHoldsAndLetsGoAtAnyPace()
    {
        for (const Pace pace : {Pace::full, Pace::rough, Pace::wide})
            for (const auto& [stiffness, density] : {std::pair(1e6, 1100.0), std::pair(2e11, 7850.0)})
                for (const double degrees : {12.0, 35.0}) { // the angle of friction is 16.7 degrees
                    Scene scene;
                    scene.bodies.push_back(scenes::box(
                        {6, 6, 4}, spacing,
                        {.density = density, .youngsModulus = stiffness, .dampingRatio = 0.05, .friction = 0.3}));
                    const double angle = degrees * M_PI / 180;
                    scene.gravity = 9.81 * Vec3(std::sin(angle), 0, -std::cos(angle));
                    scene.floorHeight = -2 * spacing;
                    scene.floorFriction = 0.3;
                    scene.integrator = Integrator::implicitEuler;
                    Simulation simulation(scene);
                    simulation.post(SetPace{pace});
                    while (simulation.time() < 0.5)
                        simulation.step();
                    const double way = scenes::meanPosition(*simulation.snapshot()).x();
                    const double free =
                        0.5 * 9.81 * (std::sin(angle) - 0.3 * std::cos(angle)) * std::pow(simulation.time(), 2);
                    const QString told = QString("pace %1, %2 Pa, %3 kg/m^3, %4 degrees: %5 mm, %6 of a free slide")
                                             .arg(static_cast<int>(pace))
                                             .arg(stiffness)
                                             .arg(density)
                                             .arg(degrees)
                                             .arg(1e3 * way)
                                             .arg(way / free);
                    if (degrees < 16)
                        QVERIFY2(std::abs(way) < 0.05 * spacing, qPrintable(told));
                    else // it takes a few frames to come loose
                        QVERIFY2(way > 0.85 * free && way < 1.05 * free, qPrintable(told));
                }
    }

    /// The pace is part of what is recorded and of moments: who repeats the commands comes to the same bits.
    void isRepeatedToTheBit()
    {
        const Scene scene = pressed();
        Simulation simulation(scene);
        for (int n = 0; n < 5; ++n)
            simulation.step();
        simulation.post(SetPace{Pace::wide});
        for (int n = 0; n < 3; ++n)
            simulation.step();
        const Gesture first = endGesture(simulation);
        QCOMPARE(first.moment->scheme.pace, Pace::wide);
        for (int n = 0; n < 3; ++n)
            simulation.step();
        const std::uint64_t hash = simulation.stateHash();

        Simulation other = replay(Simulation(scene), first.commands, first.moment->steps.count);
        QCOMPARE(other.stateHash(), first.hash);
        for (int n = 0; n < 3; ++n)
            other.step();
        QCOMPARE(other.stateHash(), hash);
        other.goTo(first.moment);
        QCOMPARE(other.snapshot()->pace, Pace::wide);
        for (int n = 0; n < 3; ++n)
            other.step();
        QCOMPARE(other.stateHash(), hash);
    }

    void governorLeavesAlone()
    {
        Governor governor;
        QCOMPARE(play(governor, Pace::full, 0.95, 10), Pace::full);
    }

    /// A single slow frame is none of its business.
    void governorBearsHiccups()
    {
        Governor governor;
        QCOMPARE(play(governor, Pace::full, 0.5, 1), Pace::full);
        QVERIFY(!governor.see(4, frame, Pace::full));
        QCOMPARE(play(governor, Pace::full, 0.5, 1), Pace::full);
    }

    void governorGivesAccuracyUpFirstAndStepsNext()
    {
        Governor governor;
        QCOMPARE(play(governor, Pace::full, 1.5, 0.4), Pace::full);
        QCOMPARE(play(governor, Pace::full, 1.5, 0.4), Pace::rough);
        QCOMPARE(play(governor, Pace::rough, 1.2, 0.8), Pace::wide);
        QCOMPARE(play(governor, Pace::wide, 5, 10), Pace::wide); // the rest is time
    }

    void governorTakesBackWhatItCanAfford()
    {
        Governor governor;
        QCOMPARE(play(governor, Pace::wide, 0.6, 10), Pace::wide); // twice that is too much
        QCOMPARE(play(governor, Pace::wide, 0.4, 3), Pace::rough);
        QCOMPARE(play(governor, Pace::rough, 0.4, 3), Pace::full);
    }

    /// Where each pace costs what it was measured to, it comes to rest at one of them.
    void governorDoesNotGoToAndFro()
    {
        for (double load = 0.2; load < 3; load += 0.05) {
            Governor governor;
            Pace pace = Pace::full;
            int changes = 0;
            for (double time = 0; time < 60; time += frame) {
                const double cost = pace == Pace::full ? load : pace == Pace::rough ? load / 1.5 : load / 2.2;
                if (const auto other = governor.see(cost, frame, pace)) {
                    pace = *other;
                    ++changes;
                }
            }
            QVERIFY2(changes <= 2, qPrintable(QString("%1 changes at %2").arg(changes).arg(load)));
            QCOMPARE(pace, load <= 1 ? Pace::full : load <= 1.5 ? Pace::rough : Pace::wide);
        }
    }
};

QTEST_APPLESS_MAIN(PaceTest)
#include "pace_test.moc"
