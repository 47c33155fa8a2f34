#include "io/project/project_file.h"
#include "io/project/recovery.h"
#include "support/sample_project.h"
#include "support/scenes.h"

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace {

using namespace knead;

/// A bar of about so many objects with a history: half of its entries have their states, as large as those of a simulation of
/// plastic clay, and as hard to pack.
Project projectOf(std::int64_t objects, std::int64_t entries)
{
    const auto across = static_cast<int>(std::cbrt(static_cast<double>(objects) / 8));
    Project project = sample::project();
    Scene scene = scenes::cantilever({8 * across, across, across}, 0.001, {}, Vec3::Zero());
    const std::size_t bytes = 250 * scene.bodies[0].aggregate->size();
    project.starts = {{scene, {0}}};
    project.entries.resize(1);
    project.current = 0;
    const auto commands = sample::commands(sample::toolPart(0.02));
    for (std::int64_t i = 1; i < entries; ++i) {
        HistoryRecord& entry = project.entries.emplace_back(sample::entry(static_cast<std::uint32_t>(i - 1), "Push"));
        for (int repeat = 0; repeat < 10; ++repeat)
            entry.commands.insert(entry.commands.end(), commands.begin(), commands.begin() + 15);
        if (i % 2 == 0)
            entry.moment = sample::moment(bytes, static_cast<std::uint64_t>(i));
    }
    project.marks.clear();
    return project;
}

std::string pathOf(const char* name)
{
    return (std::filesystem::temp_directory_path() / name).string();
}

void setCounters(benchmark::State& state, const Project& project, const std::string& path)
{
    state.counters["objects"] = static_cast<double>(project.starts[0].scene.bodies[0].aggregate->size());
    state.counters["MB"] = static_cast<double>(std::filesystem::file_size(path)) / 1e6;
}

/// Arguments: objects, entries.
void saveProject(benchmark::State& state)
{
    const Project project = projectOf(state.range(0), state.range(1));
    const std::string path = pathOf("knead_save_bench.knead");
    for (auto _ : state)
        writeProject(path, project);
    setCounters(state, project, path);
    std::filesystem::remove(path);
}
BENCHMARK(saveProject)->Args({27'000, 1})->Args({27'000, 40})->Unit(benchmark::kMillisecond)->UseRealTime();

void openProject(benchmark::State& state)
{
    const Project project = projectOf(state.range(0), state.range(1));
    const std::string path = pathOf("knead_open_bench.knead");
    writeProject(path, project);
    for (auto _ : state)
        benchmark::DoNotOptimize(readProject(path));
    setCounters(state, project, path);
    std::filesystem::remove(path);
}
BENCHMARK(openProject)->Args({27'000, 1})->Args({27'000, 40})->Unit(benchmark::kMillisecond)->UseRealTime();

/// An entry with the state of so many objects.
void keepForRecovery(benchmark::State& state)
{
    const Project project = projectOf(state.range(0), 3);
    const std::string folder = pathOf("knead_recovery_bench");
    RecoveryFile file(folder);
    file.begin(project, {});
    for (auto _ : state)
        file.append(project.entries[2]);
    file.discard();
    std::filesystem::remove_all(folder);
}
BENCHMARK(keepForRecovery)->Arg(27'000)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(50);

} // namespace
