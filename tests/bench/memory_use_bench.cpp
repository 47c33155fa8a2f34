// What a simulation holds per object, without contacts, and what one of its snapshots holds: bytes_per_object counts what is
// allocated, as the allocator sees it; the time says nothing.
#include "support/scenes.h"

#include <benchmark/benchmark.h>

#include <malloc.h>

using namespace knead;

namespace {

/// By malloc and its kin, in small pieces and large ones.
std::size_t allocatedBytes()
{
    const struct mallinfo2 info = mallinfo2();
    return info.uordblks + info.hblkhd;
}

void memoryOfSimulation(benchmark::State& state)
{
    const auto cells = static_cast<int>(state.range(0));
    Material material;
    material.poissonRatio = static_cast<double>(state.range(1)) / 100;
    for (auto _ : state) {
        const std::size_t before = allocatedBytes();
        Scene scene;
        scene.bodies.push_back(scenes::box({cells, cells, cells}, 2e-3, material));
        Simulation simulation(std::move(scene));
        simulation.step();
        const std::size_t running = allocatedBytes();
        const auto shot = simulation.snapshot();
        const auto perObject = [&](std::size_t bytes) {
            return benchmark::Counter(static_cast<double>(bytes) / static_cast<double>(shot->objects));
        };
        state.counters["bytes_per_object"] = perObject(running - before);
        state.counters["bytes_per_object_of_snapshot"] = perObject(allocatedBytes() - running);
        state.counters["contacts"] = static_cast<double>(shot->contacts);
        state.counters["objects"] = static_cast<double>(shot->objects);
    }
}

} // namespace

BENCHMARK(memoryOfSimulation)
    ->ArgNames({"cells", "poisson_percent"})
    ->Args({14, 25})
    ->Args({99, 25})
    ->Args({99, 45})
    ->Iterations(1);
