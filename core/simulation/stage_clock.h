#pragma once

#include "core/simulation/snapshot.h"

#include <chrono>
#include <cstdint>
#include <numeric>

namespace knead {

/// Finds what the stages of a step cost. Reading the clock takes as long as a stage of a small scene, so where steps are short
/// it is done in some of them only, at an interval that no periodic work has.
class StageClock {
public:
    void begin(std::uint64_t step)
    {
        constexpr std::uint64_t interval = 7;
        constexpr double longStep = 2e-5; // [s]
        const double last = std::accumulate(m_lastStep.begin(), m_lastStep.end(), 0.0);
        m_measures = last > longStep || step % interval == 0 || m_steps == 0;
        if (!m_measures)
            return;
        ++m_steps;
        m_lastStep.fill(0);
        m_last = Clock::now();
    }

    /// What has passed since the end of the stage before was `stage`.
    void end(Stage stage)
    {
        if (!m_measures)
            return;
        const Clock::time_point now = Clock::now();
        const double seconds = std::chrono::duration<double>(now - m_last).count();
        m_seconds[static_cast<std::size_t>(stage)] += seconds;
        m_lastStep[static_cast<std::size_t>(stage)] += seconds;
        m_last = now;
    }

    /// Mean per step since the last call [s]; what it was then without a step since.
    StageSeconds take()
    {
        if (m_steps > 0) {
            for (std::size_t stage = 0; stage < stageCount; ++stage)
                m_mean[stage] = m_seconds[stage] / static_cast<double>(m_steps);
            m_seconds.fill(0);
            m_steps = 0;
        }
        return m_mean;
    }

private:
    using Clock = std::chrono::steady_clock;

    bool m_measures = false;
    std::uint64_t m_steps = 0;
    Clock::time_point m_last;
    StageSeconds m_seconds{};
    StageSeconds m_lastStep{};
    StageSeconds m_mean{};
};

} // namespace knead
