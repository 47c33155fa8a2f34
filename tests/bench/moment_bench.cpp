// What going back costs: keeping a moment, going to one, their bytes, and an undo as a whole (from bytes to the simulation that
// goes on from there), of an elastic block and one of clay. objects_per_second is the rate of one of these.
#include "core/document/history.h"
#include "core/simulation/moment.h"
#include "support/scenes_of_every_kind.h"

#include <benchmark/benchmark.h>

using namespace knead;

namespace {

constexpr int steps = 200;

struct Block {
    explicit Block(const benchmark::State& state)
        : scene(scenes::smallPress(state.range(1) != 0 ? scenes::clay() : scenes::soft(),
                                   static_cast<int>(state.range(0))))
        , simulation(scene)
    {
        for (int step = 0; step < steps; ++step)
            simulation.step();
        gesture = endGesture(simulation);
    }

    void report(benchmark::State& state) const
    {
        const auto objects = static_cast<double>(scene.bodies[0].aggregate->size());
        state.counters["objects"] = objects;
        state.counters["objects_per_second"] =
            benchmark::Counter(objects, benchmark::Counter::kIsIterationInvariantRate);
    }

    Scene scene;
    Simulation simulation;
    Gesture gesture;
};

void keepMoment(benchmark::State& state)
{
    Block block(state);
    for (auto _ : state) {
        state.PauseTiming();
        block.simulation.step();
        state.ResumeTiming();
        benchmark::DoNotOptimize(block.simulation.keepMoment());
    }
    block.report(state);
}

void goToMoment(benchmark::State& state)
{
    Block block(state);
    for (auto _ : state)
        block.simulation.goTo(block.gesture.moment);
    block.report(state);
}

void momentBytes(benchmark::State& state)
{
    const Block block(state);
    std::size_t size = 0;
    for (auto _ : state)
        size = momentToBytes(*block.gesture.moment).size();
    block.report(state);
    state.counters["bytes_per_object"] =
        static_cast<double>(size) / static_cast<double>(block.scene.bodies[0].aggregate->size());
}

void undo(benchmark::State& state)
{
    Block block(state);
    History history(recordOf(block.gesture, "pressed"));
    for (int step = 0; step < steps; ++step)
        block.simulation.step();
    history.append(recordOf(endGesture(block.simulation), "pressed more"));
    for (auto _ : state) {
        block.simulation.goTo(follow(history.wayTo(*history.undoTarget()), block.scene));
        benchmark::DoNotOptimize(block.simulation.snapshot());
    }
    block.report(state);
}

} // namespace

BENCHMARK(keepMoment)->ArgNames({"cells", "clay"})->ArgsProduct({{14, 29, 46}, {0, 1}})->UseRealTime();
BENCHMARK(goToMoment)->ArgNames({"cells", "clay"})->ArgsProduct({{14, 29, 46}, {0, 1}})->UseRealTime();
BENCHMARK(momentBytes)->ArgNames({"cells", "clay"})->ArgsProduct({{14, 29, 46}, {0, 1}})->UseRealTime();
BENCHMARK(undo)->ArgNames({"cells", "clay"})->ArgsProduct({{14, 29, 46}, {0, 1}})->UseRealTime();
