#include "core/aggregate/fill.h"
#include "core/geometry/mass_properties.h"
#include "core/geometry/surface_distance.h"
#include "core/geometry/wall_thickness.h"
#include "support/shapes.h"

#include <benchmark/benchmark.h>

namespace {

using namespace knead;

/// A tilted torus of about the given number of triangles, the shape whose times are in the mechanics report.
TriangleMesh torusOf(std::int64_t triangles)
{
    const auto aroundTube = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(triangles) / 6));
    return shapes::moved(shapes::torus(0.03, 0.01, 3 * aroundTube, aroundTube), shapes::tilt(0.7));
}

void setRate(benchmark::State& state, const char* name, std::size_t perIteration)
{
    state.counters[name] =
        benchmark::Counter(static_cast<double>(perIteration), benchmark::Counter::kIsIterationInvariantRate);
}

/// Arguments: triangles, objects.
void fillTorus(benchmark::State& state)
{
    const TriangleMesh mesh = torusOf(state.range(0));
    const FillOptions options{.spacing = spacingForObjectCount(mesh, static_cast<double>(state.range(1)))};
    std::size_t objects = 0;
    for (auto _ : state)
        objects = fill(mesh, options).size();
    setRate(state, "objects/s", objects);
    setRate(state, "triangles/s", mesh.triangles.size());
}
BENCHMARK(fillTorus)
    ->Args({20'000, 100'000})
    ->Args({200'000, 1'000'000})
    ->Args({1'000'000, 1'000'000})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void buildSurfaceDistance(benchmark::State& state)
{
    const TriangleMesh mesh = torusOf(state.range(0));
    for (auto _ : state)
        benchmark::DoNotOptimize(SurfaceDistance(mesh));
    setRate(state, "triangles/s", mesh.triangles.size());
}
BENCHMARK(buildSurfaceDistance)->Arg(200'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond)->UseRealTime();

void measureWalls(benchmark::State& state)
{
    const TriangleMesh mesh = torusOf(state.range(0));
    for (auto _ : state)
        benchmark::DoNotOptimize(wallThickness(mesh));
    setRate(state, "triangles/s", mesh.triangles.size());
}
BENCHMARK(measureWalls)->Arg(1'000'000)->Unit(benchmark::kMillisecond)->UseRealTime();

void checkWatertight(benchmark::State& state)
{
    const TriangleMesh mesh = torusOf(state.range(0));
    for (auto _ : state)
        benchmark::DoNotOptimize(isWatertight(mesh));
    setRate(state, "triangles/s", mesh.triangles.size());
}
BENCHMARK(checkWatertight)->Arg(1'000'000)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
