#include "app/terminal_control.h"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <string>

#include <unistd.h>

namespace knead {

namespace {

constexpr std::chrono::milliseconds interval{100};
constexpr int barWidth = 24;

volatile std::sig_atomic_t isInterrupted = 0;

void handleSignal(int)
{
    isInterrupted = 1;
}

void install(int signal)
{
    struct sigaction action {};
    action.sa_handler = handleSignal;
    action.sa_flags = static_cast<int>(SA_RESETHAND); // the second one takes the default way: ends the process
    sigemptyset(&action.sa_mask);
    sigaction(signal, &action, nullptr);
}

} // namespace

TerminalControl::TerminalControl()
    : m_isTerminal(isatty(STDERR_FILENO) != 0)
{
    isInterrupted = 0;
    install(SIGINT);
    install(SIGTERM);
}

TerminalControl::~TerminalControl()
{
    clear();
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
}

void TerminalControl::report(double fraction, std::string_view stage)
{
    if (!m_isTerminal || Clock::now() < m_next)
        return;
    m_next = Clock::now() + interval;
    m_isShown = true;
    const double done = std::clamp(fraction, 0.0, 1.0);
    const auto filled = static_cast<std::size_t>(std::lround(done * barWidth));
    const std::string bar = std::string(filled, '#') + std::string(barWidth - filled, '.');
    std::fprintf(stderr, "\r[%s] %3.0f%% %.*s\x1b[K", bar.c_str(), 100 * done, static_cast<int>(stage.size()),
                 stage.data());
    std::fflush(stderr);
}

bool TerminalControl::isCancelled() const
{
    return isInterrupted != 0;
}

void TerminalControl::say(const std::string& line) const
{
    const std::string whole = (m_isTerminal ? "\r\x1b[K" : "") + line + "\n";
    std::fputs(whole.c_str(), stderr); // in one go, so that no progress comes between
    std::fflush(stderr);
}

void TerminalControl::clear()
{
    if (m_isShown)
        std::fputs("\r\x1b[K", stderr);
    m_isShown = false;
}

} // namespace knead
