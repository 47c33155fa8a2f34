// Going back to a kept moment, and repeating what was recorded, end in the same bits as going on.
#include "core/document/moment_hash.h"
#include "core/simulation/moment.h"
#include "core/simulation/replay.h"
#include "support/scenes_of_every_kind.h"
#include "support/thread_limit.h"

#include <QTest>

#include <cmath>

using namespace knead;

namespace {

const std::vector<scenes::KindOfScene>& kinds()
{
    static const std::vector<scenes::KindOfScene> all = scenes::scenesOfEveryKind();
    return all;
}

void addKinds()
{
    QTest::addColumn<int>("kind");
    for (std::size_t k = 0; k < kinds().size(); ++k)
        QTest::newRow(kinds()[k].name.c_str()) << static_cast<int>(k);
}

bool showsTheSame(const Snapshot& a, const Snapshot& b)
{
    bool same = a.step == b.step && a.time == b.time && a.timeStep == b.timeStep && a.contacts == b.contacts &&
                a.broken == b.broken && a.joints == b.joints && a.components == b.components &&
                a.energy.kinetic == b.energy.kinetic && a.energy.elastic == b.energy.elastic &&
                a.energy.imbalance == b.energy.imbalance && a.addedMass == b.addedMass && a.materials == b.materials &&
                a.integratorReason == b.integratorReason && a.tools.size() == b.tools.size() &&
                a.fixtureIds == b.fixtureIds && a.health.ok == b.health.ok;
    for (std::size_t t = 0; same && t < a.tools.size(); ++t)
        same = a.tools[t].id == b.tools[t].id && a.tools[t].force == b.tools[t].force &&
               a.tools[t].peakForce == b.tools[t].peakForce && a.tools[t].pose.position == b.tools[t].pose.position;
    return same && a.fixtureForces == b.fixtureForces;
}

/// A body whose grips turn it inside out, after so many steps.
Scene squashed()
{
    constexpr double a = 2e-3;
    Scene scene;
    scene.bodies.push_back(scenes::box({4, 4, 4}, a, scenes::soft()));
    const Aggregate& aggregate = *scene.bodies[0].aggregate;
    scene.fixtures.push_back({"bottom", 0, objectsInBox(aggregate, Box(Vec3(-1, -1, -1), Vec3(1, 1, -1.9 * a)))});
    scene.fixtures.push_back(
        {"top", 0, objectsInBox(aggregate, Box(Vec3(-1, -1, 1.9 * a), Vec3(1, 1, 1))), Vec3(0, 0, -0.2)});
    return scene;
}

} // namespace

class MomentTest : public QObject {
    Q_OBJECT

private slots:
    void aFreshSimulationGoesOnFromAMomentToTheBit_data() { addKinds(); }
    void aFreshSimulationGoesOnFromAMomentToTheBit()
    {
        QFETCH(int, kind);
        const scenes::KindOfScene& of = kinds()[static_cast<std::size_t>(kind)];
        Simulation simulation(of.scene);
        scenes::runSteps(simulation, of, 0, of.steps);
        const auto middle = simulation.snapshot();
        QVERIFY2(middle->health.ok, middle->health.message.english().c_str());
        QVERIFY(!of.shows || of.shows(*middle));
        const MomentPointer moment = simulation.keepMoment();
        const auto kept = simulation.snapshot();
        const std::uint64_t hash = simulation.stateHash();
        scenes::runSteps(simulation, of, of.steps, 2 * of.steps);
        QVERIFY(simulation.stateHash() != hash);

        for (const int threads : {1, 2, 4}) {
            const bool same = onThreads(threads, [&] {
                Simulation fresh(of.scene);
                fresh.goTo(moment);
                const bool starts = fresh.stateHash() == hash && showsTheSame(*fresh.snapshot(), *kept);
                scenes::runSteps(fresh, of, of.steps, 2 * of.steps);
                return starts && fresh.stateHash() == simulation.stateHash() &&
                       showsTheSame(*fresh.snapshot(), *simulation.snapshot());
            });
            QVERIFY2(same, qPrintable(QString::number(threads)));
        }
    }

    void theSameSimulationGoesBackAndOnToTheBit_data() { addKinds(); }
    void theSameSimulationGoesBackAndOnToTheBit()
    {
        QFETCH(int, kind);
        const scenes::KindOfScene& of = kinds()[static_cast<std::size_t>(kind)];
        Simulation simulation(of.scene);
        const MomentPointer start = simulation.keepMoment();
        scenes::runSteps(simulation, of, 0, of.steps);
        const MomentPointer middle = simulation.keepMoment();
        scenes::runSteps(simulation, of, of.steps, of.steps + of.steps / 2);
        const std::uint64_t end = simulation.stateHash();
        simulation.goTo(start);
        scenes::runSteps(simulation, of, 0, of.steps / 3); // somewhere else
        simulation.goTo(middle);
        scenes::runSteps(simulation, of, of.steps, of.steps + of.steps / 2);
        QCOMPARE(simulation.stateHash(), end);
    }

    void recordingsRepeatOnAnyNumberOfThreads_data() { addKinds(); }
    void recordingsRepeatOnAnyNumberOfThreads()
    {
        QFETCH(int, kind);
        const scenes::KindOfScene& of = kinds()[static_cast<std::size_t>(kind)];
        Simulation simulation(of.scene);
        scenes::runSteps(simulation, of, 0, of.steps);
        simulation.keepMoment();
        scenes::runSteps(simulation, of, of.steps, of.steps + of.steps / 2);
        simulation.post(Reset{});
        scenes::runSteps(simulation, of, 0, of.steps / 2);
        const std::uint64_t whole = momentHash(*simulation.keepMoment());
        for (const int threads : {1, 4})
            onThreads(threads, [&] {
                Simulation repeated = replay(Simulation(of.scene), simulation.recording(), simulation.stepCount());
                [&] { QCOMPARE(repeated.stateHash(), simulation.stateHash()); }();
                [&] { QCOMPARE(momentHash(*repeated.keepMoment()), whole); }();
                return true;
            });
    }

    void keepingTwiceIsKeepingOnce_data() { addKinds(); }
    void keepingTwiceIsKeepingOnce()
    {
        QFETCH(int, kind);
        const scenes::KindOfScene& of = kinds()[static_cast<std::size_t>(kind)];
        Simulation once(of.scene);
        scenes::runSteps(once, of, 0, of.steps);
        Simulation twice = replay(Simulation(of.scene), once.recording(), once.stepCount());
        once.keepMoment();
        twice.keepMoment();
        twice.keepMoment();
        QVERIFY(showsTheSame(*once.snapshot(), *twice.snapshot()));
        scenes::runSteps(once, of, of.steps, of.steps + of.steps / 2);
        scenes::runSteps(twice, of, of.steps, of.steps + of.steps / 2);
        QCOMPARE(once.stateHash(), twice.stateHash());
    }

    void keepingDoesNotDisturbAnOscillation()
    {
        // A bar clamped at one end swings under its weight: with moments kept all the time it swings as it does without.
        const Scene scene =
            scenes::cantilever({16, 3, 3}, 2e-3, {.youngsModulus = 1e6, .dampingRatio = 0}, Vec3(0, 0, -9.81));
        Simulation plain(scene);
        Simulation kept(scene);
        double largest = 0;
        double difference = 0;
        double imbalance = 0;
        for (int step = 1; step <= 3000; ++step) {
            plain.step();
            kept.step();
            if (step % 7 == 0)
                kept.keepMoment();
            if (step % 100 != 0)
                continue;
            const auto one = plain.snapshot();
            const auto two = kept.snapshot();
            largest = std::max(largest, one->energy.kinetic);
            imbalance = std::max(imbalance, std::abs(two->energy.imbalance - one->energy.imbalance));
            for (ObjectIndex i = 0; i < one->objects; ++i)
                difference = std::max(difference, (one->bodies[0].positions[i] - two->bodies[0].positions[i]).norm());
        }
        QVERIFY(largest > 0);
        QVERIFY2(difference < 1e-12, qPrintable(QString::number(difference))); // [m]
        QVERIFY2(imbalance < 1e-9 * largest, qPrintable(QString::number(imbalance / largest)));
    }

    void keepingLeavesTheLedgerAsItIs_data() { addKinds(); }
    void keepingLeavesTheLedgerAsItIs()
    {
        QFETCH(int, kind);
        const scenes::KindOfScene& of = kinds()[static_cast<std::size_t>(kind)];
        Simulation plain(of.scene);
        Simulation kept(of.scene);
        for (int part = 0; part < 10; ++part) {
            scenes::runSteps(plain, of, part * of.steps / 10, (part + 1) * of.steps / 10);
            scenes::runSteps(kept, of, part * of.steps / 10, (part + 1) * of.steps / 10);
            const double before = kept.snapshot()->energy.imbalance;
            kept.keepMoment();
            const auto after = kept.snapshot();
            QVERIFY(std::abs(after->energy.imbalance - before) <= 1e-9 * scenes::turnover(after->energy));
        }
        const EnergyLedger one = plain.snapshot()->energy;
        const EnergyLedger two = kept.snapshot()->energy;
        const double worse = (std::abs(two.imbalance) - std::abs(one.imbalance)) / scenes::turnover(one);
        QVERIFY2(worse < 1e-3, qPrintable(QString::number(worse)));
    }

    void goingToAMomentBringsMaterialsToolsAndFixturesBack()
    {
        Simulation simulation(scenes::smallPress(scenes::soft()));
        const MomentPointer start = simulation.keepMoment();
        simulation.post(SetMaterial{0, scenes::soft(0.4)});
        simulation.post(SetMaterial{0, scenes::clay(), {1, 2, 3}});
        simulation.post(AddFixture{{"hold", 0, {0}}});
        simulation.post(ReshapeManipulator{0, Vec3(0.01, 0.01, 0.01), 0.1, 1});
        simulation.post(AddManipulator{{.name = "second"}});
        simulation.post(SetGravity{Vec3(0, 0, -1)});
        simulation.post(SetFloor{});
        simulation.step();
        const MomentPointer edited = simulation.keepMoment();
        const auto after = simulation.snapshot();
        simulation.goTo(start);
        const auto before = simulation.snapshot();
        QCOMPARE(before->materials[0].poissonRatio, 0.25);
        QCOMPARE(simulation.bodies()[0].material.poissonRatio, 0.25);
        QVERIFY(before->fixtures.empty());
        QCOMPARE(before->tools.size(), std::size_t{1});
        QCOMPARE(before->tools[0].friction, 0.4);
        QCOMPARE(before->gravity.norm(), 0.0);
        QVERIFY(before->floorHeight.has_value());
        QVERIFY(simulation.recording().empty());
        simulation.goTo(edited);
        QVERIFY(showsTheSame(*simulation.snapshot(), *after));
    }

    void momentsOfOtherBodiesChangeNothing()
    {
        Simulation other(scenes::smallPress(scenes::soft(), 4));
        const MomentPointer strange = other.keepMoment();
        Simulation simulation(scenes::smallPress(scenes::soft(), 5));
        simulation.step();
        const std::uint64_t hash = simulation.stateHash();
        simulation.goTo(strange);
        QVERIFY(!simulation.snapshot()->notice.empty());
        QCOMPARE(simulation.stateHash(), hash);
        QCOMPARE(simulation.stepCount(), std::uint64_t{1});
    }

    void aStoppedRunGoesBackWithItsMaterials()
    {
        Simulation simulation(squashed());
        while (simulation.health().ok && simulation.stepCount() < 20'000) {
            simulation.step();
            Material other = scenes::soft();
            other.friction = simulation.time();
            simulation.post(SetMaterial{0, other});
        }
        QVERIFY(!simulation.health().ok);
        // The material is that of the moment it went back to, at most two looks ago.
        QVERIFY(std::abs(simulation.bodies()[0].material.friction - simulation.time()) < 2 * simulation.timeStep());
    }

    void aStoppedRunRepeats()
    {
        // Commands before and after it went back, at the same step or not, and a fresh begin: all of it again.
        Simulation simulation(squashed());
        simulation.post(SetGravity{Vec3(0, 0, -1)});
        while (simulation.health().ok && simulation.stepCount() < 20'000)
            simulation.step();
        QVERIFY(!simulation.health().ok);
        const Message message = simulation.health().message;
        simulation.post(SetMaterial{0, scenes::soft(0.4)});
        const MomentPointer stopped = simulation.keepMoment();
        const std::uint64_t hash = simulation.stateHash();
        const std::size_t commands = simulation.recording().size();
        simulation.post(MoveFixture{1, Vec3(0, 0, 0.1)});
        simulation.post(Reset{});
        for (int step = 0; step < 300; ++step)
            simulation.step();
        QVERIFY(simulation.health().ok);

        const std::vector<RecordedCommand>& recording = simulation.recording();
        const Simulation again = replay(Simulation(squashed()), recording, 300);
        QCOMPARE(again.stateHash(), simulation.stateHash());
        const Simulation part =
            replay(Simulation(squashed()), std::span(recording).first(commands), recording[commands - 1].step);
        QCOMPARE(part.stateHash(), hash);
        QCOMPARE(part.health().message, message);
        Simulation fresh(squashed());
        fresh.goTo(stopped);
        QCOMPARE(fresh.health().message, message);
        QCOMPARE(fresh.bodies()[0].material.poissonRatio, 0.4);
    }

    void aStoppedRunStopsAtTheSameStepFromAMoment()
    {
        // Material must be found inside out at two looks in a row: the first one is remembered.
        Simulation simulation(squashed());
        std::vector<MomentPointer> moments;
        while (simulation.health().ok && simulation.stepCount() < 20'000) {
            simulation.step();
            if (simulation.stepCount() % 128 == 0 && simulation.health().ok)
                moments.push_back(simulation.keepMoment());
        }
        QVERIFY(!simulation.health().ok);
        for (const MomentPointer& moment : {moments.end()[-1], moments.end()[-3]}) {
            Simulation fresh(squashed());
            fresh.goTo(moment);
            while (fresh.health().ok && fresh.stepCount() < simulation.stepCount()) {
                fresh.step();
                if (fresh.stepCount() % 128 == 0 && fresh.health().ok)
                    fresh.keepMoment();
            }
            QVERIFY(!fresh.health().ok);
            QCOMPARE(fresh.stepCount(), simulation.stepCount());
            QCOMPARE(fresh.health().message, simulation.health().message);
        }
    }

    void aNoticeOutlivesTheKeptMoment()
    {
        Simulation simulation(scenes::smallPress(scenes::soft()));
        simulation.post(RemoveManipulator{9});
        simulation.keepMoment();
        QVERIFY(!simulation.snapshot()->notice.empty());
    }

    void replayOfAnotherRecordingIsRefused()
    {
        const Scene scene = scenes::smallPress(scenes::soft());
        const std::vector<RecordedCommand> backwards{{20, SetGravity{}}, {10, SetGravity{}}};
        QVERIFY_THROWS_EXCEPTION(std::runtime_error, replay(Simulation(scene), backwards, 30));
        // A run that stops never reaches what comes later.
        QVERIFY_THROWS_EXCEPTION(std::runtime_error, replay(Simulation(squashed()), {}, 50'000));
    }

    void replayCanBeCancelled()
    {
        struct Impatient : TaskControl {
            void report(double fraction, std::string_view) override { reached = fraction; }
            bool isCancelled() const override { return reached > 0.3; }
            double reached = 0;
        } control;
        QVERIFY_THROWS_EXCEPTION(Cancelled, replay(Simulation(scenes::smallPress(scenes::soft())), {}, 1000, control));
        QVERIFY(control.reached < 0.4);
    }
};

QTEST_GUILESS_MAIN(MomentTest)
#include "moment_test.moc"
