#include "core/document/mended_project.h"

#include "core/document/history.h"
#include "core/simulation/replay.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <utility>

namespace knead {

namespace {

/// Moments stay whatever they take.
History historyOf(const Project& project)
{
    return {project.entries, project.current, std::numeric_limits<std::size_t>::max()};
}

MomentPointer currentMoment(const History& history, const Project& project, const Packing& packing,
                            TaskControl& control)
{
    const Way way = history.wayTo(history.current());
    return follow(way, project.starts.at(way.start).scene, packing, control);
}

HistoryRecord repeated(const Project& project, const WorkState& state, const Packing& packing, TaskControl& control)
{
    const History history = historyOf(project);
    TaskPortion going(control, 0, 0.3);
    MomentPointer moment = currentMoment(history, project, packing, going);
    Simulation simulation(project.starts.at(history.record(project.current).start).scene);
    simulation.goTo(std::move(moment));
    TaskPortion repeating(control, 0.3, 1);
    simulation = replay(std::move(simulation), state.gesture, state.step, repeating);
    HistoryRecord record = recordOf(endGesture(simulation), Message("Project", "Recovered"), packing);
    record.parent = project.current;
    record.start = project.entries[project.current].start;
    record.wallTime = std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
    return record;
}

} // namespace

MendedProject withGesture(Project project, const WorkState& state, const Packing& packing, TaskControl& control)
{
    if ((state.gesture.empty() && state.step == 0) || project.entries.empty())
        return {std::move(project), {}};
    try {
        project.entries.push_back(repeated(project, state, packing, control));
        project.current = static_cast<std::uint32_t>(project.entries.size() - 1);
        return {std::move(project), {}};
    } catch (const Cancelled&) {
        throw;
    } catch (const std::exception&) {
        return {std::move(project), {Message("Project", "what was done last")}};
    }
}

MendedProject withReachableEntry(Project project, const Packing& packing, TaskControl& control)
{
    std::vector<Message> missing;
    while (!project.entries.empty())
        try {
            const MomentPointer moment = currentMoment(historyOf(project), project, packing, control);
            if (auto& kept = project.entries[project.current].moment; kept == nullptr) // nobody shall look for it again
                kept = std::make_shared<const Bytes>(momentToBytes(*moment, packing));
            return {std::move(project), std::move(missing)};
        } catch (const Cancelled&) {
            throw;
        } catch (const std::exception&) {
            const HistoryRecord& record =
                project.entries[std::min<std::size_t>(project.current, project.entries.size() - 1)];
            missing.push_back(Message("Project", "the state after \"%1\"").with(record.label()));
            if (project.current == 0)
                break;
            project.current = record.parent;
        }
    project.entries.clear();
    project.starts.clear();
    project.current = 0;
    return {std::move(project), std::move(missing)};
}

} // namespace knead
