#include "core/session/history_navigation.h"
#include "core/session/history_outline.h"
#include "core/session/timeline.h"
#include "core/simulation/moment.h"
#include "core/simulation/replay.h"
#include "support/scenes.h"

#include <QtTest>

using namespace knead;

namespace {

using Entry = History::Entry;

HistoryRecord at(double time, bool isReset = false)
{
    HistoryRecord record{.name = "entry", .time = time};
    if (isReset)
        record.commands = {{0, Reset{}}};
    return record;
}

std::uint64_t stepAt(double time)
{
    return static_cast<std::uint64_t>(1000 * time);
}

/// Objects at a time.
Snapshot frameAt(double time, std::size_t objects = 100, std::uint32_t resets = 0)
{
    Snapshot snapshot;
    snapshot.resets = resets;
    snapshot.time = time;
    snapshot.step = stepAt(time);
    snapshot.bodies.push_back({.positions = std::vector<Vec3>(objects, Vec3::Zero())});
    return snapshot;
}

std::vector<double> placesOf(const Timeline& line)
{
    std::vector<double> places;
    for (const Timeline::Tick& tick : line.ticks)
        places.push_back(tick.at);
    return places;
}

std::vector<Entry> entriesOf(const std::vector<OutlineRow>& rows)
{
    std::vector<Entry> entries;
    for (const OutlineRow& row : rows)
        entries.push_back(row.entry);
    return entries;
}

} // namespace

class TimelineTest : public QObject {
    Q_OBJECT

private slots:
    void framesBelongToTheEntryTheyLeadTo()
    {
        PlaybackCache film;
        for (int i = 0; i <= 30; ++i)
            film.add(frameAt(i / 30.0));
        QCOMPARE(film.underWay().size(), std::size_t{31});
        film.append(1, stepAt(0.5));
        QVERIFY(film.framesOf(1).back()->time <= 0.5);
        QVERIFY(film.underWay().front()->time > 0.5);
        film.append(2, stepAt(1));
        QVERIFY(film.underWay().empty());
        QVERIFY(film.framesOf(7).empty());
    }

    /// Sixty frames a second are seen, thirty are kept; none between is lost at the end.
    void theLastFrameOfAnEntryIsKept()
    {
        for (const int last : {30, 31}) {
            PlaybackCache film;
            for (int i = 0; i <= last; ++i)
                film.see(std::make_shared<Snapshot>(frameAt(i / 60.0)));
            QCOMPARE(film.underWay().size(), std::size_t{16});
            film.append(1, stepAt(last / 60.0));
            QVERIFY(film.underWay().empty());
            QCOMPARE(film.framesOf(1).back()->time, last / 60.0);
            QCOMPARE(film.framesOf(1).size(), std::size_t{16} + (last == 31 ? 1 : 0));
        }
        PlaybackCache film;
        film.see(std::make_shared<Snapshot>(frameAt(0)));
        film.see(std::make_shared<Snapshot>(frameAt(1 / 60.0)));
        film.dropUnderWay();
        film.append(1, stepAt(1 / 60.0)); // of another way
        QVERIFY(film.framesOf(1).empty());
        film.see(std::make_shared<Snapshot>(frameAt(0)));
        film.see(std::make_shared<Snapshot>(frameAt(1 / 60.0)));
        film.append(2, 0);
        QCOMPARE(film.framesOf(2).size(), std::size_t{1});
    }

    void aBranchBeginsWithTheFramesOfTheOther()
    {
        PlaybackCache film;
        for (int i = 0; i <= 30; ++i)
            film.add(frameAt(i / 30.0));
        film.append(1, stepAt(1));
        const std::size_t before = film.memory();
        film.repeat(1, 500);
        film.append(2, stepAt(0.5));
        QCOMPARE(film.framesOf(1).size(), std::size_t{31});
        QCOMPARE(film.framesOf(2).back(), film.framesOf(1)[15]);
        QVERIFY(film.underWay().empty() && film.memory() > before);
    }

    /// A minute in which nothing moves is two frames: where it begins, and where it ends.
    void aRestTakesTwoFrames()
    {
        PlaybackCache film;
        const auto see = [&](double time, std::uint64_t rest) {
            Snapshot shot = frameAt(time);
            shot.rest = rest;
            film.see(std::make_shared<const Snapshot>(std::move(shot)));
        };
        see(0, 0);
        see(0.1, 0);
        for (int i = 0; i < 3600; ++i)
            see(0.2 + i / 60.0, 7);
        QCOMPARE(film.underWay().size(), std::size_t{3});
        see(61, 0);
        std::vector<double> times;
        for (const PlaybackFramePointer& frame : film.underWay())
            times.push_back(frame->time);
        QCOMPARE(times, (std::vector<double>{0, 0.1, 0.2, 0.2 + 3599 / 60.0, 61}));
        see(61.1, 8); // another rest is another pair
        see(62.1, 8);
        see(62.2, 9);
        QCOMPARE(film.underWay().size(), std::size_t{8});
    }

    void aFilmThatIsTooLongLosesItsOldFramesByAndBy()
    {
        PlaybackCache film;
        constexpr std::size_t memory = 100'000;
        film.setMemory(memory);
        for (int i = 0; i < 3000; ++i) {
            film.add(frameAt(i / 20.0));
            QVERIFY(film.memory() <= memory);
            if (i % 200 == 199)
                film.append(static_cast<Entry>(i / 200), stepAt(i / 20.0));
        }
        QVERIFY(!film.framesOf(14).empty());
        QVERIFY(film.framesOf(14).size() > film.framesOf(1).size());
        QVERIFY(film.memory() > memory / 3);
        film.forget();
        QCOMPARE(film.memory(), std::size_t{0});
    }

    void oneFrameThatIsTooLargeIsNotKept()
    {
        PlaybackCache film;
        film.setMemory(1000);
        film.add(frameAt(0, 10'000));
        QCOMPARE(film.memory(), std::size_t{0});
    }

    void theWayShownLeadsThroughThePresent()
    {
        History history(at(0));
        const Entry a = history.append(at(1));
        const Entry b = history.append(at(3));
        history.goTo(a);
        history.append(at(1.5));
        history.goTo(b);
        history.goTo(a);
        Timeline line = timelineOf(history, {}, false);
        QCOMPARE(placesOf(line), (std::vector<double>{0, 1, 3}));
        QCOMPARE(line.present, 1.0);
        QCOMPARE(line.end, 3.0);
        QCOMPARE(line.tickNear(2.9, 0.2)->entry, b);
        QVERIFY(line.tickNear(2, 0.2) == nullptr);
        line = timelineOf(history, {}, true); // what was ahead is no longer
        QCOMPARE(line.end, 1.0);
    }

    void timeGoesOnAfterAReset()
    {
        History history(at(0));
        history.append(at(2));
        history.append(at(0, true));
        history.append(at(0.5));
        const Timeline line = timelineOf(history, {}, false);
        QCOMPARE(placesOf(line), (std::vector<double>{0, 2, 2, 2.5}));
    }

    /// It went on to 0.9 s, was in trouble, and went back to 0.5 s; then it was reset, and ran for 0.2 s.
    void whatWasSeenBeforeTroubleBelongsToItsEntry()
    {
        History history(at(0));
        PlaybackCache film;
        for (int i = 0; i <= 9; ++i)
            film.add(frameAt(i / 10.0));
        const Entry run = history.append(at(0.5));
        film.append(run, stepAt(0.95));
        QVERIFY(film.underWay().empty());
        Timeline line = timelineOf(history, film, false);
        QCOMPARE(line.present, 0.9);
        QCOMPARE(line.pictures.size(), std::size_t{10});
        const Entry reset = history.append(at(0, true));
        film.append(reset, 0, 1);
        QVERIFY(film.framesOf(reset).empty());
        for (int i = 0; i <= 2; ++i)
            film.add(frameAt(i / 10.0, 100, 1));
        const Entry again = history.append(at(0.2));
        film.append(again, stepAt(0.2));
        QCOMPARE(film.framesOf(run).size(), std::size_t{10});
        QCOMPARE(film.framesOf(again).size(), std::size_t{3});
        line = timelineOf(history, film, false);
        QCOMPARE(placesOf(line), (std::vector<double>{0, 0.9, 0.9, 1.1}));
        QCOMPARE(line.pictures.back().at, 1.1);
    }

    void timeGoesOnAfterAResetWithinAnEntry()
    {
        History history(at(0));
        PlaybackCache film;
        for (const std::uint32_t run : {0U, 1U, 2U})
            for (const double time : {0.25, 0.5})
                film.add(frameAt(time, 1, run));
        film.append(history.append(at(0.5, true)), stepAt(0.5), 1);
        QCOMPARE(film.framesOf(1).size(), std::size_t{4});
        film.append(history.append(at(0, true)), stepAt(0), 1); // nothing is seen of it
        film.append(history.append(at(0.5)), stepAt(0.5));
        QCOMPARE(film.framesOf(3).size(), std::size_t{2});
        QVERIFY(film.underWay().empty());
        film.add(frameAt(0.75, 1, 2));
        const Timeline line = timelineOf(history, film, true);
        QCOMPARE(placesOf(line), (std::vector<double>{0, 1, 1, 1.5}));
        std::vector<double> places;
        std::vector<std::uint32_t> runs;
        for (const Timeline::Picture& picture : line.pictures) {
            places.push_back(picture.at);
            runs.push_back(picture.run);
        }
        QCOMPARE(places, (std::vector<double>{0.25, 0.5, 0.75, 1, 1.25, 1.5, 1.75}));
        QCOMPARE(runs, (std::vector<std::uint32_t>{0, 0, 1, 1, 0, 0, 0}));

        film.dropUnderWay(); // a branch from the second run of the first one
        film.repeat(1, 250, 1);
        history.goTo(0);
        film.append(history.append(at(0.25, true)), stepAt(0.25), 1);
        QCOMPARE(film.framesOf(4).size(), std::size_t{3});
        QCOMPARE(film.framesOf(4)[2], film.framesOf(1)[2]);
        film.repeat(1, 250, 0); // and one from the first run
        film.append(history.append(at(0.25)), stepAt(0.25));
        QCOMPARE(film.framesOf(5).size(), std::size_t{1});
    }

    void aBranchBeginsInTheRunOneLookedAt()
    {
        Scene scene;
        scene.bodies.push_back(scenes::box({3, 3, 3}, 2e-3));
        HistoryNavigation navigation;
        Simulation simulation(scene);
        const HistoryRecord first = recordOf(endGesture(simulation), "start");
        std::vector<std::uint64_t> hashes;
        simulation.post(SetGravity{Vec3(0, 0, -1)});
        for (const std::uint64_t steps : {30U, 20U}) {
            for (std::uint64_t i = 0; i < steps; ++i) {
                simulation.step();
                if (i + 1 == 10)
                    hashes.push_back(simulation.stateHash());
            }
            simulation.post(Reset{});
            simulation.post(SetGravity{Vec3(0, 3, 0)});
        }
        simulation.step();
        const Gesture gesture = endGesture(simulation);
        navigation.way = History(first).wayTo(0);
        navigation.start.start.scene = scene;
        for (std::uint32_t run = 0; run < 2; ++run) {
            const Branch branch = navigation.branch(gesture.commands, run, 10, TaskControl::none());
            QCOMPARE(branch.gesture.moment->steps.count, std::uint64_t{10});
            QCOMPARE(branch.gesture.hash, hashes[run]);
            QCOMPARE(resetsIn(branch.gesture.commands), run);
        }
    }

    /// A finger that the stroke would have lifted at its end, and the other hand, are let go of; what a recipe would have taken away stays.
    void aBranchWithinAStrokeIsWithoutItsFingers()
    {
        Scene scene;
        scene.bodies.push_back(scenes::box({3, 3, 3}, 2e-3));
        Simulation simulation(scene);
        const HistoryRecord first = recordOf(endGesture(simulation), "start");
        Manipulator finger{.name = "Finger 1", .size = Vec3::Constant(2e-3)};
        finger.pose.position = Vec3(0, 0, 0.1);
        Manipulator block = finger;
        block.name = "Block 1";
        simulation.post(AddManipulator{finger});
        simulation.post(AddManipulator{block});
        simulation.post(AddFixture{{"Other hand 1", 0, {0, 1}}});
        simulation.post(AddFixture{{"Vice", 0, {2, 3}}});
        for (int i = 0; i < 20; ++i)
            simulation.step();
        const std::shared_ptr<const Snapshot> all = simulation.snapshot();
        for (const ToolState& tool : all->tools) // the block and the vice as a recipe does
            simulation.post(RemoveManipulator{tool.id});
        for (const FixtureId fixture : all->fixtureIds)
            simulation.post(RemoveFixture{fixture});
        simulation.step();
        const Gesture stroke = endGesture(simulation);
        HistoryNavigation navigation;
        navigation.way = History(first).wayTo(0);
        navigation.start.start.scene = scene;
        const Gesture branch = navigation.branch(stroke.commands, 0, 10, TaskControl::none()).gesture;
        Simulation there(scene);
        there.goTo(branch.moment);
        QCOMPARE(there.stepCount(), std::uint64_t{10});
        QCOMPARE(there.snapshot()->tools.size(), std::size_t{1});
        QCOMPARE(there.snapshot()->tools[0].name, std::string("Block 1"));
        QCOMPARE(there.snapshot()->fixtures.size(), std::size_t{1});
        QCOMPARE(there.snapshot()->fixtures[0].name, std::string("Vice"));
        QCOMPARE(replay(Simulation(scene), branch.commands, 10).stateHash(), branch.hash); // as it is kept
    }

    void anotherStartBeginsAnotherLine()
    {
        History history(at(0));
        history.append(at(2));
        const Entry refilled = history.appendStart(at(0), 1);
        history.append(at(1));
        QCOMPARE(placesOf(timelineOf(history, {}, false)), (std::vector<double>{0, 1}));
        history.goTo(0);
        QCOMPARE(placesOf(timelineOf(history, {}, false)), (std::vector<double>{0, 2}));
        history.goTo(refilled);
        QCOMPARE(timelineOf(history, {}, false).present, 0.0);
    }

    void picturesLieWhereTheyWereTaken()
    {
        History history(at(0));
        PlaybackCache film;
        film.add(frameAt(0.5));
        film.add(frameAt(1));
        film.append(history.append(at(1)), stepAt(1));
        film.add(frameAt(1.25));
        const Timeline line = timelineOf(history, film, true);
        QCOMPARE(line.pictures.size(), std::size_t{3});
        QCOMPARE(line.pictures[0].entry, Entry{1});
        QVERIFY(!line.pictures[1].isUnderWay && line.pictures[2].isUnderWay);
        QCOMPARE(line.present, 1.25);
        QCOMPARE(line.end, 1.25);
        QCOMPARE(line.pictureAt(0.1)->at, 0.5);
        QCOMPARE(line.pictureAt(1.1)->at, 1.0);
        QCOMPARE(line.pictureAt(9)->at, 1.25);
        QVERIFY(timelineOf(history, {}, false).pictureAt(0) == nullptr);
    }

    void fillingsAreMarkedWhereTheyWereSeenFirst()
    {
        const std::shared_ptr<const Aggregate> opened = std::make_shared<const Aggregate>();
        const std::shared_ptr<const Aggregate> later = std::make_shared<const Aggregate>();
        const auto shot = [](double time, const std::shared_ptr<const Aggregate>& filling, std::uint32_t resets = 0) {
            Snapshot snapshot = frameAt(time, 100, resets);
            snapshot.bodies[0].aggregate = filling;
            return snapshot;
        };
        History history(at(0));
        PlaybackCache film;
        film.add(shot(0.5, opened));
        film.add(shot(1, opened));
        film.append(history.append(at(1)), stepAt(1));
        film.add(shot(1.25, later));
        film.add(shot(1.5, later));
        film.add(shot(0.25, opened, 1)); // a reset takes the first filling again, which is none
        const Timeline line = timelineOf(history, film, true);
        QCOMPARE(line.fillings, std::vector{1.25});
        QVERIFY(line.isFilledAnewAt(1.2, 0.06) && line.isFilledAnewAt(1.3, 0.06));
        QVERIFY(!line.isFilledAnewAt(1.2, 0.04) && !line.isFilledAnewAt(1.3, 0.04));
    }

    void betweenPicturesThingsMoveStraight()
    {
        const auto shot = [](double time, double x) {
            Snapshot snapshot = frameAt(time, 2);
            snapshot.bodies[0].positions[1] = Vec3(x, 2, 3);
            snapshot.tools.push_back({.id = 1});
            snapshot.tools[0].pose.position = Vec3(0, x, 0);
            snapshot.tools[0].pose.rotation = Quaternion(Eigen::AngleAxisd(x, Vec3::UnitZ()));
            return snapshot;
        };
        History history(at(0));
        PlaybackCache film;
        film.add(shot(0, 0));
        film.add(shot(0.1, 1));
        film.add(shot(0.9, 2));
        film.append(history.append(at(1)), stepAt(1));
        const Timeline line = timelineOf(history, film, false);
        const PlaybackFramePointer frame = line.frameAt(0.025);
        QCOMPARE(frame->objects[0][3], 0.25F);
        QCOMPARE(frame->objects[0][4], 2.0F);
        QCOMPARE(frame->time, 0.025);
        QCOMPARE(frame->tools[0].pose.position.y(), 0.25);
        QVERIFY(frame->tools[0].pose.rotation.isApprox(Quaternion(Eigen::AngleAxisd(0.25, Vec3::UnitZ()))));
        QCOMPARE(line.frameAt(0.5), line.pictures[1].frame); // too far apart
        QCOMPARE(line.frameAt(2), line.pictures[2].frame);
        QVERIFY(timelineOf(history, {}, false).frameAt(0) == nullptr);
    }

    void whatWasUndoneMovesAside()
    {
        History history(at(0));
        const Entry a = history.append(at(1));
        const Entry b = history.append(at(2));
        history.goTo(a);
        const Entry c = history.append(at(3));
        const Entry d = history.append(at(4));
        history.goTo(0);
        const Entry e = history.append(at(5));
        const std::vector<OutlineRow> rows = outlineOf(history);
        QCOMPARE(entriesOf(rows), (std::vector<Entry>{0, e}));
        QCOMPARE(rows[0].branches.size(), std::size_t{1});
        const std::vector<OutlineRow>& older = rows[0].branches[0];
        QCOMPARE(entriesOf(older), (std::vector<Entry>{a, c, d}));
        QCOMPARE(entriesOf(older[0].branches.at(0)), std::vector<Entry>{b});
    }
};

QTEST_GUILESS_MAIN(TimelineTest)
#include "timeline_test.moc"
