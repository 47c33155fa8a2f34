#include "core/session/pace_watch.h"

#include <array>
#include <cstdio>
#include <utility>

namespace knead {

namespace {

constexpr double slowRatio = 0.01; // of simulated to wall time
constexpr double shortWait = 60;   // nobody needs to be told of it [s]

std::string inWords(double seconds)
{
    std::array<char, 64> text{};
    if (seconds < 120)
        std::snprintf(text.data(), text.size(), "%.0f s", seconds);
    else if (seconds < 7200)
        std::snprintf(text.data(), text.size(), "%.0f minutes", seconds / 60);
    else if (seconds < 172800)
        std::snprintf(text.data(), text.size(), "%.0f hours", seconds / 3600);
    else
        std::snprintf(text.data(), text.size(), "%.0f days", seconds / 86400);
    return text.data();
}

} // namespace

std::string slownessOf(const RunProgress& before, const RunProgress& now, double wall)
{
    const double simulated = now.simulated - before.simulated;
    const double share = now.done - before.done;
    const bool isSoonOver = share > 0 && (1 - now.done) / share * wall < shortWait;
    if (simulated >= slowRatio * wall || isSoonOver)
        return {};
    std::array<char, 400> text{};
    const std::string whole =
        share > 0 ? "the rest of the run would take " + inWords((1 - now.done) / share * wall) : "it may not end";
    std::snprintf(
        text.data(), text.size(),
        "The run hardly goes on: %.2g s were simulated in %.0f s, in steps of %.2g s; %s. A larger spacing, a "
        "softer material, slower tools or ones that begin outside the material make it faster. Ctrl+C ends it.",
        simulated, wall, now.step, whole.c_str());
    return text.data();
}

PaceWatch::PaceWatch(std::function<void(const std::string&)> say, std::chrono::milliseconds stretch)
    : m_say(std::move(say))
    , m_stretch(stretch)
    , m_thread([this](const std::stop_token& stop) { watch(stop); })
{
}

void PaceWatch::reached(const RunProgress& pace)
{
    const std::lock_guard lock(m_mutex);
    m_pace = pace;
}

void PaceWatch::watch(const std::stop_token& stop)
{
    RunProgress before;
    for (;;) {
        RunProgress now;
        {
            std::unique_lock lock(m_mutex);
            m_wake.wait_for(lock, stop, m_stretch, [] { return false; });
            now = m_pace;
        }
        if (stop.stop_requested())
            return;
        const std::string sentence = slownessOf(before, now, std::chrono::duration<double>(m_stretch).count());
        if (!sentence.empty())
            return m_say(sentence);
        before = now;
    }
}

} // namespace knead
