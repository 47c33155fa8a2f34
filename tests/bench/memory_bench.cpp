// What the memory of the machine gives, to read the other times by: numbers of the same run on the same machine. As in
// STREAM, bytes are those the loop names; what a store reads before it writes does not count.
#include "core/task/parallel.h"
#include "support/thread_limit.h"

#include <benchmark/benchmark.h>

#include <numeric>
#include <vector>

using namespace knead;

namespace {

constexpr std::size_t count = 1U << 25U; // 256 MiB an array: more than caches hold
constexpr std::size_t blockSize = 1U << 16U;

/// Argument: threads.
void memoryTriad(benchmark::State& state)
{
    std::vector<double> a(count, 0);
    const std::vector<double> b(count, 1);
    const std::vector<double> c(count, 2);
    onThreads(static_cast<int>(state.range(0)), [&] {
        for (auto _ : state) {
            forEachBlock(count, blockSize, [&](std::size_t begin, std::size_t end) {
                for (std::size_t i = begin; i < end; ++i)
                    a[i] = b[i] + 3 * c[i];
            });
            benchmark::DoNotOptimize(a.data());
        }
        return 0;
    });
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(3 * sizeof(double) * count));
}
BENCHMARK(memoryTriad)->ArgName("threads")->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

/// Argument: threads.
void memoryRead(benchmark::State& state)
{
    const std::vector<double> a(count, 1);
    std::vector<double> sums(count / blockSize);
    onThreads(static_cast<int>(state.range(0)), [&] {
        for (auto _ : state) {
            forEachBlock(count, blockSize, [&](std::size_t begin, std::size_t end) {
                double lanes[32] = {}; // so many that additions do not wait for each other
                for (std::size_t i = begin; i < end; i += 32)
                    for (std::size_t lane = 0; lane < 32; ++lane)
                        lanes[lane] += a[i + lane];
                sums[begin / blockSize] = std::accumulate(std::begin(lanes), std::end(lanes), 0.0);
            });
            benchmark::DoNotOptimize(sums.data());
        }
        return 0;
    });
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(sizeof(double) * count));
}
BENCHMARK(memoryRead)->ArgName("threads")->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
