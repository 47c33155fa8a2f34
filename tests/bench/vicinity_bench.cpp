// One vicinity calculation: findPairs() of the uniform grid, on one thread. time_per_sphere is what the budget is
// about; compare sizes for growth.
#include "core/vicinity/uniform_grid.h"
#include "support/thread_limit.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <functional>
#include <random>

using namespace knead;

namespace {

/// Numbers that are the same on every machine.
class Numbers {
public:
    double next() { return static_cast<double>(m_random()) / 0xffffffffU; } ///< 0 .. 1
    Vec3 place() { return Vec3(next(), next(), next()); }

private:
    std::mt19937 m_random{20};
};

std::vector<Vec3> jitteredLattice(std::int64_t count)
{
    Numbers numbers;
    const auto side = static_cast<std::int64_t>(std::ceil(std::cbrt(static_cast<double>(count))));
    std::vector<Vec3> places;
    for (std::int64_t i = 0; i < count; ++i)
        places.emplace_back(Vec3(static_cast<double>(i % side), static_cast<double>(i / side % side),
                                 static_cast<double>(i / side / side)) +
                            0.1 * (numbers.place() - Vec3::Constant(0.5)));
    return places;
}

/// As if each sphere were a body of its own, so that all may touch.
std::vector<VicinitySphere> spheresAt(const std::vector<Vec3>& places, const std::function<double()>& radius)
{
    std::vector<VicinitySphere> spheres;
    for (const Vec3& place : places)
        spheres.push_back({.center = place, .radius = radius(), .group = static_cast<std::uint32_t>(spheres.size())});
    return spheres;
}

/// A compact body, nine pairs a sphere: those at distance 1 and sqrt 2.
std::vector<VicinitySphere> packed(std::int64_t count)
{
    return spheresAt(jitteredLattice(count), [] { return 0.75; });
}

/// The same number of neighbors, at random places that are not in any order.
std::vector<VicinitySphere> scattered(std::int64_t count)
{
    Numbers numbers;
    const double side = std::cbrt(static_cast<double>(count));
    std::vector<Vec3> places;
    for (std::int64_t i = 0; i < count; ++i)
        places.emplace_back(side * numbers.place());
    return spheresAt(places, [] { return 0.81; });
}

/// Radii from 0.15 to 1.5, small ones more frequent.
std::vector<VicinitySphere> tenToOne(std::int64_t count)
{
    Numbers numbers;
    return spheresAt(jitteredLattice(count), [&] { return 0.15 * std::pow(10.0, std::pow(numbers.next(), 3)); });
}

/// Clusters of 100 spheres, each a thousand sizes away from the next.
std::vector<VicinitySphere> sparse(std::int64_t count)
{
    Numbers numbers;
    const double side = 1000 * std::cbrt(static_cast<double>(count) / 100);
    std::vector<Vec3> places;
    Vec3 cluster = Vec3::Zero();
    for (std::int64_t i = 0; i < count; ++i) {
        if (i % 100 == 0)
            cluster = side * numbers.place();
        places.emplace_back(cluster + 5 * numbers.place());
    }
    return spheresAt(places, [] { return 0.6; });
}

void vicinity(benchmark::State& state, std::vector<VicinitySphere> (*scene)(std::int64_t))
{
    const std::vector<VicinitySphere> spheres = scene(state.range(0));
    UniformGrid grid;
    std::size_t pairs = 0;
    onThreads(1, [&] {
        for (auto _ : state) {
            pairs = grid.findPairs(spheres, 0).pairCount();
        }
        return 0;
    });
    using benchmark::Counter;
    const auto count = static_cast<double>(spheres.size());
    state.counters["time_per_sphere"] = Counter(count, Counter::kIsIterationInvariantRate | Counter::kInvert);
    state.counters["pairs_per_second"] = Counter(static_cast<double>(pairs), Counter::kIsIterationInvariantRate);
    state.counters["pairs_per_sphere"] = static_cast<double>(pairs) / count;
}

} // namespace

BENCHMARK_CAPTURE(vicinity, packed, packed)->Arg(3'400)->Arg(27'000)->Arg(54'000)->Arg(216'000)->Arg(1'000'000);
BENCHMARK_CAPTURE(vicinity, scattered, scattered)->Arg(13'600)->Arg(27'200)->Arg(217'600);
BENCHMARK_CAPTURE(vicinity, radii_10_to_1, tenToOne)->Arg(27'000)->Arg(54'000)->Arg(216'000);
BENCHMARK_CAPTURE(vicinity, very_sparse, sparse)->Arg(27'000)->Arg(54'000)->Arg(216'000);
