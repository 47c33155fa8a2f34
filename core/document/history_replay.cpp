#include "core/document/history_replay.h"

#include "core/document/moment_hash.h"
#include "core/message/message.h"
#include "core/simulation/moment.h"
#include "core/simulation/replay.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

namespace knead {

namespace {

std::vector<HistoryRecord> recordsOf(const Project& project, HistoryReplay::From from)
{
    if (project.entries.empty() || project.starts.empty())
        throw Problem(
            Message("History", "The project has no history: nothing was done in it yet that could be repeated."));
    std::vector<HistoryRecord> records = project.entries;
    for (HistoryRecord& record : records) {
        if (record.start >= project.starts.size())
            throw Problem(
                Message("History", "The history is damaged: an entry begins with a start that is not there."));
        if (from == HistoryReplay::From::starts)
            record.moment = nullptr;
    }
    return records;
}

std::uint64_t stepsOf(std::uint64_t reached, const HistoryRecord& record)
{
    std::uint64_t steps = 0;
    for (const RecordedCommand& recorded : record.commands) {
        steps += recorded.step - std::min(reached, recorded.step);
        reached = std::holds_alternative<Reset>(recorded.command) ? 0 : recorded.step;
    }
    return steps + record.step - std::min(reached, record.step);
}

} // namespace

HistoryReplay::HistoryReplay(const Project& project, From from, Packing packing)
    : m_project(project)
    , m_history(recordsOf(project, from), project.current, std::numeric_limits<std::size_t>::max())
    , m_packing(std::move(packing))
    , m_parts(toolPartsOf(project))
{
}

HistoryReplay::~HistoryReplay() = default;

/// Whether what follows an entry goes on from a moment, and not from a state that was only passed.
bool HistoryReplay::continuesAt(History::Entry entry) const
{
    const HistoryRecord& record = m_history.record(entry);
    return !record.commands.empty() && record.commands.back().step == record.step &&
           std::holds_alternative<KeepMoment>(record.commands.back().command);
}

/// Makes a simulation at the beginning of a way. @return the commands from there on
std::vector<RecordedCommand> HistoryReplay::goToWay(const Way& way)
{
    const Scene& scene = m_project.starts[way.start].scene;
    m_simulation.emplace(scene);
    if (MomentPointer begin = beginOf(way, scene, m_packing))
        m_simulation->goTo(std::move(begin));
    return way.commands;
}

/// The same, from the simulation at hand or from a branch where one of them leads there.
std::vector<RecordedCommand> HistoryReplay::goToBegin(History::Entry entry)
{
    const HistoryRecord& record = m_history.record(entry);
    if (m_history.beginsStart(entry) || record.moment)
        return goToWay(m_history.wayTo(entry));
    if (m_simulation && m_at == record.parent)
        return record.commands;
    const auto branch = m_branches.find(record.parent);
    if (branch == m_branches.end())
        return goToWay(m_history.wayTo(entry));
    m_simulation.emplace(m_project.starts[record.start].scene);
    m_simulation->goTo(branch->second);
    return record.commands;
}

void HistoryReplay::remember(History::Entry entry, const std::set<History::Entry>& next)
{
    const auto isWanted = [&](History::Entry other) {
        return other > entry + 1 && m_history.record(other).parent == entry && !m_history.beginsStart(other);
    };
    if (continuesAt(entry) && std::ranges::any_of(next, isWanted))
        m_branches[entry] = m_simulation->keepMoment();
}

/// A moment that cannot be read is another one.
RepeatedEntry::Whole HistoryReplay::compareWhole(History::Entry entry)
{
    using Whole = RepeatedEntry::Whole;
    const HistoryRecord& record = m_project.entries[entry];
    if (!record.moment || !continuesAt(entry))
        return Whole::notKept;
    const std::vector<Body>& bodies = m_project.starts[record.start].scene.bodies;
    try {
        Moment kept = momentFromBytes(*record.moment, bodies, m_parts, m_packing);
        return momentHash(std::move(kept)) == momentHash(*m_simulation->keepMoment()) ? Whole::same : Whole::different;
    } catch (const std::runtime_error&) {
        return Whole::different;
    }
}

RepeatedEntry HistoryReplay::repeat(History::Entry entry, TaskControl& control, const std::set<History::Entry>& next)
{
    const HistoryRecord& record = m_history.record(entry);
    RepeatedEntry result{.entry = entry};
    try {
        if (m_lost.contains(record.parent) && !m_history.beginsStart(entry) && !record.moment)
            throw Problem(Message("History", "The entry before it was not reached."));
        const std::vector<RecordedCommand> commands = goToBegin(entry);
        Simulation from = std::move(*m_simulation);
        m_simulation.reset();
        m_simulation.emplace(replay(std::move(from), commands, record.step, control));
    } catch (const Cancelled&) {
        throw;
    } catch (const std::runtime_error& error) {
        m_simulation.reset();
        m_lost.insert(entry);
        result.trouble = messageOf(error);
        return result;
    }
    m_at = entry;
    result.step = m_simulation->stepCount();
    result.hash = m_simulation->stateHash();
    result.whole = compareWhole(entry);
    result.isSame =
        result.step == record.step && result.hash == record.hash && result.whole != RepeatedEntry::Whole::different;
    remember(entry, next);
    return result;
}

std::shared_ptr<const Snapshot> HistoryReplay::snapshot()
{
    return m_simulation ? m_simulation->snapshot() : nullptr;
}

std::uint64_t HistoryReplay::ownSteps(History::Entry entry) const
{
    const HistoryRecord& record = m_history.record(entry);
    return stepsOf(m_history.beginsStart(entry) ? 0 : m_history.record(record.parent).step, record);
}

} // namespace knead
