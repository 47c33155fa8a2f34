#include "app/sweep/slurm_commands.h"

#include "app/file_content.h"
#include "io/files/safe_file.h"
#include "io/worker/child_process.h"

#include <nlohmann/json.hpp>

#include <cstdlib>
#include <sstream>
#include <stdexcept>

#include <unistd.h>

namespace knead {

using Json = nlohmann::ordered_json;

namespace {

constexpr double patience = 120; // with a command of Slurm [s]
constexpr const char* unknownJob = "Invalid job id";

struct Answer {
    bool isGood = false;
    std::string output;
    std::string errors;
};

bool isInPath(const std::string& command)
{
    const char* path = std::getenv("PATH");
    std::istringstream folders(path != nullptr ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (access(folder.append("/").append(command).c_str(), X_OK) == 0)
            return true;
    return false;
}

Answer ask(const std::vector<std::string>& words)
{
    if (!isInPath(words.front()))
        throw std::runtime_error("There is no command " + words.front() +
                                 " on this machine. --engine slurm is for machines from "
                                 "which jobs of Slurm are submitted; leave it out to run here.");
    const NamelessFile output;
    const NamelessFile errors;
    const ChildEnd end = runChild(
        {.program = words.front(), .arguments = words, .output = &output, .errors = &errors}, patience,
        [](std::string_view) {}, [] { return false; });
    return {end.kind == ChildEnd::Kind::exited && end.number == 0, output.content(), errors.content()};
}

std::string joinedIds(const std::vector<SlurmJob>& jobs)
{
    std::string ids;
    for (const SlurmJob& job : jobs)
        ids += (ids.empty() ? "" : ",") + job.id;
    return ids;
}

/// What Slurm complains about, in one line and without the name of the command.
std::string complaintIn(const std::string& errors)
{
    std::istringstream lines(errors);
    std::string all;
    for (std::string line; std::getline(lines, line);) {
        const std::size_t mark = line.find("error: ");
        all += (all.empty() ? "" : "; ") + (mark == std::string::npos ? line : line.substr(mark + 7));
    }
    return all.empty() ? "it did not answer" : all;
}

/// The file may have been changed from outside.
std::optional<SlurmJob> jobFrom(const Json& json)
{
    const auto id = json.is_object() ? json.find("job") : json.end();
    const auto base = json.is_object() ? json.find("base") : json.end();
    if (id == json.end() || base == json.end() || !id->is_string() || !base->is_number_unsigned() ||
        !isJobId(id->get<std::string>()))
        return std::nullopt;
    return SlurmJob{*id, *base};
}

std::vector<std::string> wordsOf(const SlurmArray& array)
{
    std::string tasks = rangesOf(array.tasks);
    if (array.throttle > 0)
        tasks.append("%").append(std::to_string(array.throttle));
    std::vector<std::string> words{"sbatch",
                                   "--parsable",
                                   "--array=" + tasks,
                                   "--job-name=" + array.name,
                                   "--cpus-per-task=" + std::to_string(array.threads),
                                   "--chdir=" + array.folder,
                                   "--output=%A_%a.txt"};
    words.insert(words.end(), array.options.begin(), array.options.end());
    words.insert(words.end(), {array.script, std::to_string(array.base)});
    return words;
}

} // namespace

bool isJobId(const std::string& text)
{
    constexpr std::size_t mostDigits = 20;
    return !text.empty() && text.size() <= mostDigits && text.find_first_not_of("0123456789") == std::string::npos;
}

std::string quotedForShell(const std::string& text)
{
    std::string result = "'";
    for (const char character : text)
        result += character == '\'' ? std::string("'\\''") : std::string(1, character);
    return result + "'";
}

std::string rangesOf(const std::vector<std::size_t>& numbers)
{
    std::string text;
    for (std::size_t i = 0; i < numbers.size();) {
        std::size_t end = i;
        while (end + 1 < numbers.size() && numbers[end + 1] == numbers[end] + 1)
            ++end;
        text.append(text.empty() ? "" : ",").append(std::to_string(numbers[i]));
        if (end > i)
            text.append("-").append(std::to_string(numbers[end]));
        i = end + 1;
    }
    return text;
}

SlurmJob submit(const SlurmArray& array)
{
    const Answer answer = ask(wordsOf(array));
    const std::string id = answer.output.substr(0, answer.output.find_first_of(";\n"));
    if (!answer.isGood || id.empty())
        throw std::runtime_error("Slurm refuses the jobs: " + complaintIn(answer.errors) +
                                 ". Options for sbatch are given with --slurm-option.");
    if (!isJobId(id))
        throw std::runtime_error("Slurm's answer names no job: " + id + ".");
    return {id, array.base};
}

std::optional<std::set<std::size_t>> queuedPoints(const std::vector<SlurmJob>& jobs, const std::string& name)
{
    if (jobs.empty())
        return std::set<std::size_t>{};
    const Answer answer = ask({"squeue", "--noheader", "--array", "--format=%F %K %j", "--jobs=" + joinedIds(jobs)});
    if (!answer.isGood && answer.errors.find(unknownJob) == std::string::npos)
        return std::nullopt;
    std::set<std::size_t> points;
    std::istringstream lines(answer.output);
    std::string id;
    std::string found;
    for (std::size_t task = 0; lines >> id >> task >> found;)
        for (const SlurmJob& job : jobs)
            if (job.id == id && found == name)
                points.insert(job.base + task);
    return points;
}

std::vector<SlurmJob> jobsIn(const std::string& path)
{
    std::vector<SlurmJob> jobs;
    const Json json = Json::parse(textOf(path).value_or("[]"), nullptr, false);
    for (const Json& job : json)
        if (const std::optional<SlurmJob> kept = jobFrom(job))
            jobs.push_back(*kept);
    return jobs;
}

void keepJobs(const std::string& path, const std::vector<SlurmJob>& jobs)
{
    Json json = Json::array();
    for (const SlurmJob& job : jobs)
        json.push_back({{"job", job.id}, {"base", job.base}});
    writeFileSafely(path, json.dump() + "\n");
}

bool cancelJobs(const std::vector<SlurmJob>& jobs)
{
    return jobs.empty() || ask({"scancel", joinedIds(jobs)}).isGood;
}

} // namespace knead
