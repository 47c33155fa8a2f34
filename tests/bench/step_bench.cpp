// Whole simulation steps of a soft block pressed by a tool, and the snapshot that the window takes sixty times a second.
// objects_per_second and connections_per_second are rates of one step; compare sizes for growth.
#include "support/scenes.h"

#include <benchmark/benchmark.h>

#include <cmath>

using namespace knead;

namespace {

Simulation pressedBlock(std::int64_t cells, double poisson)
{
    const double spacing = 2e-3;
    Material material;
    material.youngsModulus = 2e5;
    material.poissonRatio = poisson;
    Scene scene;
    const auto n = static_cast<int>(cells);
    scene.bodies.push_back(scenes::box({n, n, n}, spacing, material));
    const double half = 0.5 * spacing * n;
    scene.floorHeight = -half;
    constexpr double thickness = 0.01;
    Manipulator tool{.name = "press", .size = {half, half, thickness}};
    tool.pose.position.z() = half + 0.51 * thickness; // just above, not in it
    // Pressed in by a tenth of the height and held there, for as many steps as it takes.
    tool.motion = GoTo{{Vec3(0, 0, 0.8 * half + 0.5 * thickness), Quaternion::Identity()}};
    scene.manipulators.push_back(tool);
    return Simulation(std::move(scene));
}

void report(benchmark::State& state, Simulation& simulation)
{
    const auto shot = simulation.snapshot();
    const auto rate = [&](std::size_t count) {
        return benchmark::Counter(static_cast<double>(count), benchmark::Counter::kIsIterationInvariantRate);
    };
    state.counters["objects"] = static_cast<double>(shot->objects);
    state.counters["objects_per_second"] = rate(shot->objects);
    state.counters["connections_per_second"] = rate(shot->connections);
}

/// From when the tool presses: what the first steps find once, such as the stable step, is not of a step.
void step(benchmark::State& state)
{
    constexpr int before = 300;
    Simulation simulation = pressedBlock(state.range(0), static_cast<double>(state.range(1)) / 100);
    for (int n = 0; n < before; ++n)
        simulation.step();
    for (auto _ : state)
        simulation.step();
    report(state, simulation);
}

void snapshot(benchmark::State& state)
{
    Simulation simulation = pressedBlock(state.range(0), 0.25);
    simulation.step();
    for (auto _ : state)
        benchmark::DoNotOptimize(simulation.snapshot());
    report(state, simulation);
}

} // namespace

BENCHMARK(step)->ArgNames({"cells", "poisson_percent"})->ArgsProduct({{7, 14, 29, 46}, {25, 45}})->UseRealTime();
BENCHMARK(snapshot)->ArgName("cells")->Arg(14)->Arg(29)->Arg(46)->UseRealTime();
