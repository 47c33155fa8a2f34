#include "app/sweep/queue_watch.h"

#include <optional>

namespace knead {

namespace {

constexpr std::chrono::seconds queueInterval{5}; // between questions to Slurm
constexpr std::chrono::seconds lateness{10};     // of files of a task that has ended, on network file systems

} // namespace

void QueueWatch::ask(const std::vector<SlurmJob>& jobs, const std::set<std::size_t>& missing)
{
    const std::optional<std::set<std::size_t>> queued = queuedPoints(jobs, m_jobName);
    m_answers = queued.has_value();
    m_nextQuestion = Clock::now() + queueInterval;
    if (!queued)
        return;
    m_queued = *queued;
    for (const std::size_t point : missing)
        if (m_queued.contains(point))
            m_gone.erase(point);
        else
            m_gone.try_emplace(point, Clock::now());
}

void QueueWatch::askNowAndThen(const std::vector<SlurmJob>& jobs, const std::set<std::size_t>& missing)
{
    if (Clock::now() >= m_nextQuestion)
        ask(jobs, missing);
}

void QueueWatch::begin(const std::set<std::size_t>& points)
{
    m_queued = points;
    m_gone.clear();
    m_nextQuestion = Clock::now() + queueInterval;
}

bool QueueWatch::hasVanished(std::size_t point) const
{
    const auto found = m_gone.find(point);
    return found != m_gone.end() && Clock::now() > found->second + lateness;
}

} // namespace knead
