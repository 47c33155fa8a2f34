// The tree of what was done: undo, redo, branches, thinning, and the same bits again.
#include "core/document/history.h"
#include "core/simulation/replay.h"
#include "support/fuzz_random.h"
#include "support/scenes_of_every_kind.h"

#include <QTest>

using namespace knead;

namespace {

using Entry = History::Entry;

constexpr double spacing = 2e-3;

/// Any edit, some of which cannot be carried out.
Command anyCommand(fuzz::Random& random)
{
    const auto number = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random.below(1001)) / 1000;
    };
    const auto some = [&] { return static_cast<std::uint32_t>(random.below(3)); };
    Manipulator ball{.name = "ball", .size = Vec3::Constant(0.006)};
    ball.kind = ToolKind::ball;
    ball.pose.position = Vec3(0.0075, number(-0.002, 0.002), 0);
    ball.motion = DriveAt{Vec3(-0.3, 0, 0), Vec3::Zero()};
    switch (random.below(15)) {
    case 0: {
        Material material = random.chance(50) ? scenes::soft(number(0, 0.45)) : scenes::clay();
        material.youngsModulus = number(1e5, 4e5);
        return SetMaterial{some(), material, {}};
    }
    case 1: {
        Material brittle = scenes::soft();
        brittle.tensileStrength = 5e3;
        brittle.adhesion = 1e4;
        return SetMaterial{0, brittle, {1, 2, 3, 4, 5, 6, 7, 8, 9}};
    }
    case 2:
        return SetBodyKind{some(), random.chance(30) ? BodyKind::rigid : BodyKind::deformable};
    case 3:
        return Renormalize{0, {}, random.chance(50) ? 0 : 0.01};
    case 4:
        return SetGravity{Vec3(0, 0, number(-20, 0))};
    case 5:
        return SetFloor{random.chance(50) ? std::optional(-2.5 * spacing) : std::nullopt};
    case 6:
        return AddManipulator{ball};
    case 7:
        return RemoveManipulator{some()};
    case 8:
        return SetManipulatorMotion{some(), GoTo{scenes::placedAt(Vec3(number(-0.01, 0.01), 0, 0.012))}};
    case 9:
        return PlaceManipulator{some(), scenes::placedAt(Vec3(0, number(-0.02, 0.02), 0.02))};
    case 10:
        return AddFixture{{"grip", 0, {0, 1, 2}, Vec3(0, 0, number(-0.05, 0.05))}};
    case 11:
        return RemoveFixture{some()};
    case 12:
        return MoveFixture{some(), Vec3(number(-0.05, 0.05), 0, 0)};
    case 13:
        return SetIntegrator{random.chance(25) ? Integrator::implicitEuler : Integrator::automatic};
    default:
        return random.chance(30) ? Command(Reset{}) : Command(SetGravity{Vec3::Zero()});
    }
}

Scene twoLumps()
{
    Scene scene = scenes::smallPress(scenes::soft(), 4);
    scene.bodies.push_back(scenes::boxAt({2, 2, 2}, spacing, Vec3(0, 0, 6 * spacing), scenes::soft(), "second"));
    scene.bodies[1].velocity = Vec3(0, 0, -0.3);
    return scene;
}

/// A document without a window: a simulation and its history.
struct Document {
    explicit Document(const Scene& start, std::size_t memory = History::defaultMemory)
        : scene(start)
        , simulation(start)
        , history(recordOf(endGesture(simulation), "start"), memory)
    {
    }

    void doSomething(fuzz::Random& random, int mostSteps)
    {
        for (std::size_t i = random.below(3); i > 0; --i)
            simulation.post(anyCommand(random));
        for (std::size_t i = random.below(static_cast<std::size_t>(mostSteps)); i > 0; --i)
            simulation.step();
        history.append(recordOf(endGesture(simulation), "gesture"));
    }

    /// @return whether the state there is the one that was
    bool visit(Entry entry)
    {
        const Way way = history.wayTo(entry);
        const MomentPointer moment = follow(way, scene);
        simulation.goTo(moment);
        repeated += way.commands.empty() ? 0 : 1;
        history.goTo(entry);
        return simulation.stateHash() == history.record(entry).hash &&
               simulation.stepCount() == history.record(entry).step;
    }

    std::uint64_t hashOfStraightRun() const
    {
        std::vector<RecordedCommand> commands;
        for (const Entry entry : history.pathTo(history.current())) {
            const auto& own = history.record(entry).commands;
            commands.insert(commands.end(), own.begin(), own.end());
        }
        return replay(Simulation(scene), commands, simulation.stepCount()).stateHash();
    }

    Scene scene;
    Simulation simulation;
    History history;
    int repeated = 0; ///< visits that had to repeat commands
};

/// A history of names alone, with moments of so many bytes.
HistoryRecord named(const std::string& name, std::size_t bytes = 1000)
{
    return {.name = name, .moment = std::make_shared<const Bytes>(bytes)};
}

std::vector<bool> kept(const History& history)
{
    std::vector<bool> all;
    for (const HistoryRecord& record : history.records())
        all.push_back(record.moment != nullptr);
    return all;
}

} // namespace

class HistoryTest : public QObject {
    Q_OBJECT

private slots:
    void anySequenceEndsWhereAStraightRunEnds_data()
    {
        QTest::addColumn<int>("seed");
        QTest::addColumn<int>("memory");
        const int plenty = 1 << 29;
        const int tight = 200'000;
        for (int seed = 1; seed <= 3; ++seed) {
            QTest::addRow("%d, all kept", seed) << seed << plenty;
            QTest::addRow("%d, few kept", seed) << seed << tight;
        }
    }
    void anySequenceEndsWhereAStraightRunEnds()
    {
        QFETCH(int, seed);
        QFETCH(int, memory);
        fuzz::Random random(static_cast<std::uint64_t>(seed));
        Document document(twoLumps(), static_cast<std::size_t>(memory));
        for (int i = 0; i < 200; ++i) {
            const std::size_t what = random.below(10);
            std::optional<Entry> target;
            if (what < 5)
                document.doSomething(random, 12);
            else if (what < 8)
                target = document.history.undoTarget();
            else if (what < 9)
                target = document.history.redoTarget();
            else
                target = static_cast<Entry>(random.below(document.history.records().size()));
            if (target)
                QVERIFY(document.visit(*target));
        }
        QCOMPARE(document.hashOfStraightRun(), document.simulation.stateHash());
        // All the way back and forth again.
        const Entry end = document.history.current();
        while (const auto target = document.history.undoTarget())
            QVERIFY(document.visit(*target));
        QCOMPARE(document.history.current(), Entry{0});
        while (document.history.current() != end) {
            const auto target = document.history.redoTarget();
            QVERIFY(target.has_value());
            QVERIFY(document.visit(*target));
        }
        QCOMPARE(document.hashOfStraightRun(), document.simulation.stateHash());
        QCOMPARE(document.repeated > 0, memory == 200'000);
        qInfo("%zu entries, %d repeated, %zu bytes", document.history.records().size(), document.repeated,
              document.history.memory());
    }

    void everyEntryComesBackFromAnotherSimulation()
    {
        fuzz::Random random(11);
        Document document(twoLumps());
        for (int i = 0; i < 20; ++i)
            document.doSomething(random, 30);
        const History copy(document.history.records(), document.history.current());
        QCOMPARE(copy.memory(), document.history.memory());
        for (Entry entry = 0; entry < copy.records().size(); ++entry) {
            Simulation fresh(document.scene);
            fresh.goTo(follow(copy.wayTo(entry), document.scene));
            QCOMPARE(fresh.stateHash(), copy.record(entry).hash);
        }
    }

    void anEntryWithoutAnyMomentIsRepeatedFromTheBeginning()
    {
        fuzz::Random random(12);
        Document document(twoLumps());
        for (int i = 0; i < 5; ++i)
            document.doSomething(random, 30);
        std::vector<HistoryRecord> records = document.history.records();
        for (HistoryRecord& record : records)
            record.moment = nullptr;
        const History bare(records, 5);
        const Way way = bare.wayTo(5);
        QVERIFY(!way.from);
        Simulation fresh(document.scene);
        fresh.goTo(follow(way, document.scene));
        QCOMPARE(fresh.stateHash(), document.simulation.stateHash());
    }

    void aWayThatEndsElsewhereIsRefused()
    {
        fuzz::Random random(13);
        Document document(twoLumps());
        document.doSomething(random, 30);
        Way way = document.history.wayTo(1);
        way.from = nullptr;
        way.commands = document.history.record(1).commands;
        way.hash += 1;
        QVERIFY_THROWS_EXCEPTION(std::runtime_error, follow(way, document.scene));
    }

    void redoGoesWhereOneWasLast()
    {
        History history(named("start"));
        QVERIFY(!history.undoTarget() && !history.redoTarget());
        const Entry a = history.append(named("a"));
        const Entry b = history.append(named("b"));
        history.goTo(*history.undoTarget());
        QCOMPARE(history.current(), a);
        const Entry c = history.append(named("c"));
        QCOMPARE(history.current(), c);
        QCOMPARE(history.childrenOf(a), (std::vector<Entry>{b, c}));
        QCOMPARE(history.pathTo(b), (std::vector<Entry>{0, a, b}));
        history.goTo(a);
        QCOMPARE(*history.redoTarget(), c);
        QCOMPARE(history.wayOn(), std::vector<Entry>{c});
        history.goTo(b);
        history.goTo(0);
        QCOMPARE(history.wayOn(), (std::vector<Entry>{a, b}));
        QCOMPARE(*history.redoTarget(), a);
        history.goTo(a);
        QCOMPARE(*history.redoTarget(), b);
        QVERIFY(history.childrenOf(b).empty());
    }

    void oldMomentsGoFirstAndThePresentOneNever()
    {
        History history(named("start"));
        for (int i = 1; i <= 6; ++i)
            history.append(named("entry"));
        history.setKey(2, true);
        history.goTo(4);
        QCOMPARE(history.memory(), std::size_t{7000});
        history.setMemory(5000);
        QCOMPARE(kept(history), (std::vector<bool>{true, false, true, false, true, true, true}));
        history.setMemory(3999);
        QCOMPARE(kept(history), (std::vector<bool>{true, false, true, false, true, false, false}));
        history.setMemory(2000);
        QCOMPARE(kept(history), (std::vector<bool>{true, false, false, false, true, false, false}));
        history.setMemory(0);
        QCOMPARE(kept(history), (std::vector<bool>{false, false, false, false, true, false, false}));
        QCOMPARE(history.memory(), std::size_t{1000});
        history.setMemory(3500);
        history.keep(3, std::make_shared<const Bytes>(1000));
        history.keep(3, std::make_shared<const Bytes>(1500));
        QCOMPARE(history.memory(), std::size_t{2500});
        history.append(named("more"));
        QCOMPARE(history.memory(), std::size_t{3500});
    }

    void waysDoNotCrossStarts()
    {
        History history(named("start"));
        HistoryRecord edit = named("edit");
        edit.commands = {{3, SetGravity{}}};
        history.append(edit);
        const Entry refilled = history.appendStart(named("refilled"), 1);
        const Entry after = history.append(edit);
        QCOMPARE(history.record(after).start, std::uint32_t{1});
        QCOMPARE(history.record(refilled).parent, Entry{1});
        QCOMPARE(history.wayTo(1).start, std::uint32_t{0});
        std::vector<HistoryRecord> records = history.records();
        for (HistoryRecord& record : records)
            record.moment = nullptr;
        const Way way = History(records, after).wayTo(after);
        QCOMPARE(way.start, std::uint32_t{1});
        QCOMPARE(way.commands.size(), std::size_t{1}); // of the entry itself, not of those before the refilling
        QVERIFY(!way.from);
    }

    void namesAndKeysChange()
    {
        History history(named("start"));
        const Entry entry = history.append(named("entry"));
        history.rename(entry, "flattened");
        history.setKey(entry, true);
        QCOMPARE(history.record(entry).name, std::string("flattened"));
        QVERIFY(history.record(entry).isKey);
    }

    void recordsThatAreNoTreeAreRefused()
    {
        std::vector<HistoryRecord> records{named("start"), named("a"), named("b")};
        QVERIFY_THROWS_EXCEPTION(std::runtime_error, History(std::vector<HistoryRecord>(), 0));
        QVERIFY_THROWS_EXCEPTION(std::runtime_error, History(records, 3));
        records[1].parent = 2;
        QVERIFY_THROWS_EXCEPTION(std::runtime_error, History(records, 0));
        records[1].parent = 1;
        QVERIFY_THROWS_EXCEPTION(std::runtime_error, History(records, 0));
    }

    void aHundredEntriesOfALargeBodyStayWithinMemory()
    {
        // Clay, whose every connection has lengths of its own; without a compressor.
        constexpr std::size_t memory = std::size_t{128} << 20U;
        Document document(scenes::smallPress(scenes::clay(), 29), memory);
        QVERIFY(document.simulation.snapshot()->objects >= 27'000);
        for (int i = 0; i < 100; ++i) {
            document.simulation.step();
            document.history.append(recordOf(endGesture(document.simulation), "step"));
            QVERIFY(document.history.memory() <= memory);
        }
        const std::vector<bool> has = kept(document.history);
        QVERIFY(has.front() && has.back() && !has[1]);
        QVERIFY(document.visit(99));
        QCOMPARE(document.repeated, 0);
        QVERIFY(document.visit(2));
        QCOMPARE(document.repeated, 1);
    }
};

QTEST_GUILESS_MAIN(HistoryTest)
#include "history_test.moc"
