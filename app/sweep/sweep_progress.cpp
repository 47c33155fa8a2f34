#include "app/sweep/sweep_progress.h"

#include "app/exit_status.h"

#include <iostream>

#include <unistd.h>

namespace knead {

namespace {

constexpr std::chrono::seconds lineInterval{10};

} // namespace

SweepProgress::SweepProgress(TerminalControl& control, std::size_t points, std::size_t done)
    : m_control(control)
    , m_points(points)
    , m_done(done)
    , m_isTerminal(isatty(STDERR_FILENO) != 0)
    , m_nextLine(Clock::now() + lineInterval)
{
}

void SweepProgress::finished(std::size_t point, const PointResult& result)
{
    ++m_done;
    if (result.status != exit_status::done) {
        ++m_failed;
        complain("point " + std::to_string(point) + " failed: " + result.message);
    }
}

void SweepProgress::lost(const std::string& sentence)
{
    ++m_failed;
    complain(sentence);
}

void SweepProgress::show(const std::string& note)
{
    std::string stage = std::to_string(m_done) + " of " + std::to_string(m_points) + " points";
    if (m_failed > 0)
        stage += ", " + std::to_string(m_failed) + " failed";
    stage += ", " + note;
    m_control.report(static_cast<double>(m_done) / static_cast<double>(m_points), stage);
    if (!m_isTerminal && Clock::now() >= m_nextLine) {
        std::cerr << "knead: " << stage << '\n';
        m_nextLine = Clock::now() + lineInterval;
    }
}

void SweepProgress::complain(const std::string& sentence)
{
    m_control.clear();
    std::cerr << "knead: " << sentence << '\n';
}

} // namespace knead
