// Frames of the implicit scheme: a bar clamped at one end that a tool bends down, from 425 to 27,200 objects. One iteration is
// a step of 1/60 s; frames_per_second is its rate, iterations those of conjugate gradients in the last step.
#include "support/scenes.h"

#include <benchmark/benchmark.h>

using namespace knead;

namespace {

Simulation bentBar(int scale, bool isSteel, double poisson)
{
    const double length = 0.032;
    const Eigen::Vector3i objects = scale * Eigen::Vector3i(17, 5, 5);
    const Eigen::Vector3i cells = objects - Eigen::Vector3i::Ones();
    const double spacing = length / cells.x();
    Material material{.poissonRatio = poisson};
    if (isSteel) {
        material.density = 7850;
        material.youngsModulus = 2e11;
    }
    Scene scene = scenes::cantilever(cells, spacing, material, Vec3(0, 0, -9.81));
    scene.integrator = Integrator::implicitEuler;
    const double half = 0.5 * spacing * cells.z();
    Manipulator press{.name = "press", .size = {0.25 * length, length, 0.25 * length}};
    press.pose.position = Vec3(0.4 * length, 0, half + 0.125 * length);
    // Slow enough to go on bending the bar for a second or two, and never to shorten the steps.
    press.motion = DriveAt{Vec3(0, 0, -0.002), Vec3::Zero()};
    scene.manipulators.push_back(press);
    return Simulation(std::move(scene));
}

void implicitFrame(benchmark::State& state)
{
    Simulation simulation =
        bentBar(static_cast<int>(state.range(0)), state.range(1) != 0, static_cast<double>(state.range(2)) / 100);
    for (int frame = 0; frame < 10; ++frame)
        simulation.step();
    for (auto _ : state)
        simulation.step();
    const auto shot = simulation.snapshot();
    state.counters["objects"] = static_cast<double>(shot->objects);
    state.counters["iterations"] = shot->solverIterations;
    state.counters["step_ms"] = 1e3 * shot->timeStep;
    state.counters["frames_per_second"] = benchmark::Counter(1, benchmark::Counter::kIsIterationInvariantRate);
}

/// The same with a hand on the tool, which tells it a new place before each frame.
void draggedFrame(benchmark::State& state)
{
    Simulation simulation = bentBar(static_cast<int>(state.range(0)), state.range(1) != 0, 0.25);
    Pose pose = simulation.snapshot()->tools[0].pose;
    int iterations = 0;
    const auto drag = [&] {
        pose.position.z() -= 0.002 / 60;
        simulation.post(SetManipulatorMotion{0, GoTo{pose}});
        simulation.step();
        iterations += simulation.snapshot()->solverIterations;
    };
    for (int frame = 0; frame < 10; ++frame)
        drag();
    iterations = 0;
    for (auto _ : state)
        drag();
    state.counters["objects"] = static_cast<double>(simulation.snapshot()->objects);
    state.counters["iterations"] = benchmark::Counter(iterations, benchmark::Counter::kAvgIterations);
    state.counters["frames_per_second"] = benchmark::Counter(1, benchmark::Counter::kIsIterationInvariantRate);
}

} // namespace

BENCHMARK(draggedFrame)
    ->ArgNames({"scale", "steel"})
    ->ArgsProduct({{1, 2, 4}, {0, 1}})
    ->Iterations(30)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(implicitFrame)
    ->ArgNames({"scale", "steel", "poisson_percent"})
    ->ArgsProduct({{1, 2, 4}, {0, 1}, {25, 45, 49}})
    ->Iterations(30)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
