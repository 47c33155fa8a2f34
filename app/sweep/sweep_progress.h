#pragma once

#include "app/sweep/sweep_folder.h"
#include "app/terminal_control.h"

#include <chrono>
#include <cstddef>
#include <string>

namespace knead {

/// How far a sweep is, on stderr: a bar on a terminal, a line now and then elsewhere, and a line for each point that failed.
/// On one thread.
class SweepProgress {
public:
    /// @param done points that are finished already
    SweepProgress(TerminalControl& control, std::size_t points, std::size_t done);

    TaskControl& control() { return m_control; }
    std::size_t done() const { return m_done; }

    void finished(std::size_t point, const PointResult& result);
    void lost(const std::string& sentence);

    /// @param note what else there is to say, for example "2 running"
    void show(const std::string& note);

private:
    using Clock = std::chrono::steady_clock;

    void complain(const std::string& sentence);

    TerminalControl& m_control;
    std::size_t m_points;
    std::size_t m_done;
    std::size_t m_failed = 0;
    bool m_isTerminal;
    Clock::time_point m_nextLine; ///< elsewhere than on a terminal
};

} // namespace knead
