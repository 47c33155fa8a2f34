// Proof of a history: its commands, repeated, come to the states that are kept.
#include "core/document/history_replay.h"
#include "support/random_session.h"

#include <QTest>

#include <atomic>
#include <numeric>

using namespace knead;
using namespace knead::sessions;

namespace {

using Whole = RepeatedEntry::Whole;

struct StillEdit {
    const char* name;
    Command command;
};
const StillEdit stillEdits[] = {
    {"material", SetMaterial{0, scenes::clay(), {}}},
    {"material of some objects", SetMaterial{0, scenes::clay(), {1, 2, 3}}},
    {"gravity", SetGravity{Vec3(0, 0, -3)}},
    {"floor", SetFloor{-0.5, 0.1}},
    {"tool", AddManipulator{{.name = "far", .size = Vec3::Constant(0.001), .pose = scenes::placedAt(Vec3(0, 0, 1))}}},
    {"fixture", AddFixture{{"grip", 0, {0, 1, 2}}}},
    {"re-normalization", Renormalize{0, {}, 0.01}},
    {"integrator", SetIntegrator{Integrator::implicitEuler}},
};

std::vector<RepeatedEntry> repeatAll(const Project& project, HistoryReplay::From from = HistoryReplay::From::starts)
{
    HistoryReplay replay(project, from);
    std::set<Entry> all;
    for (Entry entry = 0; entry < project.entries.size(); ++entry)
        all.insert(entry);
    std::vector<RepeatedEntry> repeated;
    for (const Entry entry : all)
        repeated.push_back(replay.repeat(entry, TaskControl::none(), all));
    return repeated;
}

std::vector<bool> sameness(const std::vector<RepeatedEntry>& repeated)
{
    std::vector<bool> same;
    for (const RepeatedEntry& entry : repeated)
        same.push_back(entry.isSame);
    return same;
}

} // namespace

class HistoryReplayTest : public QObject {
    Q_OBJECT

private slots:
    void everyEntryOfEveryBranchIsTheSame_data()
    {
        QTest::addColumn<int>("seed");
        for (int seed = 1; seed <= 6; ++seed)
            QTest::addRow("%d", seed) << seed;
    }
    void everyEntryOfEveryBranchIsTheSame()
    {
        QFETCH(int, seed);
        const Project project = projectOf(branchedDocument(twoLumps(), static_cast<std::uint64_t>(seed), 25));
        const std::vector<bool> all(project.entries.size(), true);
        QCOMPARE(sameness(repeatAll(withoutMoments(project))), all);
        QCOMPARE(sameness(repeatAll(project)), all);
        QCOMPARE(sameness(repeatAll(project, HistoryReplay::From::moments)), all);
        // One alone comes to the same state.
        HistoryReplay alone(project);
        QVERIFY(alone.repeat(project.current, TaskControl::none()).isSame);
        QCOMPARE(alone.snapshot()->step, project.entries[project.current].step);
    }

    void momentsAreNotBelieved()
    {
        Project project = projectOf(branchedDocument(twoLumps(), 7, 6, 100));
        Simulation falling(twoLumps());
        falling.post(SetGravity{Vec3(0, 0, -50)});
        while (falling.stepCount() < project.entries[3].step)
            falling.step();
        project.entries[3].moment = recordOf(endGesture(falling), "").moment;
        std::vector<bool> allButOne(project.entries.size(), true);
        allButOne[3] = false;
        const std::vector<RepeatedEntry> repeated = repeatAll(project);
        QCOMPARE(sameness(repeated), allButOne);
        QCOMPARE(repeated[3].hash, project.entries[3].hash); // what its commands lead to
        QVERIFY(repeated[3].whole == Whole::different);
        QVERIFY(!repeatAll(project, HistoryReplay::From::moments)[3].isSame);
    }

    /// Edits while time stands still, which move nothing.
    void everythingAtAnEntryIsCompared_data()
    {
        QTest::addColumn<int>("edit");
        for (int edit = 0; edit < static_cast<int>(std::size(stillEdits)); ++edit)
            QTest::addRow("%s", stillEdits[edit].name) << edit;
    }
    void everythingAtAnEntryIsCompared()
    {
        QFETCH(int, edit);
        Document document(twoLumps());
        document.simulation.post(stillEdits[edit].command);
        document.simulation.applyCommands();
        document.history.append(recordOf(endGesture(document.simulation), "edit"));
        Project project = projectOf(document);
        RepeatedEntry repeated = repeatAll(project)[1];
        QVERIFY(repeated.isSame && repeated.whole == Whole::same);

        project.entries[1].commands.erase(project.entries[1].commands.begin());
        repeated = repeatAll(project)[1];
        QCOMPARE(repeated.hash, project.entries[1].hash);
        QVERIFY(!repeated.isSame && repeated.whole == Whole::different);
        project.entries[1].moment = nullptr;
        repeated = repeatAll(project)[1];
        QVERIFY(repeated.isSame && repeated.whole == Whole::notKept);
    }

    void lookingAtARunChangesNothing()
    {
        Document document(scenes::smallPress(scenes::soft(), 5));
        for (int step = 0; step < 100; ++step) {
            document.simulation.step();
            if (step % 7 == 0)
                document.simulation.snapshot(); // means of forces are counted anew
        }
        document.history.append(recordOf(endGesture(document.simulation), "press"));
        const Project project = projectOf(document);
        QVERIFY(document.simulation.snapshot()->tools.at(0).peakForce > 0);
        QVERIFY(repeatAll(project)[1].whole == Whole::same);
        QVERIFY(repeatAll(project, HistoryReplay::From::moments)[1].whole == Whole::same);
    }

    void aMomentThatCannotBeReadIsAnotherOne()
    {
        Project project = projectOf(branchedDocument(twoLumps(), 12, 4));
        Bytes bytes = *project.entries[2].moment;
        bytes[bytes.size() / 2] ^= std::byte{1};
        project.entries[2].moment = std::make_shared<const Bytes>(bytes);
        const std::vector<RepeatedEntry> repeated = repeatAll(project);
        QVERIFY(repeated[2].trouble.empty() && repeated[2].whole == Whole::different && !repeated[2].isSame);
    }

    void whatDiffersIsTold()
    {
        Project project = projectOf(branchedDocument(twoLumps(), 8, 6));
        const std::uint64_t hash = project.entries[2].hash;
        project.entries[2].hash += 1;
        std::vector<RepeatedEntry> repeated = repeatAll(project);
        QVERIFY(!repeated[2].isSame && repeated[2].trouble.empty());
        QCOMPARE(repeated[2].hash, hash);
        QVERIFY(repeated[1].isSame && repeated[3].isSame);

        project.entries[2].hash = hash;
        project.entries[1].commands.insert(project.entries[1].commands.begin(), {0, SetGravity{Vec3(0, 0, -3)}});
        repeated = repeatAll(project);
        QVERIFY(project.entries[1].step > 0 && repeated[0].isSame && !repeated[1].isSame);
    }

    void whatFollowsAnEntryThatIsNotReachedIsNotTried()
    {
        Project project = projectOf(branchedDocument(twoLumps(), 9, 4));
        // A step that lies in the past of the run is never reached.
        for (std::size_t i = 1; i < project.entries.size(); ++i)
            project.entries[i].parent = static_cast<std::uint32_t>(i - 1);
        project.entries[1].commands = {{40, SetGravity{}}, {20, SetGravity{}}};
        const std::vector<RepeatedEntry> repeated = repeatAll(project);
        QVERIFY(repeated[0].isSame);
        QVERIFY2(repeated[1].trouble.english().starts_with("The recording does not belong to this scene"),
                 repeated[1].trouble.english().c_str());
        QCOMPARE(repeated[2].trouble.english(), std::string("The entry before it was not reached."));
    }

    void everyStartIsRepeatedFromItsOwnScene()
    {
        Document document(twoLumps());
        fuzz::Random random(10);
        document.doSomething(random, 30);
        Project project = projectOf(document);
        Document refilled(scenes::smallPress(scenes::soft(), 5));
        refilled.doSomething(random, 30);
        project.starts.push_back({refilled.scene, {}});
        for (HistoryRecord record : refilled.history.records()) {
            record.parent = static_cast<std::uint32_t>(project.entries.size() - 1);
            record.start = 1;
            project.entries.push_back(record);
        }
        QCOMPARE(sameness(repeatAll(project)), std::vector<bool>(4, true));
    }

    void aProjectWithoutHistoryIsRefused()
    {
        const Project project;
        QVERIFY_THROWS_EXCEPTION(std::runtime_error, HistoryReplay{project});
    }

    void cancelledAtOnce()
    {
        struct Cancels final : TaskControl {
            void report(double, std::string_view) override { ++reports; }
            bool isCancelled() const override { return true; }
            int reports = 0;
        };
        const Project project = projectOf(branchedDocument(twoLumps(), 11, 6, 200));
        Cancels control;
        HistoryReplay replay(project);
        QVERIFY_THROWS_EXCEPTION(Cancelled, replay.repeat(project.current, control));
    }
};

QTEST_GUILESS_MAIN(HistoryReplayTest)
#include "history_replay_test.moc"
