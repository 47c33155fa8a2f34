// The paper's experiment on the growth of the vicinity calculation (its figure 6): copies of an aggregate of 425 objects,
// from one to 128, thirty timings of each number, every back-end. Counts do not depend on the machine, times do.
#include "support/thread_limit.h"

#include "bench/bar_pile.h"
#include "bench/paper_report.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <optional>
#include <stdexcept>

namespace {

using namespace knead;

constexpr std::size_t piles = 6;        // scenes of each number of objects, for chance has a say in where planes fall
constexpr std::size_t stepsPerPile = 5; // six times five are the thirty timings of the paper
constexpr std::size_t largestOfAll = 54'400; // objects that every back-end is timed on
constexpr double timeStep = 2e-4;            // [s]; a tenth of a sphere's diameter at the speeds of the bars

struct Options {
    std::filesystem::path out = "out/bench";
    std::filesystem::path json; ///< empty: none
    std::size_t largest = largestOfAll;
};

constexpr const char* usage = R"(knead_paper_experiment: how the vicinity calculation grows, as in figure 6 of the paper
  --out DIR      folder for growth.svg (default: out/bench)
  --json FILE    write all numbers as JSON
  --largest N    largest number of objects (default: 54400); beyond that only the uniform grid goes on
)";

/// @throws std::invalid_argument
Options optionsOf(int count, char** arguments)
{
    Options options;
    for (int i = 1; i < count; i += 2) {
        const std::string name = arguments[i];
        if (i + 1 >= count)
            throw std::invalid_argument(name + " needs a value, or is unknown.");
        const std::string value = arguments[i + 1];
        if (name == "--out")
            options.out = value;
        else if (name == "--json")
            options.json = value;
        else if (name == "--largest")
            options.largest = std::strtoull(value.c_str(), nullptr, 10);
        else
            throw std::invalid_argument(name + ": there is no such option.");
    }
    if (options.largest < BarPile::objectsPerBar)
        throw std::invalid_argument("--largest needs a number of at least 425.");
    return options;
}

/// Processor time since the start of the program [s]: other work on the machine does not count. All that is timed here runs
/// on one thread.
double now()
{
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Steps of each pile that are timed. Brute force is timed less often where it takes seconds; beyond largestOfAll, only the
/// uniform grid is.
std::size_t timedSteps(VicinityMethod method, std::size_t objects)
{
    if (objects > largestOfAll && method != VicinityMethod::uniformGrid)
        return 0;
    constexpr double affordable = 1e9; // n^2 over the steps of a pile
    const double square = static_cast<double>(objects) * static_cast<double>(objects);
    if (method != VicinityMethod::bruteForce || affordable > stepsPerPile * square)
        return stepsPerPile;
    return std::max<std::size_t>(1, static_cast<std::size_t>(affordable / square));
}

/// Times and counts of one back-end, summed over steps.
struct Sums {
    std::size_t steps = 0;
    double vicinity = 0;
    double system = 0;
    double systemSquared = 0;
    double sphereTests = 0;
    double spanningObjects = 0;
    double pairs = 0;
    int depth = 0;

    void add(double vicinityTime, double otherTime, const VicinityStatistics& statistics, std::size_t found)
    {
        ++steps;
        vicinity += vicinityTime;
        system += vicinityTime + otherTime;
        systemSquared += (vicinityTime + otherTime) * (vicinityTime + otherTime);
        sphereTests += static_cast<double>(statistics.sphereTests);
        spanningObjects += static_cast<double>(statistics.spanningObjects);
        pairs += static_cast<double>(found);
        depth = std::max(depth, statistics.depth);
    }

    PaperMeasurement mean(VicinityMethod method, std::size_t objects) const
    {
        const auto n = static_cast<double>(steps);
        const double variance = std::max(0.0, systemSquared / n - system / n * (system / n));
        return {.objects = objects,
                .method = method,
                .steps = steps,
                .vicinity = vicinity / n,
                .system = system / n,
                .systemUncertainty = steps > 1 ? std::sqrt(variance / (n - 1)) : 0,
                .sphereTests = sphereTests / n,
                .spanningObjects = spanningObjects / n,
                .pairs = pairs / n,
                .depth = depth};
    }
};

/// One number of objects, all back-ends side by side.
class Experiment {
public:
    explicit Experiment(std::size_t bars)
        : m_bars(bars)
    {
        for (const VicinityMethod method : vicinityMethods)
            m_backEnds[method].vicinity = makeVicinity(method);
    }

    /// @throws std::runtime_error, in a sentence, when back-ends disagree
    void run(std::uint64_t seed)
    {
        BarPile pile(m_bars, seed);
        m_connections = pile.connectionsPerBar();
        for (std::size_t i = 0; i < stepsPerPile; ++i)
            step(pile, i);
    }

    void addTo(PaperReport& report) const
    {
        report.connectionsPerAggregate = m_connections;
        for (const VicinityMethod method : vicinityMethods)
            if (const Sums& sums = m_backEnds.at(method).sums; sums.steps > 0)
                report.measurements.push_back(sums.mean(method, objects()));
    }

    std::size_t objects() const { return m_bars * BarPile::objectsPerBar; }

private:
    struct BackEnd {
        std::unique_ptr<Vicinity> vicinity;
        Sums sums;
    };

    /// The calculation cycle of the paper with the motion given: rigid, so that the scene stays what it is.
    void step(BarPile& pile, std::size_t index)
    {
        double start = now();
        pile.computeForces();
        pile.move(timeStep);
        const auto spheres = pile.spheres();
        const double otherTime = now() - start;
        std::optional<std::size_t> expected;
        for (auto& [method, backEnd] : m_backEnds) {
            if (index >= timedSteps(method, objects()))
                continue;
            start = now();
            const std::size_t found = backEnd.vicinity->findPairs(spheres, BarPile::margin).pairCount();
            backEnd.sums.add(now() - start, otherTime, backEnd.vicinity->statistics(), found);
            if (expected.value_or(found) != found)
                throw std::runtime_error("The back-ends disagree: of " + std::to_string(objects()) + " objects, " +
                                         std::string(nameOf(method)) + " found " + std::to_string(found) +
                                         " pairs, others " + std::to_string(*expected) + ".");
            expected = found;
        }
    }

    std::size_t m_bars;
    std::size_t m_connections = 0;
    std::map<VicinityMethod, BackEnd> m_backEnds;
};

/// @throws std::runtime_error
void write(const std::filesystem::path& file, const std::string& content)
{
    if (file.has_parent_path())
        std::filesystem::create_directories(file.parent_path());
    std::ofstream stream(file);
    stream << content;
    stream.close();
    if (!stream)
        throw std::runtime_error(file.string() + " could not be written.");
}

/// Pile by pile, not number by number: a machine that is slow for a while then slows all numbers alike.
PaperReport measure(std::size_t largest)
{
    std::vector<Experiment> experiments;
    for (std::size_t bars = 1; bars * BarPile::objectsPerBar <= largest; bars *= 2)
        experiments.emplace_back(bars);
    for (std::size_t pile = 1; pile <= piles; ++pile) {
        std::cerr << "Pile " << pile << " of " << piles << "\n";
        for (Experiment& experiment : experiments)
            experiment.run(pile);
    }
    PaperReport report;
    for (const Experiment& experiment : experiments)
        experiment.addTo(report);
    return report;
}

void runAll(const Options& options)
{
    const PaperReport report = onThreads(1, [&] { return measure(options.largest); });
    std::cout << "\nEvery number of objects in " << piles << " piles, " << stepsPerPile
              << " steps of each; fewer steps for brute force where it takes long.\n"
              << "In every step all back-ends found the same number of pairs.\n\n";
    printMeasurements(std::cout, report);
    printGrowth(std::cout, report);
    const std::filesystem::path figure = options.out / "growth.svg";
    write(figure, figureOf(report));
    std::cout << "\nThe plot is in " << figure.string() << "\n";
    if (!options.json.empty())
        write(options.json, jsonOf(report));
}

} // namespace

int main(int count, char** arguments)
{
    if (count > 1 && (std::strcmp(arguments[1], "--help") == 0 || std::strcmp(arguments[1], "-h") == 0)) {
        std::cout << usage;
        return EXIT_SUCCESS;
    }
    try {
        runAll(optionsOf(count, arguments));
    } catch (const std::invalid_argument& error) {
        std::cerr << error.what() << "\n" << usage;
        return 2;
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return EXIT_FAILURE;
    }
}
