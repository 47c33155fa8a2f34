#pragma once

#include "core/task/task_control.h"

#include <chrono>
#include <cstddef>
#include <string>

namespace knead {

/// Shows the progress of a command as one line on stderr when that is a terminal, and is cancelled by Ctrl+C. One at a
/// time: it owns the process's handling of SIGINT and SIGTERM while it lives. A second signal ends the process at once.
class TerminalControl final : public TaskControl {
public:
    TerminalControl();
    ~TerminalControl() override;
    TerminalControl(const TerminalControl&) = delete;
    TerminalControl& operator=(const TerminalControl&) = delete;

    void report(double fraction, std::string_view stage) override;
    bool isCancelled() const override;

    void clear(); ///< takes the line away

    /// A line of its own above the progress, at once. Any thread.
    void say(const std::string& line) const;

private:
    using Clock = std::chrono::steady_clock;

    bool m_isTerminal;
    bool m_isShown = false;
    Clock::time_point m_next{}; ///< when the line may change again
};

} // namespace knead
