// Importing beside the bare calls of OpenCASCADE, in the same run: what checking, measuring and healing cost on top of
// reading a file and making its triangles.
#include "core/model/import_options.h"
#include "import/bare_import.h"
#include "io/importer.h"
#include "io/worker/import_worker.h"
#include "io/worker/isolated_import.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include <sys/resource.h>

using namespace knead;

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t mostFiles = 10;
constexpr int defaultRounds = 3;

double secondsSince(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Of this process and those that it waited for [s].
double processorSeconds()
{
    double sum = 0;
    for (const int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
        rusage usage{};
        getrusage(who, &usage);
        for (const timeval& time : {usage.ru_utime, usage.ru_stime})
            sum += static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    }
    return sum;
}

/// Books the time between two reports on the stage that was reported first.
class StageClock final : public TaskControl {
public:
    void report(double, std::string_view stage) override
    {
        const Clock::time_point now = Clock::now();
        m_seconds[m_stage] += std::chrono::duration<double>(now - m_since).count();
        m_stage = stage;
        m_since = now;
    }
    bool isCancelled() const override { return false; }

    std::map<std::string, double> finish()
    {
        report(1, "");
        return m_seconds;
    }

private:
    std::string m_stage = "looking at the text";
    Clock::time_point m_since = Clock::now();
    std::map<std::string, double> m_seconds;
};

/// One way to get a file in; the least time of all rounds, and where it went.
struct Contender {
    std::string name;
    std::function<std::map<std::string, double>(const std::string& path)> import;
    double seconds = std::numeric_limits<double>::infinity();
    double processor = std::numeric_limits<double>::infinity(); // [s], of all cores
    std::map<std::string, double> stages;

    void run(const std::string& path)
    {
        const double processorBefore = processorSeconds();
        const Clock::time_point start = Clock::now();
        std::map<std::string, double> found = import(path);
        if (const double taken = secondsSince(start); taken < seconds) {
            seconds = taken;
            stages = std::move(found);
        }
        processor = std::min(processor, processorSeconds() - processorBefore);
    }
};

std::map<std::string, double> importHere(const std::string& path, bool heal)
{
    StageClock clock;
    importFile(path, {.heal = heal}, clock);
    return clock.finish();
}

std::map<std::string, double> importInProcess(const std::string& path)
{
    StageClock clock;
    importIsolated("/proc/self/exe", path, {}, limitsFor(path), clock);
    return clock.finish();
}

std::vector<Contender> contenders()
{
    const auto bare = [](bool parallel) {
        return [=](const std::string& path) {
            const BareTimes times = bareImport(path, parallel);
            return std::map<std::string, double>{
                {"reading", times.reading}, {"transfer", times.transfer}, {"triangles", times.meshing}};
        };
    };
    return {
        {.name = "bare OpenCASCADE", .import = bare(false)},
        {.name = "bare, triangles on all cores", .import = bare(true)},
        {.name = "import without healing", .import = [](const auto& path) { return importHere(path, false); }},
        {.name = "import", .import = [](const auto& path) { return importHere(path, true); }},
        {.name = "import in a process of its own", .import = importInProcess},
    };
}

/// Prints a table of one file and returns it.
nlohmann::json compare(const std::filesystem::path& file, int rounds, const std::string& way)
{
    std::vector<Contender> all = contenders();
    std::erase_if(all, [&](const Contender& contender) { return !way.empty() && contender.name != way; });
    if (all.empty())
        throw std::runtime_error("There is no way called \"" + way + "\".");
    for (int round = 0; round < rounds; ++round)
        for (Contender& contender : all)
            contender.run(file.string());
    std::printf("\n%s, %.2f MB, best of %d rounds\n", file.filename().c_str(),
                1e-6 * static_cast<double>(std::filesystem::file_size(file)), rounds);
    nlohmann::json rows = nlohmann::json::array();
    for (const Contender& contender : all) {
        const double ratio = contender.seconds / all.front().seconds;
        const double processorRatio = contender.processor / all.front().processor;
        std::printf("  %-31s %8.3f s  %5.2f x  processor %8.3f s  %5.2f x ", contender.name.c_str(), contender.seconds,
                    ratio, contender.processor, processorRatio);
        for (const auto& [stage, seconds] : contender.stages)
            if (seconds > 0.01 * contender.seconds)
                std::printf("  %s %.3f", stage.c_str(), seconds);
        std::printf("\n");
        rows.push_back({{"way", contender.name},
                        {"seconds", contender.seconds},
                        {"times_bare", ratio},
                        {"processor_s", contender.processor},
                        {"processor_times_bare", processorRatio},
                        {"stages_s", contender.stages}});
    }
    std::fflush(stdout);
    return {{"file", file.filename().string()}, {"ways", rows}};
}

/// The largest CAD files of the corpus, or all that come with the program.
std::vector<std::filesystem::path> filesToRead()
{
    const char* corpus = std::getenv("KNEAD_CORPUS");
    const std::filesystem::path folder =
        corpus != nullptr ? std::filesystem::path(corpus) / "open" : std::filesystem::path(KNEAD_EXAMPLES);
    static constexpr std::array endings{".step", ".stp", ".iges", ".igs", ".brep"};
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (std::find(endings.begin(), endings.end(), entry.path().extension()) != endings.end())
            files.push_back(entry.path());
    std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) {
        return std::filesystem::file_size(a) > std::filesystem::file_size(b);
    });
    files.resize(std::min(files.size(), mostFiles));
    return files;
}

} // namespace

/// Usage: knead_import_bench [--rounds N] [--json FILE] [--way NAME] [CAD FILES]
/// One way alone is for a profiler; ratios are to the first of the table.
int main(int argc, char** argv)
{
    if (isImportWorker(argc, argv))
        return runImportWorker(argc, argv);
    try {
        int rounds = defaultRounds;
        std::string json;
        std::string way;
        std::vector<std::filesystem::path> files;
        for (int i = 1; i < argc; ++i) {
            const std::string argument = argv[i];
            if (argument == "--rounds" && i + 1 < argc)
                rounds = std::stoi(argv[++i]);
            else if (argument == "--json" && i + 1 < argc)
                json = argv[++i];
            else if (argument == "--way" && i + 1 < argc)
                way = argv[++i];
            else
                files.emplace_back(argument);
        }
        if (files.empty())
            files = filesToRead();
        nlohmann::json tables = nlohmann::json::array();
        for (const std::filesystem::path& file : files)
            tables.push_back(compare(file, rounds, way));
        if (json.empty())
            return EXIT_SUCCESS;
        std::ofstream stream(json);
        stream << nlohmann::json{{"files", tables}}.dump(2) << "\n";
        if (!stream.flush())
            throw std::runtime_error(json + " could not be written.");
        return EXIT_SUCCESS;
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return EXIT_FAILURE;
    }
}
