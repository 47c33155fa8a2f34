#include "io/worker/isolated_import.h"
#include "support/deep.h"
#include "support/fuzz_inputs.h"
#include "support/loaded_reader.h"
#include "support/model_flaws.h"

#include <QtTest>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <malloc.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace knead;

namespace {

constexpr ImportLimits limits{.memory = 2ULL << 30U, .processorTime = 10, .wallTime = 30};
constexpr double mostGrowth = 32; // [MiB] of this process, from the tenth part of the inputs to the last
constexpr double mebibyte = 1 << 20;
constexpr std::size_t mostNamed = 8; // files of one manner of end, in the report

/// Stands for this program, which reads files for itself, as knead does.
const std::string reader = KNEAD_READER_LAUNCHER;

std::uint64_t environmentNumber(const char* name, std::uint64_t otherwise)
{
    bool isNumber = false;
    const qulonglong number = qEnvironmentVariable(name).toULongLong(&isNumber);
    return isNumber ? number : otherwise;
}

/// [MiB] of this process in memory, without what is free in its heaps.
double residentMemory()
{
    malloc_trim(0);
    std::ifstream file("/proc/self/statm");
    double total = 0;
    double resident = 0;
    file >> total >> resident;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / mebibyte;
}

enum class Ending { read, refused, crashed, tooLong, broken };

struct Outcome {
    std::string file;
    Ending ending = Ending::broken;
    std::string manner;  ///< of a violent end: "the reader crashed while making shapes (memory access)"
    std::string problem; ///< why it is not as it should be; empty when it is
};

/// How reading ended when not by itself; empty when it did.
std::string violentEnd(const std::string& sentence)
{
    for (const char* start : {"the reader crashed", "the reader ended without", "reading took longer than"})
        if (const std::size_t begin = sentence.find(start); begin != std::string::npos)
            return sentence.substr(begin,
                                   std::min(sentence.find(". ", begin), sentence.find(" and was", begin)) - begin);
    return {};
}

Outcome tryImport(const std::filesystem::path& path, const ImportOptions& options)
{
    const std::string name = path.filename();
    try {
        const Model model = importIsolated(reader, path, options, limits, TaskControl::none());
        return {name, Ending::read, {}, flawOf(model)};
    } catch (const Cancelled&) {
        return {name, Ending::broken, {}, "it was cancelled by nobody"};
    } catch (const std::runtime_error& error) {
        const std::string manner = violentEnd(error.what());
        const Ending ending = manner.empty()                     ? Ending::refused
                              : manner.starts_with("the reader") ? Ending::crashed
                                                                 : Ending::tooLong;
        return {name, ending, manner, flawOfRefusal(error.what(), name)};
    } catch (const std::exception& error) {
        return {name, Ending::broken, {}, std::string("an exception that is no sentence: ") + error.what()};
    }
}

std::size_t countOf(const std::vector<Outcome>& outcomes, Ending ending)
{
    return static_cast<std::size_t>(
        std::count_if(outcomes.begin(), outcomes.end(), [&](const Outcome& o) { return o.ending == ending; }));
}

/// A line per format, then every manner of violent end with the files it happened to.
void report(const std::vector<Outcome>& outcomes)
{
    std::map<std::string, std::vector<Outcome>> formats;
    std::map<std::string, std::vector<std::string>> manners;
    for (const Outcome& outcome : outcomes) {
        const std::string format = std::filesystem::path(outcome.file).extension();
        formats[format].push_back(outcome);
        if (!outcome.manner.empty())
            manners[format + ": " + outcome.manner].push_back(outcome.file);
    }
    std::printf("%-8s %7s %7s %8s %8s %9s\n", "format", "inputs", "read", "refused", "crashed", "too long");
    for (const auto& [format, some] : formats)
        std::printf("%-8s %7zu %7zu %8zu %8zu %9zu\n", format.c_str(), some.size(), countOf(some, Ending::read),
                    countOf(some, Ending::refused), countOf(some, Ending::crashed), countOf(some, Ending::tooLong));
    for (const auto& [manner, files] : manners) {
        std::printf("%zu x %s\n", files.size(), manner.c_str());
        for (std::size_t i = 0; i < std::min(files.size(), mostNamed); ++i)
            std::printf("    %s\n", files[i].c_str());
    }
    std::fflush(stdout);
}

} // namespace

/// Thousands of damaged files, each read in a process of its own: every one gives a sound model or one clear sentence.
///
/// KNEAD_FUZZ_INPUTS says how many, KNEAD_FUZZ_SEED which, KNEAD_FUZZ_KEEP where those stay that are to be looked at, and
/// KNEAD_FUZZ_FOLDER of which CAD files they are made instead of small ones of our own.
class ImportFuzzTest : public QObject {
    Q_OBJECT

public:
    ImportFuzzTest()
        : m_inputs(inputs())
        , m_kept(qEnvironmentVariable("KNEAD_FUZZ_KEEP", QDir::tempPath() + "/knead-fuzz").toStdString())
    {
        qputenv("TMPDIR", m_temporary.path().toUtf8());
        m_readers.emplace(m_folder.path().toStdString());
    }

private slots:
    void soundFilesAreRead();
    void entitiesArePutTogetherAgain();
    void theSameSeedGivesTheSameFiles();
    void everyInputGivesASoundModelOrASentence();
    void nothingIsLeftBehind();

private:
    static fuzz::Inputs inputs()
    {
        const std::string folder = qEnvironmentVariable("KNEAD_FUZZ_FOLDER").toStdString();
        return folder.empty() ? fuzz::Inputs(std::string(KNEAD_TEST_DATA) + "/fuzz/seeds")
                              : fuzz::Inputs::ofFolder(folder);
    }

    std::filesystem::path write(const fuzz::Input& input) const
    {
        const std::filesystem::path path = m_folder.filePath(input.name.c_str()).toStdString();
        std::ofstream(path, std::ios::binary) << input.bytes;
        return path;
    }
    Outcome run(std::uint64_t number) const;
    void runAll(std::uint64_t begin, std::uint64_t end, std::vector<Outcome>& outcomes) const;

    fuzz::Inputs m_inputs;
    std::uint64_t m_seed = environmentNumber("KNEAD_FUZZ_SEED", 1);
    std::uint64_t m_count = environmentNumber("KNEAD_FUZZ_INPUTS", loadOf<std::uint64_t>(700, 2000));
    QTemporaryDir m_folder;
    QTemporaryDir m_temporary; ///< what the readers take for the folder for temporary files
    std::filesystem::path m_kept;
    std::optional<LoadedReader> m_readers;
};

void ImportFuzzTest::soundFilesAreRead()
{
    for (const fuzz::Input& input : m_inputs.sound()) {
        const Outcome outcome = tryImport(write(input), {.linearDeflection = 1e-3, .angularDeflection = 0.5});
        QVERIFY2(outcome.ending == Ending::read && outcome.problem.empty(),
                 (input.name + ": " + outcome.manner + outcome.problem).c_str());
    }
}

/// Taking a file apart and putting it together again is no damage in itself.
void ImportFuzzTest::entitiesArePutTogetherAgain()
{
    const auto partsIn = [&](const std::string& name, const std::string& bytes) {
        return importIsolated(reader, write({name, bytes, {}}), {.linearDeflection = 1e-3}, limits, TaskControl::none())
            .parts.size();
    };
    for (const fuzz::Input& input : m_inputs.sound()) {
        if (input.name.ends_with(".step"))
            QCOMPARE(partsIn("again.step", fuzz::parsedStep(input.bytes).text()), partsIn(input.name, input.bytes));
        if (input.name.ends_with(".igs"))
            QCOMPARE(partsIn("again.igs", fuzz::parsedIges(input.bytes).text()), partsIn(input.name, input.bytes));
    }
}

void ImportFuzzTest::theSameSeedGivesTheSameFiles()
{
    const fuzz::Inputs others = inputs();
    int different = 0;
    for (std::uint64_t number = 0; number < 50; ++number) {
        QVERIFY(m_inputs.input(m_seed, number).bytes == others.input(m_seed, number).bytes);
        different += m_inputs.input(m_seed, number).bytes != m_inputs.input(m_seed + 1, number).bytes ? 1 : 0;
    }
    QVERIFY(different > 45);
}

Outcome ImportFuzzTest::run(std::uint64_t number) const
{
    const fuzz::Input input = m_inputs.input(m_seed, number);
    const std::filesystem::path path = write(input);
    Outcome outcome = tryImport(path, input.options);
    if (outcome.ending != Ending::read && outcome.ending != Ending::refused)
        outcome.manner += input.options.heal ? "" : " without healing";
    if (!outcome.problem.empty() || !outcome.manner.empty()) {
        std::filesystem::create_directories(m_kept);
        std::filesystem::copy_file(path, m_kept / path.filename(), std::filesystem::copy_options::overwrite_existing);
    }
    std::filesystem::remove(path);
    return outcome;
}

void ImportFuzzTest::runAll(std::uint64_t begin, std::uint64_t end, std::vector<Outcome>& outcomes) const
{
    std::atomic<std::uint64_t> next{begin};
    std::vector<std::jthread> threads;
    for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i)
        threads.emplace_back([&] {
            for (std::uint64_t number = next++; number < end; number = next++)
                outcomes[number] = run(number);
        });
}

void ImportFuzzTest::everyInputGivesASoundModelOrASentence()
{
    std::vector<Outcome> outcomes(m_count);
    runAll(0, m_count / 10, outcomes);
    const double before = residentMemory();
    runAll(m_count / 10, m_count, outcomes);
    const double growth = residentMemory() - before;
    report(outcomes);

    std::string problems;
    for (const Outcome& outcome : outcomes)
        if (!outcome.problem.empty())
            problems += "\n" + outcome.file + ": " + outcome.problem;
    QVERIFY2(problems.empty(), ("kept in " + m_kept.string() + ":" + problems).c_str());
    QVERIFY2(growth < mostGrowth, qPrintable(QString("grew by %1 MiB").arg(growth)));
    // Damage that is always refused, or never, tests nothing.
    QVERIFY(10 * countOf(outcomes, Ending::read) > m_count);
    QVERIFY(10 * countOf(outcomes, Ending::refused) > m_count);
    // The process of its own is for what no check foresees; it is no excuse for what is common.
    QVERIFY(countOf(outcomes, Ending::crashed) <= 1 + m_count / 50);
    QVERIFY(countOf(outcomes, Ending::tooLong) <= 1 + m_count / 200);
}

void ImportFuzzTest::nothingIsLeftBehind()
{
    QVERIFY(std::filesystem::is_empty(m_temporary.path().toStdString()));
    QCOMPARE(waitpid(-1, nullptr, WNOHANG), -1);
    QCOMPARE(errno, ECHILD);
}

int main(int argc, char** argv)
{
    ImportFuzzTest test;                             // before there are threads
    qputenv("QTEST_FUNCTION_TIMEOUT", "2000000000"); // [ms]; the tests take as long as there are inputs
    QCoreApplication application(argc, argv);
    return QTest::qExec(&test, argc, argv);
}
#include "import_fuzz_test.moc"
