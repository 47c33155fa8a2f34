#include "core/simulation/simulation_thread.h"

#include "core/simulation/governor.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <new>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

namespace knead {

namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr double frameSeconds = 1.0 / 60;
// The rest of a frame is for the snapshot and for the window, which shares the processor.
constexpr double steppingShare = 0.85;
constexpr double meteringSeconds = 0.5;

double secondsSince(Clock::time_point start)
{
    return Seconds(Clock::now() - start).count();
}

} // namespace

struct SimulationThread::Worker {
    Worker(Simulation sim, std::unique_ptr<ScriptedEvents> plan)
        : simulation(std::move(sim))
        , script(std::move(plan))
        , latest(simulation.snapshot())
    {
        thread = std::jthread([this](const std::stop_token& stop) { run(stop); });
    }

    /// Hands work to the thread and wakes it.
    void ask(std::function<void(Worker&)> request)
    {
        {
            const std::lock_guard lock(mutex);
            requests.push_back(std::move(request));
            ++asked;
        }
        wake.notify_one();
    }

    void run(const std::stop_token& stop)
    {
        while (!stop.stop_requested()) {
            carryOutRequests(stop);
            if (stop.stop_requested())
                return;
            guard([&] {
                if (playing)
                    playFrame(stop);
            });
            guard([&] { publish(); });
        }
    }

    /// An exception ends what was begun, not the program: the snapshot says what it was.
    template <typename Work>
    void guard(Work&& work)
    {
        try {
            work();
        } catch (const std::bad_alloc&) {
            pauseAfter(Message(
                "Run", "there is not enough memory to go on. Close other programs or fill the part with a larger "
                       "spacing, then reset."));
        } catch (const std::exception& error) {
            pauseAfter(Message("Run", "%1 Reset, or go to an earlier moment.").with(messageOf(error)));
        }
    }

    /// The state goes back to the last good one.
    void pauseAfter(const Message& cause)
    {
        playing = false;
        try {
            simulation.stop(cause);
            publish();
        } catch (const std::exception&) { // nor can it go back, or whoever watches throws: the last snapshot has to do
            auto shot = std::make_shared<Snapshot>(*latest);
            shot->playing = false;
            shot->requests = carriedOut;
            shot->health = {false, Message("Run", "The simulation was stopped: %1").with(cause), Trouble::failed};
            const std::lock_guard lock(mutex);
            latest = shot;
        }
    }

    /// Takes all requests; without any, and paused, waits for one.
    void carryOutRequests(const std::stop_token& stop)
    {
        std::deque<std::function<void(Worker&)>> taken;
        {
            std::unique_lock lock(mutex);
            if (!playing)
                wake.wait(lock, stop, [this] { return !requests.empty(); });
            taken.swap(requests);
        }
        for (const auto& request : taken)
            guard([&] { request(*this); });
        carriedOut += taken.size();
        guard([&] { simulation.applyCommands(); }); // the next snapshot shows them, with or without a step
    }

    /// Simulates one sixtieth of a second times the wanted speed, or as much of it as fits, and waits for the frame to end.
    void playFrame(const std::stop_token& stop)
    {
        const Clock::time_point start = Clock::now();
        const double target = simulation.time() + frameSeconds * speed - carry;
        const double before = simulation.time();
        steps = 0;
        while (!stop.stop_requested() && simulation.time() < target && simulation.health().ok) {
            if (carryOutScript()) {
                playing = false;
                break;
            }
            simulation.step();
            ++steps;
            if (secondsSince(start) > steppingShare * frameSeconds)
                break;
        }
        // What a frame overshoots is taken from the next; what it could not do is given up, the ratio says so.
        carry = std::max(0.0, simulation.time() - target);
        if (!simulation.health().ok)
            playing = false;
        meter(simulation.time() - before, start);
        govern(simulation.time() - before, secondsSince(start));
        std::unique_lock lock(mutex);
        const auto end = start + std::chrono::duration_cast<Clock::duration>(Seconds(frameSeconds));
        wake.wait_until(lock, stop, end, [] { return false; });
    }

    /// @param simulated in the frame just played @param spent on that [s]
    void govern(double simulated, double spent)
    {
        const bool isOwn = !script || scriptEnds > 0; // what a recipe leads to does not depend on the machine
        if (!keepsUp || !isOwn || !(simulated > 0) || latest->integrator != Integrator::implicitEuler)
            return;
        const double cost = (spent + snapshotSeconds) * speed / (steppingShare * simulated);
        if (const auto pace = governor.see(cost, std::max(frameSeconds, spent), latest->pace))
            simulation.post(SetPace{*pace});
    }

    void keepUp(bool on)
    {
        keepsUp = on;
        governor.forget();
        if (!on && latest->pace != Pace::full)
            simulation.post(SetPace{Pace::full});
    }

    void stepOnce()
    {
        if (!playing && !carryOutScript())
            simulation.step();
    }

    /// What is due before the next step. @return whether time is to stand still here, at the end; said once
    bool carryOutScript()
    {
        const bool hasEnded = script && script->carryOutDue(simulation);
        scriptEnds += hasEnded ? 1 : 0;
        return hasEnded;
    }

    std::optional<StaticReport> settle(TaskControl& control)
    {
        playing = false;
        carry = 0;
        carryOutScript(); // what is due now acts
        try {
            return simulation.settle({}, control);
        } catch (const Cancelled&) {
            return {};
        }
    }

    Gesture endGesture()
    {
        Gesture gesture = knead::endGesture(simulation);
        ++recording;
        if (script)
            script->ended(gesture);
        return gesture;
    }

    RecordingNews newsSince(const RecordingMark& known) const
    {
        const std::vector<RecordedCommand>& all = simulation.recording();
        const std::size_t from = known.recording == recording ? std::min(known.commands, all.size()) : 0;
        return {.after = {recording, from},
                .commands = {all.begin() + static_cast<std::ptrdiff_t>(from), all.end()},
                .step = simulation.stepCount()};
    }

    void goTo(const MomentPointer& moment)
    {
        playing = false;
        carry = 0;
        governor.forget();
        ++arrivals;
        ++recording;
        simulation.goTo(moment);
        if (script)
            script->wentTo(*moment, simulation.stateHash());
    }

    void meter(double simulated, Clock::time_point start)
    {
        if (frames.empty() || Seconds(start - frames.back().start).count() > meteringSeconds)
            frames.clear();
        frames.push_back({start, simulated});
        while (Seconds(start - frames.front().start).count() > meteringSeconds)
            frames.pop_front();
        const double wall = Seconds(start - frames.front().start).count() + std::max(frameSeconds, secondsSince(start));
        double sum = 0;
        for (const Frame& frame : frames)
            sum += frame.simulated;
        ratio = sum / wall;
        updates = static_cast<double>(frames.size()) / wall;
    }

    void publish()
    {
        const Clock::time_point start = Clock::now();
        const std::shared_ptr<Snapshot> shot = simulation.snapshot();
        snapshotSeconds = secondsSince(start);
        shot->playing = playing;
        shot->ratio = playing ? ratio : 0;
        shot->updatesPerSecond = playing ? updates : 0;
        shot->stepsPerFrame = playing ? steps : 0;
        shot->snapshotSeconds = snapshotSeconds;
        shot->arrivals = arrivals;
        shot->requests = carriedOut;
        shot->scriptEnds = scriptEnds;
        {
            const std::lock_guard lock(mutex);
            latest = shot;
        }
        if (watcher)
            watcher(shot);
    }

    struct Frame {
        Clock::time_point start;
        double simulated;
    };

    // Owned by the thread.
    Simulation simulation;
    std::unique_ptr<ScriptedEvents> script;
    bool playing = false;
    bool keepsUp = true;
    Governor governor;
    double speed = 1;
    double carry = 0;
    double ratio = 0;
    double updates = 0;
    int steps = 0;
    double snapshotSeconds = 0;
    std::uint64_t arrivals = 0;
    std::uint64_t recording = 1; ///< counts them
    std::uint64_t carriedOut = 0;
    std::uint64_t scriptEnds = 0;
    std::deque<Frame> frames;
    std::function<void(const SnapshotPointer&)> watcher;

    // Shared.
    std::mutex mutex;
    std::condition_variable_any wake;
    std::deque<std::function<void(Worker&)>> requests;
    std::uint64_t asked = 0;
    SnapshotPointer latest;

    std::jthread thread; // last: stops before the rest goes
};

SimulationThread::SimulationThread(Simulation simulation, std::unique_ptr<ScriptedEvents> script)
    : m_worker(std::make_unique<Worker>(std::move(simulation), std::move(script)))
{
}
SimulationThread::~SimulationThread() = default;

void SimulationThread::play()
{
    m_worker->ask([](Worker& worker) {
        worker.playing = worker.simulation.health().ok;
        worker.governor.forget();
    });
}

void SimulationThread::pause()
{
    m_worker->ask([](Worker& worker) { worker.playing = false; });
}

void SimulationThread::stepOnce()
{
    m_worker->ask([](Worker& worker) { worker.stepOnce(); });
}

void SimulationThread::reset()
{
    m_worker->ask([](Worker& worker) {
        worker.playing = false;
        worker.carry = 0;
        worker.simulation.post(Reset{});
    });
}

void SimulationThread::settle(std::shared_ptr<TaskControl> control,
                              std::function<void(std::optional<StaticReport>)> told)
{
    m_worker->ask([control = std::move(control), told = std::move(told)](Worker& worker) {
        std::optional<StaticReport> report;
        worker.guard([&] { report = worker.settle(*control); });
        told(std::move(report));
    });
}

void SimulationThread::endGesture(std::function<void(Gesture)> kept)
{
    m_worker->ask([kept = std::move(kept)](Worker& worker) { kept(worker.endGesture()); });
}

void SimulationThread::lookAtGesture(std::function<void(std::vector<RecordedCommand>, std::uint64_t)> told)
{
    m_worker->ask([told = std::move(told)](Worker& worker) {
        worker.simulation.applyCommands();
        told(worker.simulation.recording(), worker.simulation.stepCount());
    });
}

void SimulationThread::followGesture(RecordingMark known, std::function<void(RecordingNews)> told)
{
    m_worker->ask([known, told = std::move(told)](Worker& worker) { told(worker.newsSince(known)); });
}

void SimulationThread::goTo(MomentPointer moment)
{
    m_worker->ask([moment = std::move(moment)](Worker& worker) { worker.goTo(moment); });
}

void SimulationThread::setSpeed(double ratio)
{
    m_worker->ask([speed = std::clamp(ratio, 0.01, 10.0)](Worker& worker) { worker.speed = speed; });
}

void SimulationThread::keepUp(bool on)
{
    m_worker->ask([on](Worker& worker) { worker.keepUp(on); });
}

void SimulationThread::showPressing(bool on)
{
    m_worker->ask([on](Worker& worker) { worker.simulation.showPressing(on); });
}

void SimulationThread::post(Command command)
{
    m_worker->ask([command = std::move(command)](Worker& worker) { worker.simulation.post(command); });
}

void SimulationThread::watch(std::function<void(const SnapshotPointer&)> watcher)
{
    m_worker->ask([watcher = std::move(watcher)](Worker& worker) { worker.watcher = watcher; });
}

std::uint64_t SimulationThread::requests() const
{
    const std::lock_guard lock(m_worker->mutex);
    return m_worker->asked;
}

SnapshotPointer SimulationThread::latest() const
{
    const std::lock_guard lock(m_worker->mutex);
    return m_worker->latest;
}

} // namespace knead
