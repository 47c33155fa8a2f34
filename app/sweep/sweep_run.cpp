#include "app/sweep/sweep_run.h"

#include "app/exit_status.h"
#include "io/worker/child_process.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

namespace knead {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double endless = 1e9; // [s]
constexpr const char* program = "/proc/self/exe";
constexpr const char* prefix = "knead: ";
constexpr const char* warningPrefix = "knead: warning: ";

std::vector<std::string> argumentsOf(const SweepFolder& folder, const SweepPlan& plan, std::size_t point,
                                     unsigned threads)
{
    std::vector<std::string> arguments{
        "knead", "run", "--json", "--end-with-parent", "--threads", std::to_string(threads)};
    for (const RecipeOverride& change : plan.changesOf(point)) {
        arguments.emplace_back("--set");
        arguments.push_back(change.path + "=" + change.value);
    }
    arguments.insert(arguments.end(),
                     {"--out", plan.keepsExports ? folder.exportsOf(point) : folder.path(), "--", plan.recipe});
    return arguments;
}

/// The sentence of a failure, or all warnings, without the name of the program.
std::string messageIn(const std::string& errors, bool isFailure)
{
    std::istringstream lines(errors);
    std::string message;
    for (std::string line; std::getline(lines, line);) {
        const bool isWarning = line.starts_with(warningPrefix);
        if (!line.starts_with(prefix) || isWarning == isFailure)
            continue;
        const std::string sentence = line.substr(std::string(isWarning ? warningPrefix : prefix).size());
        message += (message.empty() ? "" : " ") + sentence;
    }
    return message.empty() && isFailure ? "The run ended without saying why." : message;
}

bool isCrash(int signal)
{
    return signal == SIGSEGV || signal == SIGBUS || signal == SIGFPE || signal == SIGABRT || signal == SIGILL;
}

/// What a run that came to its own end gave.
PointResult resultOf(const ChildEnd& end, const NamelessFile& output, const NamelessFile& errors)
{
    PointResult result;
    const bool isSignaled = end.kind == ChildEnd::Kind::signaled;
    result.status = isSignaled ? 128 + end.number : end.number;
    if (isSignaled)
        result.message = "The run crashed (" + reasonOfSignal(end.number).english() + ").";
    else
        result.message = messageIn(errors.content(), result.status != exit_status::done);
    if (result.status == exit_status::done)
        result.report = output.content();
    if (!result.report.empty() && !nlohmann::json::accept(result.report))
        result = {.status = exit_status::failed, .message = "What the run reported cannot be read."};
    return result;
}

void checkWasNotEnded(const ChildEnd& end, std::size_t point)
{
    const bool isEnded = end.kind == ChildEnd::Kind::signaled && !isCrash(end.number);
    const bool isInterrupted = end.kind == ChildEnd::Kind::exited && end.number == exit_status::interrupted;
    if (isEnded || isInterrupted)
        throw RunWasEnded("The run of point " + std::to_string(point) + " was stopped (" +
                          (isEnded ? reasonOfSignal(end.number).english() : "interrupted") +
                          "); the same command carries it out again.");
}

/// A run takes as long as it takes, and meanwhile a person may edit.
void checkInputs(const SweepPlan& plan)
{
    if (const std::string name = changedInput(plan); !name.empty())
        throw std::runtime_error(name +
                                 " was changed while the sweep ran. What was finished before is kept; put the old one "
                                 "back and give the same command, or begin anew with --restart.");
}

} // namespace

PointResult runPoint(const SweepFolder& folder, const SweepPlan& plan, std::size_t point, unsigned threads,
                     TaskControl& control)
{
    std::error_code ignored;
    std::filesystem::remove_all(folder.exportsOf(point), ignored); // of a run that was cut off
    const NamelessFile output;
    const NamelessFile errors;
    const Clock::time_point start = Clock::now();
    const ChildEnd end = runChild(
        {.program = program,
         .arguments = argumentsOf(folder, plan, point, threads),
         .output = &output,
         .errors = &errors},
        endless, [](std::string_view) {}, [&] { return control.isCancelled(); });
    if (end.kind == ChildEnd::Kind::cancelled)
        throw Cancelled();
    checkWasNotEnded(end, point);
    checkInputs(plan);
    PointResult result = resultOf(end, output, errors);
    result.elapsed = std::chrono::duration<double>(Clock::now() - start).count();
    folder.keep(plan, point, result);
    return result;
}

} // namespace knead
