#include "io/export/faceted_solid.h"
#include "support/shapes.h"

#include <benchmark/benchmark.h>

#include <cmath>

namespace {

using namespace knead;

/// Argument: triangles of a ring, none of them in a plane with its neighbors, of which flat faces are made.
void makeFacetedSolid(benchmark::State& state)
{
    const double segments = std::sqrt(static_cast<double>(state.range(0)) / 4);
    TriangleMesh mesh =
        shapes::torus(0.03, 0.01, static_cast<std::uint32_t>(2 * segments), static_cast<std::uint32_t>(segments));
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        mesh.vertices[v] *= 1 + 1e-3 * std::sin(static_cast<double>(7 * v));
    for (auto _ : state)
        benchmark::DoNotOptimize(facetedSolid(mesh, 1e-7).shape.IsNull());
    state.counters["faces/s"] =
        benchmark::Counter(static_cast<double>(mesh.triangles.size()), benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(makeFacetedSolid)->Arg(1'000)->Arg(10'000)->Arg(100'000)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
