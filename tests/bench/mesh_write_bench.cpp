// Writing a million triangles to each mesh format, beside writing as many bytes as the STL has from memory, with and without
// waiting for the disk.
#include "io/files/safe_file.h"
#include "io/formats/mesh_writer.h"
#include "support/shapes.h"

#include <benchmark/benchmark.h>

#include <cstdio>
#include <filesystem>
#include <string>

namespace {

using namespace knead;

const MeshBody& body()
{
    static const MeshBody torus{"torus", Color{},
                                shapes::moved(shapes::torus(0.03, 0.01, 1200, 420), shapes::tilt(0.7))};
    return torus;
}

std::string pathWith(const std::string& ending)
{
    return (std::filesystem::temp_directory_path() / ("knead_mesh_write_bench." + ending)).string();
}

void setRates(benchmark::State& state, const std::string& path)
{
    const auto rate = [](double amount) {
        return benchmark::Counter(amount, benchmark::Counter::kIsIterationInvariantRate);
    };
    state.counters["vertices/s"] = rate(static_cast<double>(body().mesh.vertices.size()));
    state.counters["bytes/s"] = rate(static_cast<double>(std::filesystem::file_size(path)));
    std::filesystem::remove(path);
    std::filesystem::remove(pathWith("mtl"));
}

void writeMesh(benchmark::State& state, const std::string& ending, bool isText)
{
    const std::string path = pathWith(ending);
    for (auto _ : state)
        writeMeshes(path, {body()}, {.isText = isText});
    setRates(state, path);
}

std::string bytesOfStl()
{
    return std::string(84 + 50 * body().mesh.triangles.size(), 'k');
}

void writeBytes(benchmark::State& state)
{
    const std::string bytes = bytesOfStl();
    const std::string path = pathWith("bytes");
    for (auto _ : state) {
        std::FILE* file = std::fopen(path.c_str(), "wb");
        std::fwrite(bytes.data(), 1, bytes.size(), file);
        std::fclose(file);
    }
    setRates(state, path);
}

void writeBytesSafely(benchmark::State& state)
{
    const std::string bytes = bytesOfStl();
    const std::string path = pathWith("bytes");
    for (auto _ : state)
        writeFileSafely(path, bytes);
    setRates(state, path);
}

BENCHMARK(writeBytes)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(writeBytesSafely)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(writeMesh, stl, "stl", false)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(writeMesh, stl_text, "stl", true)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(writeMesh, obj, "obj", false)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(writeMesh, ply, "ply", false)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(writeMesh, ply_text, "ply", true)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(writeMesh, glb, "glb", false)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(writeMesh, gltf, "gltf", false)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(writeMesh, three_mf, "3mf", false)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(writeMesh, vtp, "vtp", false)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
