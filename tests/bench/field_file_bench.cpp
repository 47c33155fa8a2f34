// From a file with the displacements of a million nodes to their map. The field has three waves over the longest side of a part of the
// size of a hand: 33 nodes to a wave.
#include "core/deformation/field_map.h"
#include "io/fields/field_reader.h"
#include "io/fields/field_writer.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>

namespace {

using namespace knead;
namespace fs = std::filesystem;

constexpr double side = 0.1; // [m]
constexpr int nodesAlong = 100;
constexpr double waves = 3; // over the side
constexpr double height = 4e-4;

Vec3 displacementAt(const Vec3& node)
{
    const double k = 2 * std::numbers::pi * waves / side;
    return height * Vec3(std::sin(k * node.z()) * std::cos(k * node.y()),
                         std::sin(k * node.x()) * std::sin(k * node.z()),
                         std::cos(k * node.x()) * std::cos(k * node.y()));
}

const DisplacementField& field()
{
    static const DisplacementField made = [] {
        DisplacementField all;
        for (int z = 0; z < nodesAlong; ++z)
            for (int y = 0; y < nodesAlong; ++y)
                for (int x = 0; x < nodesAlong; ++x) {
                    all.nodes.push_back(side / (nodesAlong - 1) * Vec3(x, y, z));
                    all.displacements.push_back(displacementAt(all.nodes.back()));
                }
        return all;
    }();
    return made;
}

void writeVtu(const std::string& path)
{
    NodalFields fields{.nodes = field().nodes, .unit = "m", .arrays = {{"displacement", 3, {}}}};
    for (const Vec3& u : field().displacements)
        fields.arrays[0].values.insert(fields.arrays[0].values.end(), u.begin(), u.end());
    writeFields(path, fields);
}

/// As CalculiX writes it, in mm.
void writeFrd(const std::string& path)
{
    std::FILE* file = std::fopen(path.c_str(), "w");
    if (file == nullptr)
        throw std::runtime_error("cannot write " + path);
    const auto rows = [file](const std::vector<Vec3>& vectors) {
        for (std::size_t i = 0; i < vectors.size(); ++i)
            std::fprintf(file, " -1%10zu%12.5E%12.5E%12.5E\n", i + 1, 1e3 * vectors[i].x(), 1e3 * vectors[i].y(),
                         1e3 * vectors[i].z());
        std::fputs(" -3\n", file);
    };
    const std::size_t count = field().nodes.size();
    std::fprintf(file, "    1C\n    2C%30zu%37d\n", count, 1);
    rows(field().nodes);
    std::fprintf(
        file,
        "  100CL  101 1.000000000%12zu                     0    1           1\n -4  DISP        4    1\n"
        " -5  D1          1    2    1    0\n -5  D2          1    2    2    0\n -5  D3          1    2    3    0\n"
        " -5  ALL         1    2    0    0    1ALL\n",
        count);
    rows(field().displacements);
    std::fputs(" 9999\n", file);
    std::fclose(file);
}

/// A file of a million nodes, for as long as the program runs.
const std::string& fileOf(const std::string& ending)
{
    struct Files {
        fs::path folder = fs::temp_directory_path() / "knead-field-bench";
        std::string vtu = (folder / "million.vtu").string();
        std::string frd = (folder / "million.frd").string();
        Files()
        {
            fs::create_directories(folder);
            writeVtu(vtu);
            writeFrd(frd);
        }
        ~Files()
        {
            std::error_code ignored;
            fs::remove_all(folder, ignored);
        }
    };
    static const Files files;
    return ending == "vtu" ? files.vtu : files.frd;
}

void readMillionNodes(benchmark::State& state, const char* ending)
{
    const std::string& path = fileOf(ending);
    for (auto _ : state)
        benchmark::DoNotOptimize(readField(path, {}, TaskControl::none()));
}
BENCHMARK_CAPTURE(readMillionNodes, vtu, "vtu")->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(readMillionNodes, frd, "frd")->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();

/// 10 s at most, in one run.
void fromFileToMap(benchmark::State& state, const char* ending)
{
    const std::string& path = fileOf(ending);
    std::shared_ptr<const SmoothMap> map;
    for (auto _ : state) {
        FieldFile file = readField(path, {}, TaskControl::none());
        map = fieldMap({.field = std::make_shared<const DisplacementField>(std::move(file.field))});
    }
    double worst = 0;
    for (double s = 0.013; s < 1; s += 0.017) {
        const Vec3 place = side * Vec3(s, 0.9 - 0.7 * s, 0.1 + 0.5 * s);
        worst = std::max(worst, (map->at(place) - place - displacementAt(place)).norm());
    }
    state.counters["error_um"] = 1e6 * worst;
}
BENCHMARK_CAPTURE(fromFileToMap, vtu, "vtu")->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(fromFileToMap, frd, "frd")->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();

} // namespace
