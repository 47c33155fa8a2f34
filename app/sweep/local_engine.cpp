#include "app/sweep/local_engine.h"

#include "app/sweep/sweep_run.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

namespace knead {

namespace {

constexpr std::chrono::milliseconds pauseOfRuns{50};

/// The runs of a sweep: threads that take one point after another, and what they tell the thread that waits for them.
class LocalRuns final : private TaskControl {
public:
    LocalRuns(const SweepFolder& folder, const SweepPlan& plan, const std::vector<std::size_t>& points,
              SweepProgress& progress)
        : m_folder(folder)
        , m_plan(plan)
        , m_points(points)
        , m_progress(progress)
    {
    }

    LostPoints run(unsigned jobs, unsigned threads)
    {
        m_running = jobs;
        std::vector<std::jthread> workers;
        for (unsigned i = 0; i < jobs; ++i)
            workers.emplace_back([this, threads] { work(threads); });
        for (bool isRunning = true; isRunning;) {
            isRunning = m_running > 0;
            tell();
            if (isRunning)
                std::this_thread::sleep_for(pauseOfRuns);
        }
        if (m_failure)
            std::rethrow_exception(m_failure);
        m_progress.control().throwIfCancelled();
        return m_lost;
    }

private:
    void report(double, std::string_view) override {}
    bool isCancelled() const override { return m_isStopped || m_progress.control().isCancelled(); }

    void work(unsigned threads)
    {
        try {
            for (std::size_t i = m_next++; i < m_points.size() && !isCancelled(); i = m_next++)
                carryOut(m_points[i], threads);
        } catch (const Cancelled&) {
        } catch (...) {
            const std::lock_guard lock(m_mutex);
            m_failure = m_failure ? m_failure : std::current_exception();
            m_isStopped = true;
        }
        --m_running;
    }

    void carryOut(std::size_t point, unsigned threads)
    {
        try {
            PointResult result = runPoint(m_folder, m_plan, point, threads, *this);
            const std::lock_guard lock(m_mutex);
            m_finished.emplace_back(point, std::move(result));
        } catch (const RunWasEnded& ended) {
            const std::lock_guard lock(m_mutex);
            m_ended.emplace_back(point, ended.what());
        }
    }

    /// What has happened since the last time.
    void tell()
    {
        const std::lock_guard lock(m_mutex);
        for (const auto& [point, result] : std::exchange(m_finished, {}))
            m_progress.finished(point, result);
        for (const auto& [point, sentence] : std::exchange(m_ended, {})) {
            m_progress.lost(sentence);
            m_lost.emplace(point, sentence);
        }
        m_progress.show(std::to_string(m_running) + " at a time");
    }

    const SweepFolder& m_folder;
    const SweepPlan& m_plan;
    const std::vector<std::size_t>& m_points;
    SweepProgress& m_progress;
    LostPoints m_lost;
    std::atomic<std::size_t> m_next{0};
    std::atomic<unsigned> m_running{0};
    std::atomic<bool> m_isStopped{false};

    std::mutex m_mutex; ///< of what is below
    std::vector<std::pair<std::size_t, PointResult>> m_finished;
    std::vector<std::pair<std::size_t, std::string>> m_ended;
    std::exception_ptr m_failure;
};

/// One per core, unless said otherwise; never more than there are points.
unsigned jobsFor(const LocalOptions& options, std::size_t points)
{
    const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
    const unsigned wanted = options.jobs > 0 ? options.jobs : std::max(1U, cores / options.threads);
    return static_cast<unsigned>(std::min<std::size_t>(wanted, points));
}

} // namespace

LostPoints runLocally(const SweepFolder& folder, const SweepPlan& plan, const std::vector<std::size_t>& points,
                      const LocalOptions& options, SweepProgress& progress)
{
    return LocalRuns(folder, plan, points, progress).run(jobsFor(options, points.size()), options.threads);
}

} // namespace knead
