#include "app/project_replay.h"

#include "app/recipe_exports.h"
#include "core/session/export_jobs.h"
#include "io/project/packing.h"

#include <algorithm>
#include <stdexcept>

namespace knead {

namespace {

constexpr double repeatingShare = 0.9; // of the progress, when files are written after it

std::vector<RecipeExport> wantedExports(const std::vector<std::string>& files, const ExportJob& job)
{
    std::vector<RecipeExport> exports;
    for (const std::string& file : files) {
        exports.push_back({.file = file});
        exports.back().options = job.options;
    }
    return exports;
}

std::vector<RepeatedEntry> repeatAll(HistoryReplay& replay, const std::vector<std::uint32_t>& entries,
                                     TaskControl& control)
{
    const std::set<History::Entry> all(entries.begin(), entries.end());
    double steps = 0;
    for (const std::uint32_t entry : entries)
        steps += static_cast<double>(1 + replay.ownSteps(entry));
    std::vector<RepeatedEntry> repeated;
    double done = 0;
    for (const std::uint32_t entry : entries) {
        const double end = done + static_cast<double>(1 + replay.ownSteps(entry));
        TaskPortion portion(control, done / steps, end / steps);
        repeated.push_back(replay.repeat(entry, portion, all));
        done = end;
    }
    return repeated;
}

void writeFiles(const Project& project, const std::vector<std::string>& files, HistoryReplay& replay,
                ReplayReport& report, TaskControl& control)
{
    const RepeatedEntry& at = report.entries.back();
    if (!at.trouble.empty())
        throw std::runtime_error("Nothing was written, since entry " + std::to_string(at.entry) +
                                 " was not reached: " + at.trouble.english());
    if (project.model == nullptr)
        throw std::runtime_error("The project has no parts that could be written.");
    const std::shared_ptr<const Snapshot> snapshot = replay.snapshot();
    const ProjectStart& start = project.starts[project.entries[at.entry].start];
    ExportJob job = exportJobOf(*modelOf(project, start), start.partOfBody, *snapshot);
    const std::vector<RecipeExport> exports = wantedExports(files, job);
    prepareFolders(exports, ".");
    WrittenExports written = writeExports(exports, ".", std::move(job), *snapshot, control);
    report.files = std::move(written.files);
    report.exports = std::move(written.reports);
}

} // namespace

bool ReplayReport::isSame() const
{
    return std::all_of(entries.begin(), entries.end(), [](const RepeatedEntry& entry) { return entry.isSame; });
}

ReplayReport replayProject(const Project& project, const ReplayChoices& choices, TaskControl& control)
{
    HistoryReplay replay(project, choices.from, zstandardPacking());
    const double share = choices.exports.empty() ? 1 : repeatingShare;
    TaskPortion repeating(control, 0, share);
    ReplayReport report{repeatAll(replay, choices.entries, repeating), {}, {}};
    if (choices.exports.empty())
        return report;
    TaskPortion writing(control, share, 1);
    writeFiles(project, choices.exports, replay, report, writing);
    return report;
}

} // namespace knead
