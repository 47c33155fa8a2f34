// The forces of structural connections alone, and whole explicit steps of a block that flies and turns alone, from 425 to 10^6
// objects: elastic at Poisson's ratio 1/4, with the volumetric term, of clay that does not yield, and
// of clay that flows. connections_per_second is the
// rate; bytes_per_second what must at least be read and written for it, to set beside the triad of memory_bench.cpp.
#include "core/mechanics/structural_connections.h"
#include "support/scenes.h"

#include <benchmark/benchmark.h>

#include <array>
#include <random>

using namespace knead;

namespace {

enum Kind { elastic, volumetric, clay, flowing };

struct Size {
    const char* name;
    std::array<int, 3> cells;
};
constexpr std::array<Size, 5> sizes{{{"425", {4, 4, 16}},
                                     {"3400", {9, 9, 33}},
                                     {"27000", {29, 29, 29}},
                                     {"216000", {59, 59, 59}},
                                     {"1000000", {99, 99, 99}}}};

Body bodyOf(const benchmark::State& state)
{
    Material material;
    material.youngsModulus = 2e5;
    material.poissonRatio = state.range(1) == elastic ? 0.25 : 0.45;
    if (state.range(1) == clay)
        material.yieldStress = 2e3;
    if (state.range(1) == flowing)
        material.yieldStress = 1; // what turns bears more than that nearly everywhere
    const auto& cells = sizes[static_cast<std::size_t>(state.range(0))].cells;
    Body body = scenes::box({cells[0], cells[1], cells[2]}, 2e-3, material);
    body.velocity = {0.1, 0.2, 0.3};
    body.angularVelocity = {1, 2, 3};
    return body;
}

benchmark::Counter rate(double count)
{
    return {count, benchmark::Counter::kIsIterationInvariantRate};
}

void connectionForces(benchmark::State& state)
{
    const Body body = bodyOf(state);
    const MaterialMap materials(body.material, body.aggregate->size());
    StructuralConnections connections(body.aggregate, materials);
    ObjectState objects = objectsAtRest(*body.aggregate);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> value(-1, 1);
    for (std::size_t i = 0; i < objects.size(); ++i) {
        objects.position.add(i, 1e-4 * Vec3(value(random), value(random), value(random)));
        objects.velocity.set(i, {value(random), value(random), value(random)});
    }
    for (auto _ : state)
        connections.computeForces(objects);
    const auto count = static_cast<double>(objects.size());
    constexpr double perObject =
        6 + 2 * 6; // positions and velocities read, forces and damping written after being read
    constexpr double stress = 2 * 9 + 6 + 3;
    const double numbers = perObject + Lattice::isotropicCount + (state.range(1) == elastic ? 0 : stress);
    state.SetLabel(sizes[static_cast<std::size_t>(state.range(0))].name);
    state.counters["connections_per_second"] = rate(static_cast<double>(connections.count()));
    state.counters["bytes_per_second"] = rate(sizeof(double) * numbers * count);
}

void flyingStep(benchmark::State& state)
{
    Scene scene;
    scene.gravity = Vec3::Zero();
    scene.bodies.push_back(bodyOf(state));
    Simulation simulation(std::move(scene));
    simulation.step(); // the first one sets up contacts
    for (auto _ : state)
        simulation.step();
    const auto shot = simulation.snapshot();
    state.SetLabel(sizes[static_cast<std::size_t>(state.range(0))].name);
    state.counters["objects"] = static_cast<double>(shot->objects);
    state.counters["objects_per_second"] = rate(static_cast<double>(shot->objects));
    state.counters["connections_per_second"] = rate(static_cast<double>(shot->connections));
    state.counters["real_time_ratio"] = rate(shot->timeStep);
}

} // namespace

BENCHMARK(connectionForces)
    ->ArgNames({"size", "kind"})
    ->ArgsProduct({{0, 1, 2, 3, 4}, {elastic, volumetric}})
    ->UseRealTime();
BENCHMARK(flyingStep)
    ->ArgNames({"size", "kind"})
    ->ArgsProduct({{0, 1, 2, 3, 4}, {elastic, volumetric, clay, flowing}})
    ->UseRealTime();
