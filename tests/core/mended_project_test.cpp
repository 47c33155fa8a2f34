// What becomes of a project whose window is gone, or whose moments are.
#include "core/document/history.h"
#include "core/document/mended_project.h"
#include "core/simulation/replay.h"
#include "support/scenes_of_every_kind.h"

#include <QTest>

using namespace knead;

namespace {

HistoryRecord runOn(Simulation& simulation, int steps, const std::string& name)
{
    for (int i = 0; i < steps; ++i)
        simulation.step();
    return recordOf(endGesture(simulation), name);
}

/// Three entries of a press, each after the other; and the simulation at the last one.
struct Work {
    explicit Work()
        : simulation(scenes::smallPress(scenes::soft(), 4))
    {
        project.starts = {{scenes::smallPress(scenes::soft(), 4), {0}}};
        for (const char* name : {"Open", "Push", "Push on"}) {
            HistoryRecord record = runOn(simulation, project.entries.empty() ? 0 : 20, name);
            record.parent = static_cast<std::uint32_t>(std::max<std::size_t>(project.entries.size(), 1) - 1);
            project.entries.push_back(std::move(record));
        }
        project.current = 2;
    }

    Simulation simulation;
    Project project;
};

std::uint64_t hashAtCurrent(const Project& project)
{
    const Way way = History(project.entries, project.current).wayTo(project.current);
    Simulation simulation(project.starts[way.start].scene);
    simulation.goTo(follow(way, project.starts[way.start].scene));
    return simulation.stateHash();
}

std::shared_ptr<const Bytes> noise()
{
    return std::make_shared<const Bytes>(1000, std::byte{7});
}

} // namespace

class MendedProjectTest : public QObject {
    Q_OBJECT
private slots:
    void aGestureUnderWayGoesOnWhereItWas()
    {
        Work work;
        work.simulation.post(SetGravity{Vec3(0, 0, -5)});
        for (int i = 0; i < 30; ++i)
            work.simulation.step();
        const WorkState state{.gesture = work.simulation.recording(), .step = work.simulation.stepCount()};
        const std::uint64_t hash = work.simulation.stateHash();

        const MendedProject mended = withGesture(work.project, state, {}, TaskControl::none());
        QVERIFY(mended.missing.empty());
        QCOMPARE(mended.project.entries.size(), std::size_t{4});
        QCOMPARE(mended.project.current, 3U);
        QCOMPARE(mended.project.entries[3].parent, 2U);
        QVERIFY(mended.project.entries[3].wallTime > 1.7e9);
        QCOMPARE(mended.project.entries[3].hash, hash);
        QCOMPARE(hashAtCurrent(mended.project), hash);
    }

    void withoutAGestureNothingIsAdded()
    {
        const Work work;
        QCOMPARE(withGesture(work.project, {}, {}, TaskControl::none()).project.entries.size(), std::size_t{3});
    }

    void aGestureThatCannotBeRepeatedIsMissing()
    {
        const Work work;
        const WorkState state{.gesture = {{3, SetGravity{}}}, .step = 10}; // before the entry that it follows
        const MendedProject mended = withGesture(work.project, state, {}, TaskControl::none());
        QCOMPARE(mended.missing.size(), std::size_t{1});
        QCOMPARE(mended.project.entries.size(), std::size_t{3});
        QCOMPARE(mended.project.current, 2U);
    }

    void anEntryThatIsWholeStays()
    {
        const Work work;
        const MendedProject mended = withReachableEntry(work.project, {}, TaskControl::none());
        QVERIFY(mended.missing.empty());
        QCOMPARE(mended.project.current, 2U);
    }

    void aDamagedMomentLeadsToTheEntryBefore()
    {
        Work work;
        work.project.entries[2].moment = noise();
        const MendedProject mended = withReachableEntry(work.project, {}, TaskControl::none());
        QCOMPARE(mended.missing.size(), std::size_t{1});
        QCOMPARE(mended.missing.front().english(), std::string("the state after \"Push on\""));
        QCOMPARE(mended.project.current, 1U);
        QCOMPARE(hashAtCurrent(mended.project), work.project.entries[1].hash);
    }

    void whenNoMomentIsWholeOnlyThePartsAre()
    {
        Work work;
        for (HistoryRecord& record : work.project.entries)
            record.moment = noise();
        const MendedProject mended = withReachableEntry(work.project, {}, TaskControl::none());
        QCOMPARE(mended.missing.size(), std::size_t{3});
        QVERIFY(mended.project.entries.empty());
        QVERIFY(mended.project.starts.empty());
    }
};

QTEST_GUILESS_MAIN(MendedProjectTest)
#include "mended_project_test.moc"
