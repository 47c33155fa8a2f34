// Looking for crossings of a surface with itself: clean ones from a sixteenth of a million triangles on, to see the growth, and two
// that cross.
#include "core/geometry/self_intersection.h"
#include "support/shapes.h"

#include <benchmark/benchmark.h>

#include <cmath>

namespace {

using namespace knead;

void find(benchmark::State& state, const TriangleMesh& mesh)
{
    Crossings crossings;
    for (auto _ : state)
        crossings = findCrossings(mesh);
    const auto triangles = static_cast<double>(mesh.triangles.size());
    state.counters["triangles"] = triangles;
    state.counters["crossings"] = static_cast<double>(crossings.count);
    state.counters["triangles/s"] = benchmark::Counter(triangles, benchmark::Counter::kIsIterationInvariantRate);
}

/// A tilted torus of about so many triangles.
TriangleMesh torus(std::int64_t triangles)
{
    const auto aroundTube = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(triangles) / 6));
    return shapes::moved(shapes::torus(0.03, 0.01, 3 * aroundTube, aroundTube), shapes::tilt(0.7));
}

void findNoCrossings(benchmark::State& state)
{
    find(state, torus(state.range(0)));
}
BENCHMARK(findNoCrossings)->RangeMultiplier(4)->Range(1 << 16, 1 << 22)->Unit(benchmark::kMillisecond)->UseRealTime();

void findCrossingsOfTwoTori(benchmark::State& state)
{
    const TriangleMesh one = torus(state.range(0) / 2);
    find(state, shapes::together(one, shapes::moved(one, shapes::tilt(1, Vec3(0.02, 0, 0)))));
}
BENCHMARK(findCrossingsOfTwoTori)->Arg(1'000'000)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
