#include "core/aggregate/fill.h"
#include "core/skin/fragments.h"
#include "support/shapes.h"

#include <benchmark/benchmark.h>

#include <cmath>

namespace {

using namespace knead;

/// A tilted torus broken across into twelve pieces.
struct Scene {
    TriangleMesh mesh = shapes::moved(shapes::torus(0.03, 0.01, 550, 182), shapes::tilt(0.7));
    Aggregate aggregate;
    std::vector<BrokenConnection> broken;

    explicit Scene(double objects)
        : aggregate(fill(mesh, {.spacing = spacingForObjectCount(mesh, objects)}))
    {
        const Pose pose = shapes::tilt(0.7);
        std::vector<int> part;
        for (ObjectIndex object = 0; object < aggregate.size(); ++object) {
            const Vec3 X = pose.toLocal(aggregate.lattice.position(object));
            part.push_back(static_cast<int>(std::floor(std::atan2(X.y(), X.x()) * 6 / std::numbers::pi)));
        }
        for (std::uint32_t d = 0; d < Lattice::directionCount; ++d)
            for (const Lattice::Segment& segment : aggregate.lattice.segments[d])
                for (ObjectIndex o = segment.begin; o < segment.end; ++o)
                    if (aggregate.weight[d][o] > 0 && part[o] != part[o + static_cast<ObjectIndex>(segment.offset)])
                        broken.push_back({d, o});
    }
};

/// Argument: objects.
void cutFragments(benchmark::State& state)
{
    const Scene scene(static_cast<double>(state.range(0)));
    std::size_t fragments = 0;
    for (auto _ : state)
        fragments = fragmentsOf(scene.aggregate, scene.mesh, scene.broken).size();
    state.counters["fragments"] = static_cast<double>(fragments);
    state.counters["objects/s"] =
        benchmark::Counter(static_cast<double>(scene.aggregate.size()), benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(cutFragments)
    ->Arg(30'000)
    ->Arg(100'000)
    ->Arg(300'000)
    ->Arg(1'000'000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

} // namespace
