#include "app/sweep/slurm_engine.h"

#include "app/file_content.h"
#include "app/sweep/queue_watch.h"
#include "io/files/safe_file.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <thread>

namespace knead {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t arrayLength =
    1000; // Slurm's own limit on the numbers of tasks, unless it is configured otherwise
constexpr std::chrono::milliseconds pauseOfTasks{200}; // between looks at the folder
constexpr std::size_t tailLength = 300;                // of what a task printed, in a sentence

constexpr const char* jobsName = "slurm/jobs.json";

std::string scriptFor(const SweepFolder& folder, unsigned threads)
{
    const std::string program = fs::read_symlink("/proc/self/exe").string();
    return "#!/bin/sh\n"
           "# Carries out one point of a sweep: its number is that of the task plus the first argument.\n"
           "exec " +
           quotedForShell(program) + " sweep-point " + quotedForShell(folder.path()) +
           " $((SLURM_ARRAY_TASK_ID + $1)) --threads " + std::to_string(threads) + "\n";
}

std::string jobName(const SweepPlan& plan)
{
    return "knead-" + plan.key.substr(0, 8);
}

/// The sweep as its jobs go along.
class SlurmSweep {
public:
    SlurmSweep(const SweepFolder& folder, const SweepPlan& plan, const std::vector<std::size_t>& points,
               SweepProgress& progress)
        : m_folder(folder)
        , m_plan(plan)
        , m_missing(points.begin(), points.end())
        , m_progress(progress)
        , m_jobs(jobsOf(folder))
        , m_queue(jobName(plan))
    {
    }

    LostPoints run(const SlurmOptions& options)
    {
        m_queue.ask(m_jobs, m_missing);
        submitMissing(options);
        m_queue.begin(m_missing);
        while (!m_missing.empty()) {
            m_progress.control().throwIfCancelled();
            collect();
            m_queue.askNowAndThen(m_jobs, m_missing);
            giveUpVanished();
            m_progress.show(std::to_string(m_queue.queued().size()) +
                            (m_queue.answers() ? " in Slurm" : " in Slurm, which does not answer"));
            if (!m_missing.empty())
                std::this_thread::sleep_for(pauseOfTasks);
        }
        return m_lost;
    }

private:
    /// In arrays of the length that Slurm takes.
    void submitMissing(const SlurmOptions& options)
    {
        std::map<std::size_t, std::vector<std::size_t>> tasks; // by their base
        for (const std::size_t point : m_missing)
            if (!m_queue.queued().contains(point))
                tasks[point / arrayLength * arrayLength].push_back(point % arrayLength);
        if (tasks.empty())
            return;
        const std::string script = m_folder.pathOf("slurm/task.sh");
        fs::create_directories(m_folder.pathOf("slurm"));
        writeFileSafely(script, scriptFor(m_folder, options.threads));
        for (auto& [base, numbers] : tasks) {
            m_jobs.push_back(submit({.script = script,
                                     .folder = m_folder.pathOf("slurm"),
                                     .name = jobName(m_plan),
                                     .base = base,
                                     .tasks = std::move(numbers),
                                     .throttle = options.throttle,
                                     .threads = options.threads,
                                     .options = options.options}));
            keepJobs(m_folder.pathOf(jobsName), m_jobs);
        }
    }

    /// Takes up results that have come.
    void collect()
    {
        for (auto point = m_missing.begin(); point != m_missing.end();) {
            const std::optional<PointResult> result = m_folder.result(m_plan, *point);
            if (!result) {
                ++point;
                continue;
            }
            m_progress.finished(*point, *result);
            m_queue.finished(*point);
            point = m_missing.erase(point);
        }
    }

    /// Tasks that ended a while ago and left no result.
    void giveUpVanished()
    {
        for (auto point = m_missing.begin(); point != m_missing.end();) {
            if (!m_queue.hasVanished(*point)) {
                ++point;
                continue;
            }
            m_lost.emplace(*point, sentenceFor(*point));
            m_progress.lost(m_lost.at(*point));
            point = m_missing.erase(point);
        }
    }

    /// The last job that had the point, with the end of what its task printed.
    std::string sentenceFor(std::size_t point) const
    {
        const std::size_t base = point / arrayLength * arrayLength;
        const auto job =
            std::find_if(m_jobs.rbegin(), m_jobs.rend(), [&](const SlurmJob& one) { return one.base == base; });
        const std::string task = job->id + "_" + std::to_string(point - base);
        std::string printed = textOf(m_folder.pathOf("slurm/" + task + ".txt")).value_or("");
        std::replace(printed.begin(), printed.end(), '\n', ' ');
        printed = printed.substr(printed.size() - std::min(printed.size(), tailLength));
        return "The task " + task + " of point " + std::to_string(point) + " vanished from Slurm without a result" +
               (printed.empty() ? ". " : "; it said: " + printed) + "The same command submits it again.";
    }

    const SweepFolder& m_folder;
    const SweepPlan& m_plan;
    std::set<std::size_t> m_missing;
    SweepProgress& m_progress;
    std::vector<SlurmJob> m_jobs;
    QueueWatch m_queue;
    LostPoints m_lost;
};

} // namespace

LostPoints runOnSlurm(const SweepFolder& folder, const SweepPlan& plan, const std::vector<std::size_t>& points,
                      const SlurmOptions& options, SweepProgress& progress)
{
    return SlurmSweep(folder, plan, points, progress).run(options);
}

std::vector<SlurmJob> jobsOf(const SweepFolder& folder)
{
    return jobsIn(folder.pathOf(jobsName));
}

} // namespace knead
