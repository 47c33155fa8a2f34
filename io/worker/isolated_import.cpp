#include "io/worker/isolated_import.h"

#include "io/cad_format.h"
#include "io/worker/child_process.h"
#include "io/worker/import_worker.h"
#include "io/worker/model_file.h"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <limits>

#include <unistd.h>

namespace knead {

namespace {

constexpr double mebibyte = 1 << 20;
constexpr double leastMemory = 3072 * mebibyte;
constexpr double memoryPerByte =
    400; // OpenCASCADE takes 5 to 40 bytes for one of a file, and its triangles come on top
constexpr double largestShare = 0.75; // of the machine's memory
constexpr double leastTime = 120;     // [s]
constexpr double timePerMebibyte = 30;

constexpr double readingShare = 0.95; // of the progress; the rest is handing over

double machineMemory()
{
    return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
}

/// "2 minutes", "45 s"
std::string duration(double seconds)
{
    return seconds < 120 ? std::to_string(std::lround(seconds)) + " s"
                         : std::to_string(std::lround(seconds / 60)) + " minutes";
}

/// The stages that came through the pipe; keeps the last for the sentence about a crash.
class StageList {
public:
    explicit StageList(TaskControl& control)
        : m_control(control)
    {
    }

    void take(std::string_view line)
    {
        double fraction = 0;
        std::string stage;
        if (!readStageLine(line, fraction, stage))
            return;
        m_last = stage;
        m_control.report(readingShare * fraction, stage);
    }

    /// " while making shapes"
    std::string whileLast() const { return m_last.empty() ? std::string() : " while " + m_last; }

private:
    TaskControl& m_control;
    std::string m_last;
};

std::string crashReason(int signal)
{
    switch (signal) {
    case SIGSEGV:
    case SIGBUS:
        return "memory access";
    case SIGFPE:
        return "arithmetic";
    case SIGABRT:
        return "internal error";
    case SIGILL:
        return "illegal instruction";
    case SIGKILL:
        return "ended from outside, perhaps because the machine ran out of memory";
    default:
        return "signal " + std::to_string(signal);
    }
}

[[noreturn]] void failFor(const std::string& path, const ChildEnd& end, const ImportLimits& limits,
                          const StageList& stages)
{
    const bool outOfTime = end.kind == ChildEnd::Kind::signaled && end.number == SIGXCPU;
    if (outOfTime || end.kind == ChildEnd::Kind::tooLong)
        failReading(path,
                    "reading took longer than " + duration(outOfTime ? limits.processorTime : limits.wallTime) +
                        stages.whileLast() +
                        " and was ended. Nothing was imported; the file is damaged, or needs a longer time limit.");
    if (end.kind == ChildEnd::Kind::signaled)
        failReading(path, "the reader crashed" + stages.whileLast() + " (" + crashReason(end.number) +
                              "). Nothing was imported; export the file again, best as STEP.");
    failReading(path, "the reader ended without a result" + stages.whileLast() +
                          ". Nothing was imported; export the file again.");
}

/// Runs the request in a process of its own and returns what it left.
template <class Result>
Result readIsolated(const std::string& program, const ReadingRequest& request, const ImportLimits& limits,
                    TaskControl& control, Result (*fromBytes)(std::string_view))
{
    const std::string& path = request.path;
    control.throwIfCancelled();
    recognizeFormat(path); // what is no CAD file at all needs no process to be told so
    const NamelessFile result;
    StageList stages(control);
    const double wallTime = limits.wallTime > 0 ? limits.wallTime : 1e9;
    const ChildEnd end = runChild(
        program, argumentsFor(request), result, wallTime, [&](std::string_view line) { stages.take(line); },
        [&] { return control.isCancelled(); });
    if (end.kind == ChildEnd::Kind::cancelled)
        throw Cancelled();
    if (end.kind != ChildEnd::Kind::exited || end.number != 0)
        failFor(path, end, limits, stages);

    control.report(readingShare, "taking the parts over");
    const std::string bytes = result.content();
    if (const std::string failure = failureIn(bytes); !failure.empty())
        throw std::runtime_error(failure);
    control.throwIfCancelled();
    try {
        Result read = fromBytes(bytes);
        read.file = path; // as given, whatever letters it is written in
        control.report(1, "done");
        return read;
    } catch (const std::runtime_error& error) {
        failReading(path, "the reader's result is damaged (" + std::string(error.what()) +
                              "). Nothing was imported; try again.");
    }
}

OwnLimits ownLimits(const ImportLimits& limits)
{
    return {limits.memory, static_cast<unsigned>(std::ceil(limits.processorTime))};
}

} // namespace

ImportLimits limitsFor(const std::string& path, const ImportOptions& options)
{
    std::error_code error;
    const std::uintmax_t found = std::filesystem::file_size(path, error);
    const double size = error ? 0 : static_cast<double>(found);
    const double memory = options.memoryLimit > 0
                              ? options.memoryLimit
                              : std::min(leastMemory + memoryPerByte * size, largestShare * machineMemory());
    const double time = options.timeLimit > 0 ? options.timeLimit : leastTime + timePerMebibyte * size / mebibyte;
    return {static_cast<std::uint64_t>(memory), time, 2 * time};
}

Model importIsolated(const std::string& program, const std::string& path, const ImportOptions& options,
                     const ImportLimits& limits, TaskControl& control)
{
    return readIsolated(program, {ReadingTask::import, path, options, ownLimits(limits)}, limits, control,
                        modelFromBytes);
}

FilePreview previewIsolated(const std::string& program, const std::string& path, const ImportLimits& limits,
                            TaskControl& control)
{
    return readIsolated(program, {ReadingTask::preview, path, {}, ownLimits(limits)}, limits, control,
                        previewFromBytes);
}

} // namespace knead
