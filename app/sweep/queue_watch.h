#pragma once

#include "app/sweep/slurm_commands.h"

#include <chrono>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace knead {

/// Which of the points that have no result yet wait or run in Slurm, who serves many and is asked now and then.
class QueueWatch {
public:
    explicit QueueWatch(std::string jobName)
        : m_jobName(std::move(jobName))
    {
    }

    /// Asks at once. @throws std::runtime_error, in a sentence, when there is no Slurm here
    void ask(const std::vector<SlurmJob>& jobs, const std::set<std::size_t>& missing);
    /// Asks when the last answer is some seconds old.
    void askNowAndThen(const std::vector<SlurmJob>& jobs, const std::set<std::size_t>& missing);

    /// Takes points for queued until the next answer: they were just submitted.
    void begin(const std::set<std::size_t>& points);
    /// A result has come.
    void finished(std::size_t point) { m_queued.erase(point); }

    const std::set<std::size_t>& queued() const { return m_queued; }
    bool answers() const { return m_answers; } ///< whether Slurm did the last time

    /// Whether it left the queue so long ago that no result will come, on network file systems either.
    bool hasVanished(std::size_t point) const;

private:
    using Clock = std::chrono::steady_clock;

    std::string m_jobName;
    std::set<std::size_t> m_queued;
    std::map<std::size_t, Clock::time_point> m_gone; ///< since when a point without a result is not in the queue
    Clock::time_point m_nextQuestion{};
    bool m_answers = true;
};

} // namespace knead
