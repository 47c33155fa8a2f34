#include "io/trace/python_trace.h"

#include "core/document/history.h"
#include "core/message/message.h"
#include "io/trace/trace_calls.h"
#include "io/trace/trace_start.h"

#include <limits>
#include <utility>

namespace knead {

namespace {

constexpr std::size_t leastRows = 3; // in a row that make a table

std::string lineOf(const TraceCall& call)
{
    return (call.result.empty() ? "" : call.result + " = ") + call.action + '(' + call.arguments + ')';
}

std::string stepLine(std::uint64_t step)
{
    return "sim.step_to(" + std::to_string(step) + ")\n";
}

class PythonTrace final : public SessionTrace {
public:
    PythonTrace(std::shared_ptr<const TraceStart> start, const Project& project)
        : m_calls(beginning(start, project))
    {
        for (const Fixture& fixture : start->start.scene.fixtures)
            write({0, AddFixture{fixture}});
        for (const Manipulator& tool : start->start.scene.manipulators)
            write({0, AddManipulator{tool}});
        for (const Load& load : start->start.scene.loads)
            write({0, AddLoad{load}});
    }

    std::unique_ptr<SessionTrace> copy() const override
    {
        auto other = std::make_unique<PythonTrace>(*this);
        other->m_text.clear();
        return other;
    }

    void add(std::span<const RecordedCommand> commands, const std::string& name) override
    {
        for (const RecordedCommand& recorded : commands)
            write(recorded);
        if (name.empty())
            return;
        endRows();
        if (!m_text.empty()) {
            m_text.pop_back();
            m_text += "  ";
        }
        m_text += python_text::comment(name) + "\n\n";
    }

    std::string take() override { return std::exchange(m_text, {}); }

    std::string ending(std::uint64_t step) const override
    {
        PythonTrace other = *this;
        other.m_text.clear();
        other.endRows();
        return other.m_text + (step > other.m_step ? stepLine(step) : "");
    }

private:
    /// A call that may become a row of a table.
    struct Row {
        std::uint64_t step;
        TraceCall call;
    };

    TraceCalls beginning(const std::shared_ptr<const TraceStart>& start, const Project& project)
    {
        python_text::Names names;
        m_text = traceBeginning(project, *start, names);
        return TraceCalls(start, std::move(names));
    }

    void write(const RecordedCommand& recorded)
    {
        TraceCall call = m_calls.of(recorded);
        if (call.isOfMany && call.before.empty()) {
            addRow({recorded.step, std::move(call)});
            return;
        }
        endRows();
        m_text += call.before;
        writeLine(recorded.step, call);
        if (std::holds_alternative<Reset>(recorded.command))
            m_step = 0;
        if (std::holds_alternative<FindBalance>(recorded.command))
            ++m_step; // it counts as one
    }

    void writeLine(std::uint64_t step, const TraceCall& call)
    {
        goTo(step);
        m_text += lineOf(call) + '\n';
    }

    void goTo(std::uint64_t step)
    {
        if (step > m_step)
            m_text += stepLine(step);
        m_step = step;
    }

    void addRow(Row row)
    {
        if (m_isTable) {
            writeRow(row);
            return;
        }
        m_rows.push_back(std::move(row));
        if (m_rows.size() < leastRows)
            return;
        m_isTable = true;
        m_text += "for step, act, *how in [\n";
        for (const Row& waiting : std::exchange(m_rows, {}))
            writeRow(waiting);
    }

    void writeRow(const Row& row)
    {
        m_text += "    (" + std::to_string(row.step) + ", " + row.call.action +
                  (row.call.arguments.empty() ? "" : ", " + row.call.arguments) + "),\n";
        m_step = row.step;
    }

    void endRows()
    {
        if (std::exchange(m_isTable, false))
            m_text += "]:\n    sim.step_to(step)\n    act(*how)\n";
        for (const Row& row : std::exchange(m_rows, {}))
            writeLine(row.step, row.call);
    }

    std::string m_text; // first: what comes next writes into it
    TraceCalls m_calls;
    std::uint64_t m_step = 0;
    std::vector<Row> m_rows; ///< too few for a table yet
    bool m_isTable = false;  ///< one was begun
};

} // namespace

std::unique_ptr<SessionTrace> pythonTrace(const Project& project, std::uint32_t start,
                                          const PythonTraceChoices& choices)
{
    const ProjectStart& from = project.starts.at(start);
    if (from.scene.bodies.empty() || modelOf(project, from) == nullptr)
        throw Problem(Message("Trace", "The project has no bodies that a script could fill."));
    auto ready =
        std::make_shared<const TraceStart>(TraceStart{modelOf(project, from), from, toolPartsOf(project), choices});
    return std::make_unique<PythonTrace>(std::move(ready), project);
}

std::string pythonTraceOf(const Project& project, std::uint32_t entry, const PythonTraceChoices& choices)
{
    if (project.entries.empty() || project.starts.empty())
        throw Problem(Message("Trace", "Nothing was done in the project yet that a script could say."));
    const History history(project.entries, project.current, std::numeric_limits<std::size_t>::max());
    const HistoryRecord& last = history.record(entry);
    const std::unique_ptr<SessionTrace> trace = pythonTrace(project, last.start, choices);
    for (const History::Entry step : history.pathFromStart(entry))
        trace->add(history.record(step).commands, history.record(step).name);
    return trace->take() + trace->ending(last.step);
}

} // namespace knead
