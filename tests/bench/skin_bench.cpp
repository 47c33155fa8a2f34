#include "core/aggregate/fill.h"
#include "core/skin/skin.h"
#include "support/shapes.h"

#include <benchmark/benchmark.h>

namespace {

using namespace knead;

/// A tilted torus of about 100 000 vertices in 100 000 objects.
struct Scene {
    TriangleMesh mesh = shapes::moved(shapes::torus(0.03, 0.01, 550, 182), shapes::tilt(0.7));
    Aggregate aggregate = fill(mesh, {.spacing = spacingForObjectCount(mesh, 100'000)});
};

void setRate(benchmark::State& state, std::size_t vertices)
{
    state.counters["vertices/s"] =
        benchmark::Counter(static_cast<double>(vertices), benchmark::Counter::kIsIterationInvariantRate);
}

void buildSkin(benchmark::State& state)
{
    const Scene scene;
    for (auto _ : state)
        benchmark::DoNotOptimize(Skin(scene.aggregate, scene.mesh.vertices));
    setRate(state, scene.mesh.vertices.size());
}
BENCHMARK(buildSkin)->Unit(benchmark::kMillisecond)->UseRealTime();

void evaluateSkin(benchmark::State& state)
{
    const Scene scene;
    const Skin skin(scene.aggregate, scene.mesh.vertices);
    const std::vector<Vec3> displacements(scene.aggregate.size(), Vec3(1e-3, 2e-3, 3e-3));
    std::vector<Vec3> places(skin.size());
    for (auto _ : state) {
        skin.evaluate(displacements, places);
        benchmark::DoNotOptimize(places.data());
    }
    setRate(state, skin.size());
}
BENCHMARK(evaluateSkin)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
