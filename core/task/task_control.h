#pragma once

#include <cstddef>
#include <stdexcept>
#include <string_view>

namespace knead {

/// How a long computation tells its progress and learns that it should stop. Called on the computing thread.
class TaskControl {
public:
    virtual ~TaskControl() = default;

    /// `fraction` in 0..1 over the whole task, `stage` a short phrase such as "reading the file",
    /// which the window says in its language where it is one of words_of_core.cpp.
    virtual void report(double fraction, std::string_view stage) = 0;
    virtual bool isCancelled() const = 0; ///< any thread

    /// @throws Cancelled when the person asked to stop.
    void throwIfCancelled() const;

    /// A control that reports nowhere and is never cancelled.
    static TaskControl& none();
};

/// Thrown by a computation that was asked to stop; nothing has changed.
struct Cancelled : std::runtime_error {
    Cancelled()
        : std::runtime_error{"cancelled"}
    {
    }
};

/// A child task that covers the part [begin, end] of its parent's progress.
class TaskPortion final : public TaskControl {
public:
    TaskPortion(TaskControl& parent, double begin, double end)
        : m_parent(parent)
        , m_begin(begin)
        , m_end(end)
    {
    }

    /// Of so many items that take about as long, the part of one of them, numbered from 0.
    static TaskPortion ofItem(TaskControl& parent, std::size_t item, std::size_t count)
    {
        const auto done = static_cast<double>(item);
        const auto all = static_cast<double>(count);
        return {parent, done / all, (done + 1) / all};
    }

    void report(double fraction, std::string_view stage) override
    {
        m_parent.report(m_begin + fraction * (m_end - m_begin), stage);
    }
    bool isCancelled() const override { return m_parent.isCancelled(); }

private:
    TaskControl& m_parent;
    double m_begin;
    double m_end;
};

} // namespace knead
