#pragma once

#include "core/task/task_control.h"

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <exception>
#include <string_view>
#include <thread>
#include <utility>

namespace knead::python {

/// A computation that a script waits for: it tells its progress to a function of the script, and Ctrl+C stops it. It is made and gone
/// with the interpreter's lock held, which is given back while it computes. Python's own handlers of signals are asked, on the thread
/// that waits, some fifty times a second.
class ScriptControl final : public TaskControl {
public:
    /// @param progress called with the share that is done, 0 .. 1, and what is done now, some ten times a second; None: nobody asks
    explicit ScriptControl(pybind11::object progress);

    void report(double fraction, std::string_view stage) override;
    bool isCancelled() const override;

    /// After Cancelled, with the lock held: throws what stopped it as Python knows it, KeyboardInterrupt for one. Returns when
    /// nothing of Python did.
    void throwCause() const;

private:
    using Clock = std::chrono::steady_clock;

    bool isOfScript() const { return std::this_thread::get_id() == m_thread; }
    void stop() const; ///< for the error that is under way; with the lock held

    pybind11::object m_progress;
    std::thread::id m_thread = std::this_thread::get_id();
    Clock::time_point m_nextReport{};
    mutable Clock::time_point m_nextLook{};
    mutable std::atomic<bool> m_isStopped{false};
    mutable std::exception_ptr m_cause; ///< a pybind11::error_already_set
};

/// Computes without the interpreter's lock.
/// @param work called with a TaskControl
template <typename Work>
auto computing(pybind11::object progress, Work&& work)
{
    ScriptControl control(std::move(progress));
    try {
        pybind11::gil_scoped_release released;
        return work(static_cast<TaskControl&>(control));
    } catch (const Cancelled&) {
        control.throwCause();
        throw;
    }
}

} // namespace knead::python
