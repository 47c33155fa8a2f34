#include "core/simulation/simulation_thread.h"
#include "support/scenes.h"

#include <QTest>

#include <functional>

using namespace knead;

namespace {

Scene falling()
{
    Scene scene;
    scene.bodies.push_back(scenes::box({4, 4, 4}, 2e-3));
    scene.gravity = Vec3(0, 0, -1);
    return scene;
}

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

    void commandsReachAPausedSimulation()
    {
        SimulationThread thread{Simulation(falling())};
        thread.post(AddManipulator{{.name = "block"}});
        const auto shot = waitFor(thread, [](const Snapshot& s) { return !s.tools.empty(); });
        QVERIFY(shot);
        QCOMPARE(shot->tools[0].name, std::string("block"));
        QCOMPARE(shot->step, std::uint64_t{0});
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
