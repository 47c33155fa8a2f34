// The tree of what was done: undo, redo, branches, thinning, and the same bits again.
#include "core/document/history.h"
#include "core/simulation/replay.h"
#include "support/random_session.h"

#include <QTest>

using namespace knead;
using namespace knead::sessions;

namespace {

using Entry = History::Entry;

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

    /// Else each undo after hours of work would repeat all of them.
    void commandsLeaveRoomForMoments()
    {
        HistoryRecord busy = named("stroke");
        busy.commands.assign(100, {1, SetGravity{}});
        constexpr std::size_t limit = 8000;
        History history(named("start"), limit);
        for (int i = 0; i < 20; ++i)
            history.append(busy);
        QVERIFY(history.memory() > limit);
        const std::vector<bool> all = kept(history);
        QCOMPARE(std::count(all.begin(), all.end(), true), std::ptrdiff_t{4});
        QVERIFY(history.wayTo(*history.undoTarget()).commands.empty());
        QCOMPARE(history.wayTo(3).commands.size(), std::size_t{300});
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

    /// As long as nobody gave an entry a name of her own.
    void entriesAreCalledBySentences()
    {
        const Message words = Message("EntryNames", "Add %1").with("Block 1");
        HistoryRecord record{.name = words.english(), .words = words};
        QCOMPARE(record.label(), words);
        QCOMPARE(named("as an earlier version wrote it").label(), Message::verbatim("as an earlier version wrote it"));
        History history(named("start"));
        const Entry entry = history.append(std::move(record));
        QCOMPARE(history.record(entry).label(), words);
        history.rename(entry, "flattened");
        QCOMPARE(history.record(entry).label(), Message::verbatim("flattened"));
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
