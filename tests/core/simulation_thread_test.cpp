#include "core/simulation/moment.h"
#include "core/simulation/replay.h"
#include "core/simulation/simulation_thread.h"
#include "support/scenes.h"

#include <QTest>

#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <mutex>
#include <stdexcept>
#include <utility>

using namespace knead;

namespace {

Scene falling()
{
    Scene scene;
    scene.bodies.push_back(scenes::box({4, 4, 4}, 2e-3));
    scene.gravity = Vec3(0, 0, -1);
    return scene;
}

/// Gravity turns at a step, and a later step is the end.
class TwoThings final : public ScriptedEvents {
public:
    static constexpr std::uint64_t turn = 20;
    static constexpr std::uint64_t end = 50;

    bool carryOutDue(Simulation& simulation) override
    {
        if (simulation.stepCount() == turn)
            simulation.post(SetGravity{Vec3(0, 2, 0)});
        return simulation.stepCount() == end && !std::exchange(m_hasEnded, true);
    }
    void ended(const Gesture& gesture) override { m_last = gesture.moment->steps.count; }
    void wentTo(const Moment& moment, std::uint64_t) override { m_hasEnded = moment.steps.count > m_last; }

private:
    bool m_hasEnded = false;
    std::uint64_t m_last = 0;
};

/// Cannot go on at a step.
class Failing final : public ScriptedEvents {
public:
    bool carryOutDue(Simulation& simulation) override
    {
        if (simulation.stepCount() == 20)
            throw std::runtime_error("the file of the recipe is gone.");
        return false;
    }
    void ended(const Gesture& /*gesture*/) override {}
    void wentTo(const Moment& /*moment*/, std::uint64_t /*hash*/) override {}
};

/// Waits for a snapshot that fulfils a condition; null when none comes.
SnapshotPointer waitFor(const SimulationThread& thread, const std::function<bool(const Snapshot&)>& condition)
{
    SnapshotPointer found;
    [[maybe_unused]] const bool came = QTest::qWaitFor(
        [&] {
            const SnapshotPointer latest = thread.latest();
            if (condition(*latest))
                found = latest;
            return found != nullptr;
        },
        20'000);
    return found;
}

/// Gestures that a simulation's thread hands over.
class Gestures {
public:
    std::function<void(Gesture)> taker()
    {
        return [this](Gesture gesture) {
            const std::lock_guard lock(m_mutex);
            m_gestures.push_back(std::move(gesture));
            m_came.notify_one();
        };
    }

    Gesture next()
    {
        std::unique_lock lock(m_mutex);
        m_came.wait(lock, [this] { return !m_gestures.empty(); });
        Gesture gesture = std::move(m_gestures.front());
        m_gestures.pop_front();
        return gesture;
    }

private:
    std::mutex m_mutex;
    std::condition_variable m_came;
    std::deque<Gesture> m_gestures;
};

} // namespace

class SimulationThreadTest : public QObject {
    Q_OBJECT

private slots:
    void startsPausedWithAState()
    {
        const SimulationThread thread{Simulation(falling())};
        QVERIFY(thread.latest());
        QVERIFY(!thread.latest()->playing);
        QCOMPARE(thread.latest()->step, std::uint64_t{0});
        QCOMPARE(thread.latest()->objects, std::size_t{125});
    }

    void playsInRealTimeAndPauses()
    {
        SimulationThread thread{Simulation(falling())};
        thread.play();
        const auto playing = waitFor(thread, [](const Snapshot& shot) { return shot.playing && shot.time > 0.3; });
        QVERIFY(playing);
        QVERIFY(playing->ratio > 0.05 && playing->ratio < 1.2);
        QVERIFY(playing->updatesPerSecond > 1 && playing->updatesPerSecond < 70);
        QVERIFY(playing->stepsPerFrame > 0);
        thread.pause();
        QVERIFY(waitFor(thread, [](const Snapshot& shot) { return !shot.playing; }));
        const auto paused = thread.latest()->step;
        QTest::qWait(80);
        QCOMPARE(thread.latest()->step, paused);
    }

    void anExceptionBecomesAMessage()
    {
        SimulationThread thread{Simulation(falling()), std::make_unique<Failing>()};
        thread.play();
        const auto stopped = waitFor(thread, [](const Snapshot& shot) { return !shot.health.ok; });
        QVERIFY(stopped);
        QVERIFY(!stopped->playing);
        QCOMPARE(stopped->health.trouble, Trouble::failed);
        QVERIFY2(stopped->health.message.english().find("the file of the recipe is gone. Reset") != std::string::npos,
                 stopped->health.message.english().c_str());
        thread.reset();
        QVERIFY(waitFor(thread, [](const Snapshot& shot) { return shot.health.ok && shot.step == 0; }));
        thread.stepOnce();
        QVERIFY(waitFor(thread, [](const Snapshot& shot) { return shot.step == 1; }));
    }

    void aWatcherThatThrowsDoesNotEndTheThread()
    {
        SimulationThread thread{Simulation(falling())};
        thread.watch([](const SnapshotPointer&) { throw std::runtime_error("nobody looks."); });
        QVERIFY(waitFor(thread, [](const Snapshot& shot) { return !shot.health.ok; }));
        thread.watch([](const SnapshotPointer&) {});
        thread.reset();
        QVERIFY(waitFor(thread, [](const Snapshot& shot) { return shot.health.ok && shot.step == 0; }));
    }

    void commandsReachAPausedSimulation()
    {
        SimulationThread thread{Simulation(falling())};
        thread.post(AddManipulator{{.name = "block"}});
        const auto shot = waitFor(thread, [](const Snapshot& s) { return !s.tools.empty(); });
        QVERIFY(shot);
        QCOMPARE(shot->tools[0].name, std::string("block"));
        QCOMPARE(shot->step, std::uint64_t{0});
    }

    void anAgendaIsCarriedOutAndEnds()
    {
        Gestures gestures;
        SimulationThread thread{Simulation(falling()), std::make_unique<TwoThings>()};
        thread.endGesture(gestures.taker());
        const MomentPointer start = gestures.next().moment;
        std::vector<std::uint64_t> hashes;
        for (int time = 0; time < 2; ++time) {
            thread.play();
            QVERIFY(waitFor(thread, [](const Snapshot& shot) { return !shot.playing && shot.step == TwoThings::end; }));
            thread.endGesture(gestures.taker());
            const Gesture gesture = gestures.next();
            QCOMPARE(gesture.commands.front().step, TwoThings::turn);
            hashes.push_back(gesture.hash);
            thread.play(); // once it is over, time goes on
            QVERIFY(waitFor(thread, [](const Snapshot& shot) { return shot.step > TwoThings::end + 5; }));
            thread.goTo(start);
        }
        QCOMPARE(hashes[0], hashes[1]);
    }

    void stepsStopAtTheEndOfAnAgendaOnce()
    {
        SimulationThread thread{Simulation(falling()), std::make_unique<TwoThings>()};
        const auto stepTo = [&](std::uint64_t requests) {
            while (thread.requests() < requests)
                thread.stepOnce();
            return waitFor(thread, [&](const Snapshot& shot) { return shot.requests == requests; });
        };
        QCOMPARE(stepTo(TwoThings::end)->step, TwoThings::end);
        QCOMPARE(thread.latest()->scriptEnds, std::uint64_t{0});
        QCOMPARE(stepTo(TwoThings::end + 1)->step, TwoThings::end);
        QCOMPARE(thread.latest()->scriptEnds, std::uint64_t{1});
        QCOMPARE(stepTo(TwoThings::end + 2)->step, TwoThings::end + 1); // once it was said, time goes on
        QCOMPARE(thread.latest()->scriptEnds, std::uint64_t{1});
    }

    void stepsOnceWhilePaused()
    {
        SimulationThread thread{Simulation(falling())};
        thread.stepOnce();
        QVERIFY(waitFor(thread, [](const Snapshot& shot) { return shot.step == 1; }));
    }

    void resetGoesBackToTheStart()
    {
        SimulationThread thread{Simulation(falling())};
        thread.play();
        QVERIFY(waitFor(thread, [](const Snapshot& shot) { return shot.step > 100; }));
        thread.reset();
        const auto shot = waitFor(thread, [](const Snapshot& s) { return s.step == 0 && !s.playing; });
        QVERIFY(shot);
        for (const Vec3& displacement : shot->bodies[0].displacements())
            QCOMPARE(displacement.norm(), 0.0);
    }

    void resetIsPartOfTheRecording()
    {
        Gestures gestures;
        SimulationThread thread{Simulation(falling())};
        thread.stepOnce();
        thread.reset();
        thread.stepOnce();
        thread.endGesture(gestures.taker());
        const Gesture gesture = gestures.next();
        QCOMPARE(gesture.commands.size(), std::size_t{2});
        QVERIFY(std::holds_alternative<Reset>(gesture.commands[0].command));
        QCOMPARE(gesture.commands[0].step, std::uint64_t{1});
        QVERIFY(std::holds_alternative<KeepMoment>(gesture.commands[1].command));
        QCOMPARE(gesture.moment->steps.count, std::uint64_t{1});
    }

    void gesturesThatEndWhilePlayingRepeat()
    {
        Gestures gestures;
        SimulationThread thread{Simulation(falling())};
        thread.play();
        for (int i = 0; i < 3; ++i) {
            QVERIFY(waitFor(thread, [&](const Snapshot& shot) { return shot.time > 0.05 * (i + 1); }));
            thread.post(SetGravity{Vec3(0, 0.1 * i, -1)});
            thread.endGesture(gestures.taker());
        }
        Simulation simulation(falling());
        for (int i = 0; i < 3; ++i) {
            const Gesture gesture = gestures.next();
            QCOMPARE(gesture.commands.size(), std::size_t{2}); // what was posted before belongs to it
            simulation = replay(std::move(simulation), gesture.commands, gesture.moment->steps.count);
            QCOMPARE(simulation.stateHash(), gesture.hash);
        }
    }

    void aGestureUnderWayCanBeRepeated()
    {
        Gestures gestures;
        SimulationThread thread{Simulation(falling())};
        thread.play();
        QVERIFY(waitFor(thread, [](const Snapshot& shot) { return shot.step > 50; }));
        thread.post(SetGravity{Vec3(0, 1, 0)});
        QVERIFY(waitFor(thread, [](const Snapshot& shot) { return shot.gravity.y() == 1; }));
        std::promise<std::uint64_t> hash; // of as much as has been done
        thread.lookAtGesture([&](const std::vector<RecordedCommand>& commands, std::uint64_t step) {
            hash.set_value(replay(Simulation(falling()), commands, step).stateHash());
        });
        thread.pause(); // right then
        thread.endGesture(gestures.taker());
        const Gesture gesture = gestures.next();
        QCOMPARE(gesture.commands.size(), std::size_t{2});
        QCOMPARE(hash.get_future().get(), gesture.hash);
    }

    /// Only what is new is told, and whether it is of another gesture.
    void aGestureUnderWayIsFollowed()
    {
        Gestures gestures;
        SimulationThread thread{Simulation(falling())};
        const auto follow = [&thread](const RecordingMark& known) {
            std::promise<RecordingNews> told;
            thread.followGesture(known, [&told](RecordingNews news) { told.set_value(std::move(news)); });
            return told.get_future().get();
        };
        const auto commandsOf = [](const RecordingNews& news) { return news.commands.size(); };
        thread.post(SetGravity{Vec3(0, 1, 0)});
        thread.stepOnce();
        const RecordingNews first = follow({});
        QCOMPARE(commandsOf(first), std::size_t{1});
        QCOMPARE(first.after.commands, std::size_t{0});
        QCOMPARE(first.step, std::uint64_t{1});
        thread.post(SetGravity{Vec3(0, 2, 0)});
        thread.stepOnce();
        const RecordingNews next = follow({first.after.recording, 1});
        QCOMPARE(commandsOf(next), std::size_t{1});
        QVERIFY((next.after == RecordingMark{first.after.recording, 1}));
        thread.endGesture(gestures.taker());
        const Gesture gesture = gestures.next();
        thread.post(SetGravity{Vec3(0, 3, 0)});
        thread.stepOnce();
        const RecordingNews another = follow({first.after.recording, 2});
        QVERIFY(another.after.recording != first.after.recording);
        QCOMPARE(another.after.commands, std::size_t{0});
        QCOMPARE(commandsOf(another), std::size_t{1});
        thread.goTo(gesture.moment);
        QVERIFY(follow(another.after).after.recording != another.after.recording);
    }

    void goingToAMomentPausesThere()
    {
        Gestures gestures;
        SimulationThread thread{Simulation(falling())};
        thread.stepOnce();
        thread.stepOnce();
        thread.endGesture(gestures.taker());
        const Gesture gesture = gestures.next();
        thread.play();
        QVERIFY(waitFor(thread, [](const Snapshot& shot) { return shot.step > 100; }));
        thread.goTo(gesture.moment);
        QVERIFY(waitFor(thread, [](const Snapshot& shot) { return shot.step == 2 && !shot.playing; }));
        thread.endGesture(gestures.taker());
        const Gesture after = gestures.next();
        QCOMPARE(after.hash, gesture.hash);
        QCOMPARE(after.commands.size(), std::size_t{1}); // the recording began anew
    }

    void slowMotionTakesLonger()
    {
        SimulationThread thread{Simulation(falling())};
        thread.setSpeed(0.1);
        thread.play();
        const auto shot = waitFor(thread, [](const Snapshot& s) { return s.time > 0.05; });
        QVERIFY(shot);
        QVERIFY(shot->ratio < 0.2);
    }

    void endsPromptlyWhilePlaying()
    {
        auto thread = std::make_unique<SimulationThread>(Simulation(falling()));
        thread->play();
        QVERIFY(waitFor(*thread, [](const Snapshot& shot) { return shot.playing; }));
        thread.reset();
    }
};

QTEST_GUILESS_MAIN(SimulationThreadTest)
#include "simulation_thread_test.moc"
