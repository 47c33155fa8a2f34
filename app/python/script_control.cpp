#include "app/python/script_control.h"

#include "app/python/bindings.h"

namespace py = pybind11;

namespace knead::python {

namespace {

constexpr std::chrono::milliseconds betweenLooks{20};
constexpr std::chrono::milliseconds betweenReports{100};

} // namespace

ScriptControl::ScriptControl(py::object progress)
    : m_progress(std::move(progress))
{
}

void ScriptControl::report(double fraction, std::string_view stage)
{
    if (m_progress.is_none() || !isOfScript() || m_isStopped || Clock::now() < m_nextReport)
        return;
    m_nextReport = Clock::now() + betweenReports;
    const py::gil_scoped_acquire locked;
    try {
        m_progress(fraction, readable(stage));
    } catch (const py::error_already_set&) {
        stop();
    }
}

bool ScriptControl::isCancelled() const
{
    if (m_isStopped || !isOfScript() || Clock::now() < m_nextLook)
        return m_isStopped;
    m_nextLook = Clock::now() + betweenLooks;
    const py::gil_scoped_acquire locked;
    if (PyErr_CheckSignals() != 0) {
        try {
            throw py::error_already_set();
        } catch (const py::error_already_set&) {
            stop();
        }
    }
    return m_isStopped;
}

void ScriptControl::stop() const
{
    m_cause = std::current_exception();
    m_isStopped = true;
}

void ScriptControl::throwCause() const
{
    if (m_cause)
        std::rethrow_exception(m_cause);
}

} // namespace knead::python
