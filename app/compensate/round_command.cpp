#include "app/compensate/round_command.h"

#include "app/file_content.h"
#include "app/sweep/queue_watch.h"
#include "io/files/safe_file.h"
#include "io/worker/child_process.h"
#include "io/worker/own_process.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <deque>
#include <filesystem>
#include <iostream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <thread>

#include <fcntl.h>
#include <unistd.h>

namespace knead {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

constexpr const char* ownProgram = "/proc/self/exe";
constexpr const char* commandName = "command.json";
constexpr const char* roundJobsName = "jobs.json";
constexpr const char* roundScriptName = "task.sh";
constexpr const char* roundStatusName = "status.txt"; // of a task of Slurm that has ended
constexpr std::size_t linesOfLog = 3;                 // in a sentence
constexpr std::size_t longestTail = 400;
constexpr int statusNotFound = 127;                    // as shells have it
constexpr int statusTooLong = 124;                     // as `timeout` has it
constexpr std::chrono::milliseconds pauseOfRound{200}; // between looks for the end of a task

std::string pathIn(const RoundCommand& command, const char* name)
{
    return (fs::path(command.folder) / name).string();
}

/// The last lines of what a command printed, in one.
std::string tailOf(const std::string& log)
{
    std::istringstream lines(log);
    std::deque<std::string> last;
    for (std::string line; std::getline(lines, line);) {
        line.erase(0, line.find_first_not_of(" \t\r"));
        line.erase(line.find_last_not_of(" \t\r") + 1);
        if (line.empty())
            continue;
        last.push_back(line);
        if (last.size() > linesOfLog)
            last.pop_front();
    }
    std::string tail;
    for (const std::string& line : last)
        tail += (tail.empty() ? "" : " | ") + line;
    return tail.substr(tail.size() - std::min(tail.size(), longestTail));
}

[[noreturn]] void fail(const RoundCommand& command, const std::string& what)
{
    const std::string tail = tailOf(textOf(pathIn(command, roundLogName)).value_or(""));
    throw std::runtime_error("Round " + std::to_string(command.round) + ": " + what +
                             (tail.empty() ? "; it printed nothing." : "; it printed last: " + tail) + " (" +
                             pathIn(command, roundLogName) + ")");
}

[[noreturn]] void failOfTime(const RoundCommand& command)
{
    std::ostringstream limit;
    limit << command.timeLimit;
    fail(command, "the command took longer than the " + limit.str() + " s that \"time_limit_s\" gives it");
}

void checkStatus(const RoundCommand& command, int status)
{
    if (status != 0)
        fail(command, "the command failed with exit status " + std::to_string(status));
}

void checkField(const RoundCommand& command)
{
    std::error_code error;
    const std::string path = pathIn(command, command.field.c_str());
    if (!fs::is_regular_file(path, error))
        fail(command, "the command left no file " + command.field);
    if (fs::file_size(path, error) == 0 || error)
        fail(command, "the command left an empty file " + command.field);
}

void runHere(const RoundCommand& command, TaskControl& control)
{
    const ChildEnd end = runChild(
        {.program = ownProgram,
         .arguments = {"knead", "compensate-command", "--end-with-parent", "--", command.folder}},
        command.timeLimit, [](std::string_view) {}, [&] { return control.isCancelled(); });
    switch (end.kind) {
    case ChildEnd::Kind::cancelled:
        throw Cancelled();
    case ChildEnd::Kind::tooLong:
        failOfTime(command);
    case ChildEnd::Kind::signaled:
        fail(command, "the command crashed (" + reasonOfSignal(end.number).english() + ")");
    case ChildEnd::Kind::exited:
        checkStatus(command, end.number);
    }
}

/// A task that leaves its exit status in a file when it ends.
std::string scriptFor(const RoundCommand& command)
{
    const std::string knead = quotedForShell(fs::read_symlink(ownProgram).string());
    return "#!/bin/sh\ncd " + quotedForShell(command.folder) + " || exit 1\ntimeout --kill-after=10 " +
           std::to_string(std::lround(std::ceil(command.timeLimit))) + " " + knead +
           " compensate-command .\necho $? > " + roundStatusName + ".part && mv " + roundStatusName + ".part " +
           roundStatusName + "\n";
}

std::optional<int> statusOf(const RoundCommand& command)
{
    std::istringstream text(textOf(pathIn(command, roundStatusName)).value_or(""));
    int status = 0;
    return text >> status ? std::optional(status) : std::nullopt;
}

void submitTask(const RoundCommand& command, const RoundEngine& engine)
{
    const std::string script = pathIn(command, roundScriptName);
    writeFileSafely(script, scriptFor(command));
    keepJobs(pathIn(command, roundJobsName), {submit({.script = script,
                                                      .folder = command.folder,
                                                      .name = engine.jobName,
                                                      .base = static_cast<std::size_t>(command.round),
                                                      .tasks = {0},
                                                      .threads = engine.threads,
                                                      .options = engine.slurmOptions})});
}

void runOnSlurm(const RoundCommand& command, const RoundEngine& engine, TaskControl& control)
{
    if (!isAtWork(command, engine))
        submitTask(command, engine);
    const std::vector<SlurmJob> jobs = jobsIn(pathIn(command, roundJobsName));
    const auto task = static_cast<std::size_t>(command.round);
    QueueWatch queue(engine.jobName);
    queue.begin({task});
    std::optional<int> status;
    while (!(status = statusOf(command))) {
        control.throwIfCancelled();
        queue.askNowAndThen(jobs, {task});
        if (queue.hasVanished(task)) {
            fs::remove(pathIn(command, roundJobsName));
            fail(command, "its task vanished from Slurm without a result; the same command submits it again");
        }
        std::this_thread::sleep_for(pauseOfRound);
    }
    if (*status == statusTooLong)
        failOfTime(command);
    checkStatus(command, *status);
}

} // namespace

bool isAtWork(const RoundCommand& command, const RoundEngine& engine)
{
    const std::vector<SlurmJob> jobs = jobsIn(pathIn(command, roundJobsName));
    if (!engine.isSlurm || jobs.empty())
        return false;
    if (const std::optional<int> status = statusOf(command))
        return *status == 0;
    const auto queued = queuedPoints(jobs, engine.jobName);
    return !queued || queued->contains(static_cast<std::size_t>(command.round));
}

void runCommand(const RoundCommand& command, const RoundEngine& engine, TaskControl& control)
{
    if (!isAtWork(command, engine))
        writeFileSafely(pathIn(command, commandName), Json(command.words).dump(1) + "\n");
    if (engine.isSlurm)
        runOnSlurm(command, engine, control);
    else
        runHere(command, control);
    checkField(command);
}

int becomeCommand(const std::string& folder, bool endsWithParent)
{
    if (endsWithParent)
        knead::endWithParent();
    if (chdir(folder.c_str()) != 0)
        return statusNotFound;
    const int log = open(roundLogName, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    if (log < 0)
        return statusNotFound;
    dup2(log, STDOUT_FILENO);
    dup2(log, STDERR_FILENO);
    close(log);
    const std::vector<std::string> words =
        Json::parse(textOf(commandName).value_or("[]")).get<std::vector<std::string>>();
    std::vector<char*> arguments;
    for (const std::string& word : words)
        arguments.push_back(const_cast<char*>(word.c_str())); // execvp only reads them
    arguments.push_back(nullptr);
    if (!words.empty())
        execvp(arguments[0], arguments.data());
    std::cerr << (words.empty() ? "nothing" : words.front()) << " cannot be started: " << std::strerror(errno) << '\n';
    return statusNotFound;
}

} // namespace knead
