#include "app/commands/replay_command.h"
#include "app/cad_process.h"

#include "app/commands/carry_out.h"
#include "app/commands/command_output.h"
#include "app/complaint.h"
#include "app/exit_status.h"
#include "app/export_file.h"
#include "app/hexadecimal.h"
#include "app/project_replay.h"
#include "app/thread_limit.h"
#include "core/model/file_formats.h"
#include "io/export/job_file.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

namespace knead {

namespace {

using Json = nlohmann::ordered_json;

struct ReplayOptions {
    std::string project;
    std::optional<std::uint32_t> entry;
    bool all = false;
    bool fromMoments = false;
    unsigned threads = 0;
    std::vector<std::string> exports;
    bool json = false;
};

std::string fileName(const ReplayOptions& options)
{
    return std::filesystem::path(options.project).filename().string();
}

std::vector<std::uint32_t> entriesOf(const ReplayOptions& options, const Project& project)
{
    const auto count = static_cast<std::uint32_t>(project.entries.size());
    if (count == 0)
        throw std::runtime_error(fileName(options) + " has no history yet: there is nothing to repeat.");
    if (options.all) {
        std::vector<std::uint32_t> entries(count);
        std::iota(entries.begin(), entries.end(), 0U);
        return entries;
    }
    const std::uint32_t entry = options.entry.value_or(project.current);
    if (entry >= count)
        throw std::runtime_error(fileName(options) + " has no entry " + std::to_string(entry) + "; it has " +
                                 (count == 1 ? "only the entry 0." : "0 to " + std::to_string(count - 1) + "."));
    return {entry};
}

std::string verdict(const HistoryRecord& record, const RepeatedEntry& repeated)
{
    if (!repeated.trouble.empty())
        return "not reached: " + repeated.trouble.english();
    using Whole = RepeatedEntry::Whole;
    if (repeated.isSame)
        return repeated.whole == Whole::same ? "same" : "same positions and velocities; no more was kept";
    if (repeated.step == record.step && repeated.hash == record.hash)
        return "different: the same positions and velocities, but other materials, tools or forces";
    return "different: " + hexadecimal(repeated.hash) + " at step " + std::to_string(repeated.step);
}

/// As many columns as a terminal shows, but for wide letters.
std::size_t widthOf(const std::string& text)
{
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

void printTable(const Project& project, const ReplayReport& report)
{
    std::size_t width = 4;
    for (const RepeatedEntry& repeated : report.entries)
        width = std::max(width, widthOf(project.entries[repeated.entry].name));
    const auto padded = [&](const std::string& name) { return name + std::string(width - widthOf(name), ' '); };
    std::printf("entry  %s  %8s  %9s  %-16s  repeated\n", padded("name").c_str(), "step", "time s", "hash");
    for (const RepeatedEntry& repeated : report.entries) {
        const HistoryRecord& record = project.entries[repeated.entry];
        std::printf("%5u  %s  %8llu  %9.4f  %s  %s\n", repeated.entry, padded(record.name).c_str(),
                    static_cast<unsigned long long>(record.step), record.time, hexadecimal(record.hash).c_str(),
                    verdict(record, repeated).c_str());
    }
    printWritten(report.files, report.exports);
}

const char* wholeWord(RepeatedEntry::Whole whole)
{
    using Whole = RepeatedEntry::Whole;
    return whole == Whole::notKept ? "not kept" : whole == Whole::same ? "same" : "different";
}

Json toJson(const HistoryRecord& record, const RepeatedEntry& repeated)
{
    Json json{{"entry", repeated.entry},
              {"name", record.name},
              {"step", record.step},
              {"time_s", record.time},
              {"state_hash", hexadecimal(record.hash)},
              {"same", repeated.isSame}};
    if (repeated.trouble.empty()) {
        json["repeated_step"] = repeated.step;
        json["repeated_hash"] = hexadecimal(repeated.hash);
        json["whole_state"] = wholeWord(repeated.whole);
    } else {
        json["trouble"] = repeated.trouble.english();
    }
    return json;
}

void printJson(const Project& project, const ReplayReport& report)
{
    Json json{{"same", report.isSame()}, {"entries", Json::array()}, {"files", report.files}};
    for (const RepeatedEntry& repeated : report.entries)
        json["entries"].push_back(toJson(project.entries[repeated.entry], repeated));
    json["exports"] = Json::array();
    for (const ExportReport& exported : report.exports)
        json["exports"].push_back(Json::parse(reportToJson(exported)));
    printAsJson(json);
}

int judge(const ReplayOptions& options, const ReplayReport& report)
{
    if (report.isSame())
        return exit_status::done;
    const auto different = std::count_if(report.entries.begin(), report.entries.end(),
                                         [](const RepeatedEntry& entry) { return !entry.isSame; });
    return complain(fileName(options) + ": " + std::to_string(different) + " of " +
                        std::to_string(report.entries.size()) +
                        " entries came to another state than the one that is kept, as with another version of Knead.",
                    exit_status::failed);
}

/// Each step of the work with the status that its failure has.
int repeat(const ReplayOptions& options, TerminalControl& control, int& failure)
{
    TaskPortion reading(control, 0, 0.1);
    const Project project = readProjectAfterTrial(options.project, reading);
    const ReplayChoices choices{.entries = entriesOf(options, project),
                                .from =
                                    options.fromMoments ? HistoryReplay::From::moments : HistoryReplay::From::starts,
                                .exports = options.exports};
    failure = exit_status::failed;
    TaskPortion repeating(control, 0.1, 1);
    const ReplayReport report = replayProject(project, choices, repeating);
    control.clear();
    options.json ? printJson(project, report) : printTable(project, report);
    return judge(options, report);
}

/// What is wrong with the arguments, before anything is read; empty when nothing is.
std::string problemWith(const ReplayOptions& options)
{
    if (options.all && !options.exports.empty())
        return "--export writes one entry, and --all repeats them all; name one with --entry.";
    for (const std::string& file : options.exports)
        if (const std::string problem = problemWithName(file); !problem.empty())
            return problem;
    return {};
}

int replay(const ReplayOptions& options)
{
    if (const std::string problem = problemWith(options); !problem.empty())
        return complain(problem, exit_status::wrongUse);
    const ThreadLimit limit(options.threads);
    return carryOut([&](TerminalControl& control, int& failure) { return repeat(options, control, failure); });
}

} // namespace

void addReplayCommand(CLI::App& program, int& exitStatus)
{
    auto options = std::make_shared<ReplayOptions>();
    CLI::App* command = program.add_subcommand(
        "replay", "Repeat what was done in a project and compare the state, bit for bit, with the one that is kept");
    command->add_option("PROJECT", options->project, "Project file, saved by the window")->required();
    auto* entry =
        command->add_option("--entry", options->entry, "Entry of the history to come to; without it the present one");
    entry->type_name("N");
    command->add_flag("--all", options->all, "Every entry of the history, each branch")->excludes(entry);
    command->add_flag("--from-moments", options->fromMoments,
                      "Begin at the nearest state that is kept instead of repeating everything");
    command
        ->add_option("--export", options->exports,
                     "Write the parts as they are there: " + formatEndings(" and ") +
                         ", or .png. May be given several times")
        ->type_name("FILE")
        ->expected(1)
        ->allow_extra_args(false)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command->add_option("--threads", options->threads, "Number of threads; the result is the same for any")
        ->type_name("N")
        ->check(CLI::Range(1U, 1024U));
    command->add_flag("--json", options->json, "Print the report as JSON");
    command->callback([options, &exitStatus] { exitStatus = replay(*options); });
}

} // namespace knead
