#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>

namespace knead {

/// How far a run has come.
struct RunProgress {
    double simulated = 0; ///< [s]
    double step = 0;      ///< of the integrator [s]
    double done = 0;      ///< share of the whole run, 0 .. 1
};

/// A sentence on a run that hardly goes on: what it did in a stretch of time, how long all of it would take, and what helps.
/// Empty when it keeps above a hundredth of real time, or is done within a minute anyway.
/// @param wall what passed between the two [s], > 0
std::string slownessOf(const RunProgress& before, const RunProgress& now, double wall);

/// Says once, when it is seen, that a run hardly goes on: within five seconds of the time it began, be the first step over
/// or not. It has a thread of its own for that.
class PaceWatch {
public:
    /// @param say called in the watch's thread
    explicit PaceWatch(std::function<void(const std::string& sentence)> say,
                       std::chrono::milliseconds stretch = std::chrono::seconds(4));

    void reached(const RunProgress& pace); ///< after each step

private:
    void watch(const std::stop_token& stop);

    std::function<void(const std::string&)> m_say;
    std::chrono::milliseconds m_stretch;
    std::mutex m_mutex;
    std::condition_variable_any m_wake;
    RunProgress m_pace;
    std::jthread m_thread; // last: stops before the rest goes
};

} // namespace knead
